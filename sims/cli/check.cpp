// suture check: is it a closed oriented manifold, and what is it like?
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "kernel/audit.h"
#include "kernel/measure/measures.h"
#include "kernel/measure/self_intersections.h"
#include "sims/cli/commands.h"
#include "sims/cli/inputs.h"
#include "sims/output/report_json.h"

namespace suture::sims {
namespace {

constexpr std::size_t kMostPairs = 1'000'000;  // beyond it nobody needs the number itself

struct Settings {
  Inputs inputs;
  bool json = false;
};

/// All that there is to say of one file.
struct Verdict {
  std::string file;
  bool empty = false;  ///< whether it has no triangle, and so is no surface
  Audit audit;
  nlohmann::json measures;  ///< null where the indices or coordinates allow no measure
};

bool passes(const Verdict& v) { return !v.empty && v.audit.closed_manifold(); }

bool measurable(const Audit& a) { return a.finite() && a.indices_out_of_range == 0; }

/// Pairs say nothing new if triangles repeat, and there can be very many of them.
bool countable(const Audit& a) { return a.duplicate_triangles == 0 && a.degenerate_triangles == 0; }

void count_pairs(const Triangles& surface, Verdict& verdict) {
  nlohmann::json& m = verdict.measures;
  m["self_intersecting_pairs"] = nullptr;
  m["triangles_without_area"] = nullptr;
  if (!countable(verdict.audit)) return;
  const SelfIntersections crossing = self_intersections(surface, {.most = kMostPairs});
  m["self_intersecting_pairs"] = crossing.pairs.size();
  m["self_intersecting_pairs_capped"] = crossing.capped;
  m["triangles_without_area"] = crossing.without_area;
}

Verdict judge(const std::string& file, const Inputs& inputs) {
  const Triangles surface = read_input(file, inputs);
  Verdict verdict{file, surface.triangles.empty(), audit(surface), nullptr};
  if (!measurable(verdict.audit)) return verdict;
  verdict.measures = measured(surface);
  count_pairs(surface, verdict);
  if (verdict.audit.closed_manifold()) {
    const auto parts = verdict.measures["components"].get<std::int64_t>();
    verdict.measures["genus"] = parts - verdict.measures["euler"].get<std::int64_t>() / 2;
  }
  return verdict;
}

std::string faults(std::size_t count, const char* what) {
  return count == 0 ? "yes" : fmt::format("no: {} {}", count, what);
}

void print_row(const char* name, const std::string& value) {
  fmt::print("  {:<26}{}\n", name, value);
}

void print_measures(const nlohmann::json& m, const Audit& a) {
  const auto real = [&m](const char* key) { return fmt::format("{:.9g}", m[key].get<double>()); };
  const auto whole = [&m](const char* key) { return std::to_string(m[key].get<std::int64_t>()); };
  if (countable(a)) {
    const bool capped = m["self_intersecting_pairs_capped"].get<bool>();
    print_row("self-intersecting pairs",
              (capped ? "more than " : "") + whole("self_intersecting_pairs"));
    print_row("triangles without area", whole("triangles_without_area"));
  } else {
    print_row("self-intersecting pairs", a.duplicate_triangles != 0
                                             ? "not counted: duplicate triangles"
                                             : "not counted: triangles that repeat an index");
  }
  print_row("components", whole("components"));
  print_row("Euler characteristic", whole("euler"));
  print_row("genus", m.contains("genus") ? whole("genus") : "has none: not a closed manifold");
  print_row("volume", a.closed() ? real("volume") : "has none: not closed");
  print_row("area", real("area"));
  print_row("edge lengths",
            real("shortest_edge") + " to " + real("longest_edge") + ", mean " + real("mean_edge"));
  print_row("angles", real("smallest_angle") + " to " + real("largest_angle") + " degrees");
}

void print_table(const Verdict& v) {
  const Audit& a = v.audit;
  fmt::print("{}\n", v.file);
  print_row("closed", faults(a.border_edges, "border edges"));
  print_row("oriented", faults(a.misoriented_edges, "edges run along twice the same way"));
  print_row("edge-manifold", faults(a.non_manifold_edges + a.duplicate_triangles,
                                    "edges of three triangles or more, or duplicate triangles"));
  print_row("vertex-manifold", faults(a.non_manifold_vertices, "vertices of more than one fan"));
  print_row("finite", faults(a.non_finite_vertices, "vertices"));
  if (a.degenerate_triangles + a.indices_out_of_range != 0)
    print_row("triangles", fmt::format("{} repeat an index, {} have one out of range",
                                       a.degenerate_triangles, a.indices_out_of_range));
  if (a.isolated_vertices != 0) print_row("isolated vertices", std::to_string(a.isolated_vertices));
  if (!v.measures.is_null()) {
    print_row("vertices, triangles",
              fmt::format("{}, {}", v.measures["vertices"].dump(), v.measures["triangles"].dump()));
    print_measures(v.measures, a);
  }
  print_row("closed oriented manifold", passes(v) ? "yes"
                                        : v.empty ? "no: the mesh is empty, it has no triangle"
                                                  : "no: " + a.first);
}

int check(const Settings& s) {
  bool all = true;
  nlohmann::json list = nlohmann::json::array();
  for (const std::string& file : s.inputs.files) {
    const Verdict verdict = judge(file, s.inputs);
    all = all && passes(verdict);
    if (s.json)
      list.push_back({{"file", file},
                      {"empty", verdict.empty},
                      {"audit", to_json(verdict.audit)},
                      {"measures", verdict.measures}});
    else
      print_table(verdict);
  }
  if (s.json) fmt::print("{}\n", list.dump(1));
  return all ? kDone : kNo;
}

}  // namespace

void add_check(CLI::App& app, int& exit) {
  auto s = std::make_shared<Settings>();
  CLI::App* command =
      app.add_subcommand("check", "Say whether meshes are closed oriented manifolds, and measure");
  command->add_option("inputs", s->inputs.files, "Meshes: OBJ, OFF, PLY or STL")
      ->required()
      ->type_name("IN");
  command->add_flag("--json", s->json, "Print JSON");
  command->add_flag("--repair", s->inputs.mend, "Judge what a repair would leave");
  command->callback([s, &exit] { exit = check(*s); });
}

}  // namespace suture::sims
