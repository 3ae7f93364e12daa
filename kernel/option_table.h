// A table of options: each is described once, and check, readers, flags, reports and pages follow.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <functional>
#include <type_traits>
#include <utility>

#include "kernel/errors.h"
#include "kernel/option.h"
#include "kernel/triangles.h"

namespace suture {

namespace option_values {

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

template <class T>
constexpr OptionType type_of() {
  if constexpr (is_optional<T>) return type_of<typename T::value_type>();
  if constexpr (std::same_as<T, bool>) return OptionType::flag;
  if constexpr (std::integral<T>) return OptionType::integer;
  if constexpr (std::same_as<T, Point>) return OptionType::point;
  if constexpr (std::same_as<T, std::vector<double>>) return OptionType::list;
  if constexpr (std::same_as<T, std::string>) return OptionType::text;
  return OptionType::number;
}

/// The number that a value is, given with a fraction or without.
inline double number_in(const Value& value) {
  const auto* whole = std::get_if<std::int64_t>(&value);
  return whole != nullptr ? static_cast<double>(*whole) : std::get<double>(value);
}

template <class T>
std::optional<Value> read(const T& member) {
  if constexpr (is_optional<T>)
    return member ? read(*member) : std::nullopt;
  else if constexpr (std::same_as<T, Point>)
    return std::vector<double>(member.data(), member.data() + 3);
  else if constexpr (std::integral<T> && !std::same_as<T, bool>)
    return static_cast<std::int64_t>(member);
  else
    return Value(member);
}

template <class T>
void write(T& member, const Value& value) {
  if constexpr (is_optional<T>)
    write(member.emplace(), value);
  else if constexpr (std::same_as<T, Point>)
    member = Eigen::Map<const Point>(std::get<std::vector<double>>(value).data());
  else if constexpr (std::integral<T> && !std::same_as<T, bool>)
    member = static_cast<T>(std::get<std::int64_t>(value));
  else if constexpr (std::same_as<T, double>)
    member = number_in(value);
  else
    member = std::get<T>(value);
}

}  // namespace option_values

/// How to read and write one option of an Options struct. `member` is a pointer to the field, or a
/// function from the struct to a reference to it. Fields are bool, integers, double, Point,
/// std::string, std::vector<double>, enumerations with names, and std::optional of the first three.
template <class Options>
class OptionField {
 public:
  template <class Member>
  requires std::invocable<Member, Options&> OptionField(Member member)
      : type(option_values::type_of<Type<Member>>()) {
    get = [member](const Options& o) { return option_values::read(std::invoke(member, o)); };
    set = [member](Options& o, const Value& value) {
      option_values::write(std::invoke(member, o), value);
    };
    if constexpr (std::integral<Type<Member>> && sizeof(Type<Member>) < sizeof(std::int64_t))
      most = Range::between(static_cast<double>(std::numeric_limits<Type<Member>>::min()),
                            static_cast<double>(std::numeric_limits<Type<Member>>::max()));
  }

  template <class Member, class T, std::size_t N>
  OptionField(Member member, const std::array<Named<T>, N>& names) : type(OptionType::choice) {
    for (const Named<T>& named : names) choices.emplace_back(named.name);
    get = [member, names](const Options& o) -> std::optional<Value> {
      for (const Named<T>& named : names)
        if (named.value == std::invoke(member, o)) return std::string(named.name);
      return std::string();
    };
    set = [member, names](Options& o, const Value& value) {
      for (const Named<T>& named : names)
        if (named.name == std::get<std::string>(value)) std::invoke(member, o) = named.value;
    };
  }

  /// A text that is one of `words`.
  template <class Member>
  OptionField(Member member, std::vector<std::string> words) : OptionField(member) {
    type = OptionType::choice;
    choices = std::move(words);
  }

  OptionType type;
  std::vector<std::string> choices{};
  Range most{};                                             ///< the range of the field's own type
  std::function<std::optional<Value>(const Options&)> get;  ///< nothing where none is set
  std::function<void(Options&, const Value&)> set;          ///< \pre the option allows the value

 private:
  template <class Member>
  using Type = std::remove_cvref_t<std::invoke_result_t<Member, Options&>>;
};

/// The options of one struct, in the order in which files and reports have them. The defaults are
/// those of `Options{}`.
template <class Options>
class OptionTable {
 public:
  struct Row {
    std::string name;
    OptionField<Options> field;
    OptionInfo about{};
  };

  /// `name` is the table's own, as in "tracker".
  OptionTable(std::string name, std::vector<Row> rows)
      : name_(std::move(name)), rows_(std::move(rows)) {
    const Options usual{};
    for (Row& row : rows_) {
      OptionInfo& about = row.about;
      about.name = row.name;
      about.type = row.field.type;
      about.choices = row.field.choices;
      about.range.low = std::max(about.range.low, row.field.most.low);
      about.range.high = std::min(about.range.high, row.field.most.high);
      if (!about.required) about.usual = row.field.get(usual);
    }
  }

  const std::string& name() const { return name_; }
  const std::vector<Row>& rows() const { return rows_; }

  /// \throw InvalidInput, with the nearest name, if there is no option called `name`
  const Row& row(const std::string& name) const {
    std::vector<std::string> known;
    for (const Row& row : rows_) {
      if (row.name == name) return row;
      known.push_back(row.name);
    }
    const std::string near = nearest_name(name, known);
    throw InvalidInput(name_ + ": there is no option \"" + name + "\"" +
                       (near.empty() ? "" : "; did you mean \"" + near + "\"?") + "; there are " +
                       joined(known));
  }

 private:
  std::string name_;
  std::vector<Row> rows_;
};

/// The description of each option, without its value.
template <class Options>
std::vector<OptionInfo> infos(const OptionTable<Options>& table) {
  std::vector<OptionInfo> all;
  for (const auto& row : table.rows()) all.push_back(row.about);
  return all;
}

/// The values of all options that have one, in the table's order.
template <class Options>
std::vector<std::pair<std::string, Value>> values(const Options& options,
                                                  const OptionTable<Options>& table) {
  std::vector<std::pair<std::string, Value>> all;
  for (const auto& row : table.rows())
    if (const std::optional<Value> value = row.field.get(options))
      all.emplace_back(row.name, *value);
  return all;
}

/// Sets the option called `name`. \throw InvalidInput if there is none, or it does not allow
/// `value`
template <class Options>
void set(Options& options, const OptionTable<Options>& table, const std::string& name,
         const Value& value) {
  const auto& row = table.row(name);
  if (const std::string wrong = objection(row.about, value); !wrong.empty())
    throw InvalidInput(table.name() + "." + name + " " + wrong);
  row.field.set(options, value);
}

/// \throw InvalidInput unless every option has a value that it allows. `where` comes before the
/// name, as in "quality."
template <class Options>
void check(const Options& options, const OptionTable<Options>& table, const std::string& where) {
  for (const auto& row : table.rows())
    if (const std::optional<Value> value = row.field.get(options))
      if (const std::string wrong = objection(row.about, *value); !wrong.empty())
        throw InvalidInput(where + row.name + " " + wrong);
}

/// Changes the unit of length: what is measured in length^n is multiplied by 2^(n·exponent).
template <class Options>
void scale_lengths(Options& options, const OptionTable<Options>& table, int exponent) {
  for (const auto& row : table.rows())
    if (const int power = row.about.unit.length; power != 0)
      if (const std::optional<Value> value = row.field.get(options))
        row.field.set(options, times_power(*value, power * exponent));
}

/// The field `inner` of the struct that is the field `outer` of an Options struct.
template <class Options, class Outer, class Inner>
auto inside(Outer Options::*outer, Inner Outer::*inner) {
  return [ outer, inner ](auto& options) -> auto& { return options.*outer.*inner; };
}

}  // namespace suture
