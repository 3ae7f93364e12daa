// Stanford's PLY, as text or binary of either byte order, whatever else its elements carry.
#include <limits>

#include "kernel/formats/builder.h"
#include "kernel/formats/bytes.h"
#include "kernel/formats/formats.h"
#include "kernel/formats/ply_header.h"

namespace suture {

namespace {

// The name of one element for messages.
std::string nth(const PlyElement& element, std::int64_t i) {
  return in_quotes(element.name) + " " + std::to_string(i) + " of " + std::to_string(element.count);
}

// The values of a text body, in which an element is a line.
class TextValues {
 public:
  explicit TextValues(TextLines& text) : text_(text) {}
  void begin(const PlyElement& element, std::int64_t i) {
    if (!text_.next_line())
      throw text_.refusal("the file ends before " + nth(element, i),
                          "it is incomplete: fetch or export it again");
  }
  void end(const PlyElement& element, std::int64_t i) {
    if (const std::string_view more = text_.token(); !more.empty())
      throw text_.refusal(
          nth(element, i) + " has more values than the header says: " + in_quotes(more),
          "the file is damaged; export it again");
  }
  double number(PlyType type) {
    const double x = text_.number("a value");
    return type == PlyType::float32 ? static_cast<float>(x) : x;
  }
  std::int64_t integer(PlyType) { return text_.integer("a value"); }
  std::size_t line() const { return text_.line(); }
  void finish() {
    if (text_.next_line())
      throw text_.refusal("there is more after the last element: " + in_quotes(text_.token()),
                          "the counts in the header are wrong: export the mesh again");
  }

 private:
  TextLines& text_;
};

// The values of a binary body.
class BinaryValues {
 public:
  BinaryValues(std::string_view bytes, std::endian order, std::string file)
      : bytes_(bytes), order_(order), file_(std::move(file)) {}
  void begin(const PlyElement& element, std::int64_t i) {
    element_ = &element;
    index_ = i;
  }
  void end(const PlyElement&, std::int64_t) {}
  double number(PlyType type) {
    switch (type) {
      case PlyType::float32:
        return static_cast<double>(take<float>());
      case PlyType::float64:
        return take<double>();
      default:
        return static_cast<double>(integer(type));
    }
  }
  std::int64_t integer(PlyType type) {
    switch (type) {
      case PlyType::int8:
        return take<std::int8_t>();
      case PlyType::uint8:
        return take<std::uint8_t>();
      case PlyType::int16:
        return take<std::int16_t>();
      case PlyType::uint16:
        return take<std::uint16_t>();
      case PlyType::int32:
        return take<std::int32_t>();
      case PlyType::uint32:
        return take<std::uint32_t>();
      case PlyType::float32:
        take<float>();
        return 0;
      case PlyType::float64:
        take<double>();
        return 0;
    }
    return 0;
  }
  std::size_t line() const { return 0; }
  void finish() {
    if (!bytes_.empty())
      throw InvalidInput(file_ + ": there are " + std::to_string(bytes_.size()) +
                         " bytes after the last element; the counts in the header are wrong: "
                         "export the mesh again");
  }

 private:
  template <class T>
  T take() {
    if (bytes_.size() < sizeof(T))
      throw InvalidInput(file_ + ": the file ends within " + nth(*element_, index_) +
                         "; it is incomplete: fetch or export it again");
    const T x = load<T>(bytes_.data(), order_);
    bytes_.remove_prefix(sizeof(T));
    return x;
  }

  std::string_view bytes_;
  std::endian order_;
  std::string file_;
  const PlyElement* element_ = nullptr;
  std::int64_t index_ = 0;
};

// Reads the elements of a body, from values of either kind.
template <class Values>
class Body {
 public:
  Body(Values values, const std::string& file) : values_(values), file_(file), builder_(file) {}

  Triangles read(const PlyHeader& header) && {
    for (const PlyElement& element : header.elements) {
      if (element.properties.empty())
        continue;  // none of its values are stored, however many it has
      for (std::int64_t i = 0; i < element.count; ++i) {
        values_.begin(element, i);
        read_element(element, i);
        values_.end(element, i);
      }
    }
    values_.finish();
    return std::move(builder_).finish();
  }

 private:
  void read_element(const PlyElement& element, std::int64_t i) {
    element_ = &element;
    index_ = i;
    if (element.name == "vertex")
      read_vertex();
    else if (element.name == "face")
      read_face();
    else
      for (const PlyProperty& property : element.properties) skip(property);
  }

  void read_vertex() {
    Point p = Point::Zero();
    for (const PlyProperty& property : element_->properties)
      if (property.name == "x")
        p[0] = values_.number(property.type);
      else if (property.name == "y")
        p[1] = values_.number(property.type);
      else if (property.name == "z")
        p[2] = values_.number(property.type);
      else
        skip(property);
    builder_.add_position(p, values_.line());
  }

  void read_face() {
    std::vector<std::int64_t> corners;
    for (const PlyProperty& property : element_->properties) {
      if (property.name != "vertex_indices" && property.name != "vertex_index") {
        skip(property);
        continue;
      }
      const std::int64_t length = list_length(property);
      for (std::int64_t k = 0; k < length; ++k) corners.push_back(values_.integer(property.type));
    }
    builder_.add_face(corners, values_.line());
  }

  void skip(const PlyProperty& property) {
    const std::int64_t n = property.list ? list_length(property) : 1;
    for (std::int64_t k = 0; k < n; ++k) values_.number(property.type);
  }

  std::int64_t list_length(const PlyProperty& property) {
    const std::int64_t length = values_.integer(property.count_type);
    if (length < 0)
      throw InvalidInput(file_ + ": " + nth(*element_, index_) + " has a list of " +
                         std::to_string(length) + " values; the file is damaged: export it again");
    return length;
  }

  Values values_;
  const std::string& file_;
  SurfaceBuilder builder_;
  const PlyElement* element_ = nullptr;
  std::int64_t index_ = 0;
};

}  // namespace

Triangles parse_ply(std::string_view bytes, const std::string& file) {
  TextLines text(bytes, file, {});
  const PlyHeader header = read_ply_header(text);
  if (header.format == PlyFormat::ascii) return Body(TextValues(text), file).read(header);
  const auto order =
      header.format == PlyFormat::little_endian ? std::endian::little : std::endian::big;
  return Body(BinaryValues(text.rest(), order, file), file).read(header);
}

std::string format_ply(const Triangles& surface) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex ";
  append_integer(bytes, surface.positions.size());
  bytes += "\nproperty double x\nproperty double y\nproperty double z\nelement face ";
  append_integer(bytes, surface.triangles.size());
  bytes += "\nproperty list uchar uint vertex_indices\nend_header\n";
  for (const Point& p : surface.positions)
    for (const double x : p) append_little_endian(bytes, x);
  for (const Triangle& t : surface.triangles) {
    append_little_endian(bytes, std::uint8_t{3});
    for (const std::uint32_t v : t) append_little_endian(bytes, v);
  }
  return bytes;
}

}  // namespace suture
