// A study's plots: a gnuplot script beside the table, and the pictures that it makes.
#include "sims/trade/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include "kernel/errors.h"
#include "kernel/files.h"
#include "sims/processes.h"
#include "sims/trade/front.h"

namespace suture {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPictures[] = {"error_seconds.png", "error_memory.png", "choices.png"};

/// Text that gnuplot takes as it is, in single quotes.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text)
    if (c != '\n') out += c == '\'' ? std::string("''") : std::string(1, c);
  return out + "'";
}

/// The groups that have a mark of their own: the scene's own run, each factor, the grid.
std::vector<std::string> groups_of(const std::vector<Row>& rows) {
  std::vector<std::string> groups = {"own"};
  for (const Row& row : rows)
    if (row.design != "grid" && std::find(groups.begin(), groups.end(), row.design) == groups.end())
      groups.push_back(row.design);
  groups.emplace_back("grid");
  return groups;
}

std::string style_of(std::size_t group, std::size_t groups) {
  static constexpr const char* colours[] = {"#1f77b4", "#ff7f0e", "#2ca02c", "#9467bd", "#8c564b",
                                            "#e377c2", "#17becf", "#bcbd22", "#003f5c", "#ffa600"};
  static constexpr int marks[] = {5, 7, 9, 11, 13};
  if (group == 0) return "pt 3 ps 2.2 lw 2.5 lc rgb '#000000'";
  if (group + 1 == groups) return "pt 6 ps 1.0 lw 1.5 lc rgb '#888888'";
  return fmt::format("pt {} ps 1.3 lc rgb '{}'", marks[(group - 1) % 5], colours[(group - 1) % 10]);
}

using Series = std::map<std::string, std::string>;  // name → lines "x y label"

struct Panel {
  Series series;
  std::string ranges;
  bool empty = true;
};

/// Where a criterion's values lie above 0: a logarithmic axis. Zeros are drawn at its low end.
struct Span {
  double low = std::numeric_limits<double>::infinity(), high = 0;

  Span(const std::vector<Row>& rows, const Criterion& c, double cell) {
    for (const Row& row : rows)
      if (const double x = c.of(row, cell); x > 0 && std::isfinite(x)) {
        low = std::min(low, x);
        high = std::max(high, x);
      }
    if (high == 0) low = high = 1;
  }
  double shown(double x) const { return x > 0 ? x : low; }
  std::string range(const char* axis) const {
    const double margin = std::max(1.15, std::pow(high / low, 0.07));
    return fmt::format("set {}range [{:.9g}:{:.9g}]\n", axis, low / margin, high * margin);
  }
};

Panel panel_of(const std::vector<Row>& rows, const Criterion& error, const Criterion& cost,
               double cell) {
  Panel panel;
  const Span errors(rows, error, cell), costs(rows, cost, cell);
  panel.ranges = costs.range("x") + errors.range("y");
  const auto point = [&](const Row& row) {
    return fmt::format("{:.9g} {:.9g} {}\n", costs.shown(cost.of(row, cell)),
                       errors.shown(error.of(row, cell)), row.run);
  };
  for (const Row& row : rows) {
    const double c = cost.of(row, cell), e = error.of(row, cell);
    if (!std::isnan(c) && !std::isnan(e)) {
      panel.series[row.failed() ? "failed" : row.sound() ? row.design : "wrong"] += point(row);
      panel.empty = false;
    } else if (row.failed() && !std::isnan(c)) {
      panel.series["lost"] +=
          fmt::format("{:.9g} {:.9g} {}\n", costs.shown(c), errors.high, row.run);
    }
  }
  for (const std::size_t i : pareto_front(rows, error, cost))
    panel.series["front"] += point(rows[i]);
  return panel;
}

std::string draw_panel(const Panel& panel, const Criterion& error, const Criterion& cost,
                       const std::vector<std::string>& groups, const std::string& id) {
  std::string blocks, plots;
  const auto add = [&](const std::string& name, const std::string& with) {
    const auto at = panel.series.find(name);
    if (at == panel.series.end()) return;
    const std::string block = fmt::format("${}_{}", id, plots.size());
    blocks += block + " << EOD\n" + at->second + "EOD\n";
    plots += fmt::format("{} {} {}", plots.empty() ? "plot" : ", \\\n ", block, with);
  };
  add("front", "using 1:2 with steps lw 2.5 lc rgb '#cc0000' notitle");
  for (std::size_t g = groups.size(); g-- > 0;)
    add(groups[g], "using 1:2 with points " + style_of(g, groups.size()) + " notitle");
  add("wrong", "using 1:2 with points pt 10 ps 1.5 lw 2 lc rgb '#cc0000' notitle");
  add("failed", "using 1:2 with points pt 2 ps 1.6 lw 3 lc rgb '#cc0000' notitle");
  add("lost", "using 1:2 with points pt 1 ps 2 lw 3 lc rgb '#cc0000' notitle");
  add("front", "using 1:2:3 with labels offset 0.6,0.6 left font ',9' tc rgb '#cc0000' notitle");
  return blocks + panel.ranges +
         fmt::format("set xlabel {}\nset ylabel {}\n",
                     quoted(fmt::format("{} ({})", cost.name, cost.unit)),
                     quoted(*error.unit == 0 ? std::string(error.name)
                                             : fmt::format("{} ({})", error.name, error.unit))) +
         plots + "\n";
}

/// The fourth panel: what the marks mean.
std::string draw_legend(const std::vector<std::string>& groups, const std::string& reference) {
  std::string out =
      "unset logscale; unset border; unset tics; unset xlabel; unset ylabel; unset grid\n"
      "set xrange [0:1]; set yrange [0:1]\n"
      "set key at graph 0.02,0.99 left top Left reverse samplen 1.5 spacing 1.15 maxrows 12 "
      "font ',11'\n";
  out += "set label 1 " + quoted("Errors are against " + reference) +
         " at graph 0.02,0.02 left font ',9'\n";
  std::string plots = "plot";
  const auto entry = [&](const std::string& title, const std::string& with) {
    plots += fmt::format("{} NaN with {} title {}", plots == "plot" ? "" : ", \\\n ", with,
                         quoted(title));
  };
  for (std::size_t g = 0; g < groups.size(); ++g)
    entry(g == 0                   ? "the scene as it is"
          : g + 1 == groups.size() ? "several at once (grid)"
                                   : groups[g],
          "points " + style_of(g, groups.size()));
  entry("Pareto front, with numbers of runs", "lines lw 2.5 lc rgb '#cc0000'");
  entry("topology not the reference''s", "points pt 10 ps 1.5 lw 2 lc rgb '#cc0000'");
  entry("failed: surgeries were refused", "points pt 2 ps 1.6 lw 3 lc rgb '#cc0000'");
  entry("failed: no surface (height means nothing)", "points pt 1 ps 2 lw 3 lc rgb '#cc0000'");
  return out + plots + "\nunset label 1\n";
}

std::string draw_front(const std::vector<Row>& rows, const PlotOptions& options,
                       const Criterion& cost, const std::string& picture) {
  const std::vector<std::string> groups = groups_of(rows);
  std::string out = "reset\nset output " + quoted(picture) +
                    "\nset term pngcairo size 1400,1050 font 'Sans,11' noenhanced\n"
                    "set multiplot layout 2,2 title " +
                    quoted(options.title) +
                    " font ',14'\nset logscale xy\nset grid lc rgb '#dddddd' lt 1\n"
                    "set format xy '%g'\n";
  for (std::size_t i = 0; i < kErrors.size(); ++i) {
    const Panel panel = panel_of(rows, kErrors[i], cost, options.cell_size);
    if (panel.empty)
      out += "set multiplot next\n";
    else
      out += draw_panel(panel, kErrors[i], cost, groups, "p" + std::to_string(i));
  }
  return out + draw_legend(groups, options.reference) + "unset multiplot\nunset output\n";
}

/// A choice's seconds, memory and error as multiples of the scene's own, a line each.
std::string draw_choices(const std::vector<Row>& rows, const PlotOptions& options,
                         const std::string& picture) {
  const auto own =
      std::find_if(rows.begin(), rows.end(), [](const Row& row) { return row.design == "own"; });
  if (own == rows.end() || own->failed()) return "";
  const std::array<const Criterion*, 3> shown = {&kCosts[0], &kCosts[1], &kErrors[0]};
  std::array<std::string, 3> points;
  std::string tics, marks;
  int place = 0;
  for (const Row& row : rows) {
    if (row.design == "own" || row.design == "grid") continue;
    ++place;
    tics += fmt::format("{}{} {}", tics.empty() ? "" : ", ", quoted(row.change), -place);
    for (std::size_t i = 0; i < shown.size(); ++i) {
      const double ratio = shown[i]->of(row, 1) / shown[i]->of(*own, 1);
      if (ratio > 0 && std::isfinite(ratio)) points[i] += fmt::format("{:.6g} {}\n", ratio, -place);
    }
    if (!row.sound()) marks += fmt::format("1 {} {}\n", -place, row.failed() ? 2 : 10);
  }
  if (place == 0) return "";
  std::string out = fmt::format(
      "reset\nset output {}\nset term pngcairo size 1200,{} font 'Sans,11' noenhanced\n"
      "set title {} font ',14'\nset logscale x\nset yrange [{}:0]\nset ytics ({})\n"
      "set grid lc rgb '#dddddd' lt 1\nset key outside bottom center horizontal\n"
      "set xlabel 'times what the scene as it is has (1: the same; left is better)'\n"
      "set arrow 1 from 1,graph 0 to 1,graph 1 nohead lc rgb '#000000' lw 1.5\n",
      quoted(picture), 170 + 26 * place, quoted(options.title + ": one choice at a time"),
      -place - 1, tics);
  static constexpr const char* styles[] = {"pt 7 ps 1.4 lc rgb '#1f77b4'",
                                           "pt 5 ps 1.2 lc rgb '#999999'",
                                           "pt 9 ps 1.5 lc rgb '#ff7f0e'"};
  std::string plots = "plot";
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (points[i].empty()) continue;
    out += fmt::format("$c{} << EOD\n{}EOD\n", i, points[i]);
    plots += fmt::format("{} $c{} with points {} title {}", plots == "plot" ? "" : ", ", i,
                         styles[i], quoted(shown[i]->name));
  }
  if (!marks.empty()) {
    out += "$m << EOD\n" + marks + "EOD\n";
    plots +=
        ", $m using 1:2:3 with points pt variable ps 1.8 lw 2.5 lc rgb '#cc0000' title 'failed "
        "(x), "
        "or topology not the reference''s (triangle)'";
  }
  return plots == "plot" ? "" : out + plots + "\nunset output\n";
}

}  // namespace

std::string plot_script(const std::vector<Row>& rows, const PlotOptions& options) {
  return "# Run by gnuplot in this folder; suture trade made it.\n" +
         draw_front(rows, options, kCosts[0], kPictures[0]) +
         draw_front(rows, options, kCosts[1], kPictures[1]) +
         draw_choices(rows, options, kPictures[2]);
}

std::string draw(const std::vector<Row>& rows, const PlotOptions& options, const fs::path& folder) {
  const std::string script = plot_script(rows, options);
  write_file(folder / "trade.gp", script);
  const int exit = run_program({"gnuplot", "trade.gp"}, folder.string());
  if (exit == 127)
    return "there is no gnuplot here: install it (apt-get install gnuplot-nox), then run gnuplot "
           "trade.gp in " +
           folder.string();
  if (exit != 0)
    return fmt::format("gnuplot ended with {}; run gnuplot trade.gp in {} to see why", exit,
                       folder.string());
  for (const char* picture : kPictures)
    if (script.find(picture) != std::string::npos && !fs::exists(folder / picture))
      return fmt::format("gnuplot left no {}; run gnuplot trade.gp in {} to see why", picture,
                         folder.string());
  return "";
}

}  // namespace suture
