// suture measure: one method on one scene, and all that can be measured of it.
#include <fmt/format.h>

#include <algorithm>

#include "kernel/errors.h"
#include "sims/cli/changes.h"
#include "sims/cli/commands.h"
#include "sims/cli/inputs.h"
#include "sims/cli/progress_bar.h"
#include "sims/study/measurement.h"
#include "sims/study/table/table.h"

namespace suture::sims {
namespace {

struct Settings {
  MeasurementOptions measurement;
  ChangeOptions change;
  std::filesystem::path csv;
  bool afresh = false;
};

/// The command that makes these rows: what decides them, and not where they go.
std::string command_of(const Settings& s) {
  const MeasurementOptions& m = s.measurement;
  std::string text = "suture measure " + m.scene.generic_string();
  if (!s.change.method.empty()) text += " --method " + s.change.method;
  std::vector<std::string> changes = s.change.changes;
  std::sort(changes.begin(), changes.end());
  for (const std::string& change : changes) text += " --set " + change;
  if (!m.at.empty()) text += fmt::format(" --at {}", fmt::join(m.at, ","));
  if (!m.reference.empty()) text += " --reference " + m.reference;
  if (m.tolerance > 0) text += fmt::format(" --tolerance {}", m.tolerance);
  const CompareOptions usual;
  if (m.compare.samples != usual.samples) text += fmt::format(" --samples {}", m.compare.samples);
  if (m.compare.lines != usual.lines) text += fmt::format(" --lines {}", m.compare.lines);
  return text;
}

void print_rows(const std::vector<Row>& rows) {
  for (const Row& row : rows)
    for (const auto& [column, cell] : row.cells())
      if (const std::string text = cell_text(cell); !text.empty())
        fmt::print("{:<36}{}\n", column, text);
}

/// The rows that the table has of this command already.
std::vector<Row> made_before(const Settings& s, const std::string& command) {
  std::vector<Row> rows;
  if (s.afresh || s.csv.empty()) return rows;
  for (Row& row : read_table(s.csv).rows)
    if (row.text("command") == command) rows.push_back(std::move(row));
  return rows;
}

int exit_code(const std::vector<Row>& rows) {
  const bool sound = std::all_of(rows.begin(), rows.end(),
                                 [](const Row& row) { return row.text("outcome") == "done"; });
  return sound ? kDone : kNo;
}

int run_measure(Settings s) {
  MeasurementOptions& m = s.measurement;
  m.changes = read_changes(s.change);
  const std::string command = command_of(s);
  if (!s.csv.empty()) require_folder_of(s.csv);
  if (const std::vector<Row> old = made_before(s, command); !old.empty()) {
    fmt::print("{}: the rows of this command are there; --afresh makes them again\n",
               s.csv.string());
    return exit_code(old);
  }
  if (!m.surfaces.empty()) std::filesystem::create_directories(m.surfaces);
  if (m.name.empty())
    m.name = m.scene.stem().string() + (s.change.method.empty() ? "" : "." + s.change.method);
  std::vector<Row> rows;
  {
    ProgressBar bar;
    rows = measure(m, command, &bar);
  }
  if (!s.csv.empty()) append_rows(s.csv, rows, "command");
  print_rows(rows);
  return exit_code(rows);
}

void add_reference_options(CLI::App& command, MeasurementOptions& m) {
  command
      .add_option("--reference", m.reference,
                  "What is exact: exact, the shape itself carried by the flow; polyhedron, the "
                  "start mesh so carried; none; or a mesh file. Default: the scene's")
      ->type_name("KIND|FILE");
  command
      .add_option(
          "--tolerance", m.tolerance,
          "Of the reference's chords, a length; default: the scene's, or a thousandth of a cell")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--references", m.references, "Folder where references are kept for later runs")
      ->type_name("DIR");
  command.add_option("--samples", m.compare.samples, "On each surface, for distances")
      ->check(CLI::Range(100, 100000000));
  command
      .add_option("--lines", m.compare.lines,
                  "Along the longest side, for the symmetric difference")
      ->check(CLI::Range(4, 10000));
}

}  // namespace

void add_measure(CLI::App& app, int& exit) {
  auto s = std::make_shared<Settings>();
  MeasurementOptions& m = s->measurement;
  CLI::App* command =
      app.add_subcommand("measure", "Run a scene by a method and measure it against what is exact");
  command->add_option("scene", m.scene, "Scene file")->required()->type_name("SCENE.toml");
  add_change_options(*command, s->change);
  command->add_option("--at", m.at, "Times to measure at; default: the scene's, or its end")
      ->delimiter(',')
      ->type_name("T,T");
  command->add_option("--csv", s->csv, "Table to which the rows are added")->type_name("FILE");
  command->add_option("--surfaces", m.surfaces, "Folder for the measured surfaces")
      ->type_name("DIR");
  command->add_option("--name", m.name, "Of the surfaces' files; default: scene and method");
  command->add_flag("--afresh", s->afresh, "Make rows that the table has already once more");
  command->add_option("--limit-seconds", m.limit_seconds, "CPU seconds after which it has failed")
      ->check(CLI::Range(1.0, 1e9));
  add_reference_options(*command, m);
  command->callback([s, &exit] { exit = run_measure(*s); });
}

}  // namespace suture::sims
