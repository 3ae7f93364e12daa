// Values on the command line in place of a scene's own.
#include "sims/cli/changes.h"

#include "kernel/errors.h"

namespace suture::sims {
namespace {

/// A word of the command line as a scene file would have it: true, 3, 0.5, [1, 2], or text.
Value value_of(const std::string& text) {
  if (text == "true" || text == "false") return text == "true";
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (!text.empty() && *end == '\0') {
    const bool whole = text.find_first_not_of("+-0123456789") == std::string::npos;
    if (whole) return static_cast<std::int64_t>(std::strtoll(text.c_str(), nullptr, 10));
    return number;
  }
  if (text.size() < 2 || text.front() != '[' || text.back() != ']') return text;
  std::vector<double> list;
  for (const std::string& part : CLI::detail::split(text.substr(1, text.size() - 2), ',')) {
    list.push_back(std::strtod(part.c_str(), &end));
    if (part.empty() || *end != '\0') return text;  // which a key that wants a list refuses
  }
  return list;
}

}  // namespace

void add_change_options(CLI::App& command, ChangeOptions& options) {
  command
      .add_option("--method", options.method,
                  "Instead of the scene's: mesh, markers, level_set, ...")
      ->type_name("KIND");
  command.add_option("--set", options.changes, "Instead of what the scene has: table.key=value")
      ->type_name("T.K=V")
      ->allow_extra_args(false);
}

SceneChanges read_changes(const ChangeOptions& options) {
  SceneChanges changes;
  for (const std::string& change : options.changes) {
    const std::size_t equals = change.find('='), dot = change.find('.');
    if (equals == std::string::npos || dot == std::string::npos || dot > equals)
      throw InvalidInput("--set " + change + ": write table.key=value, as tracker.cell_size=0.02");
    changes[change.substr(0, equals)] = value_of(change.substr(equals + 1));
  }
  if (!options.method.empty()) changes["method.kind"] = options.method;
  return changes;
}

}  // namespace suture::sims
