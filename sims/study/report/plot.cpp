// A study's plots: a gnuplot script beside the table, and the pictures that it makes.
#include "sims/study/report/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "kernel/errors.h"
#include "kernel/files.h"
#include "sims/study/report/front.h"
#include "sims/support/process.h"

namespace suture::sims {
namespace {

namespace fs = std::filesystem;

/// The costs' pictures, in their order, and that of the choices.
constexpr const char* kPictures[] = {"error_seconds.png", "error_memory.png", "choices.png"};

/// Text that gnuplot takes as it is, in single quotes.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text)
    if (c != '\n') out += c == '\'' ? std::string("''") : std::string(1, c);
  return out + "'";
}

/// Text as quoted lines of at most so many letters, where words are that short.
std::string wrapped(const std::string& text, std::size_t most) {
  std::string out, line;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > most) {
      out += line + "\\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  std::string safe;
  for (const char c : out + line) safe += c == '"' ? std::string("''") : std::string(1, c);
  return "\"" + safe + "\"";
}

/// The groups that have a mark of their own: the scene's own run, each factor, the grid.
std::vector<std::string> groups_of(const std::vector<Row>& rows) {
  std::vector<std::string> groups = {"own"};
  for (const Row& row : rows)
    if (const std::string design = row.text("design");
        design != "grid" && std::find(groups.begin(), groups.end(), design) == groups.end())
      groups.push_back(design);
  groups.emplace_back("grid");
  return groups;
}

std::string style_of(std::size_t group, std::size_t groups) {
  static constexpr const char* colours[] = {"#1f77b4", "#ff7f0e", "#2ca02c", "#9467bd", "#8c564b",
                                            "#e377c2", "#17becf", "#bcbd22", "#003f5c", "#ffa600"};
  static constexpr int marks[] = {5, 7, 9, 13, 15, 12, 4};
  if (group == 0) return "pt 3 ps 2.2 lw 2.5 lc rgb '#000000'";
  if (group + 1 == groups) return "pt 6 ps 1.0 lw 1.5 lc rgb '#888888'";
  return fmt::format("pt {} ps 1.3 lc rgb '{}'", marks[(group - 1) % 7], colours[(group - 1) % 10]);
}

/// A panel draws errors against costs; `cell` is the scene's own cell size.
struct Axes {
  const Criterion& error;
  const Criterion& cost;
  double cell;
};

/// Points of a panel by the name of their mark, as lines "x y label".
using Series = std::map<std::string, std::string>;

struct Panel {
  std::string id;
  Axes axes;
  Series series;
  std::string ranges;
  bool empty = true;
};

/// The range of a criterion's values above 0, for a logarithmic axis. Zeros are drawn at its low
/// end.
struct Span {
  double low = std::numeric_limits<double>::infinity(), high = 0;

  Span() = default;
  Span(const std::vector<Row>& rows, const Criterion& c, double cell) {
    for (const Row& row : rows) take(c.of(row, cell));
    if (high == 0) low = high = 1;
  }
  void take(double x) {
    if (!(x > 0 && std::isfinite(x))) return;
    low = std::min(low, x);
    high = std::max(high, x);
  }
  double shown(double x) const { return x > 0 ? x : low; }
  /// Commands for the axis: its range with a margin, and tics at round numbers.
  std::string axis(const char* name) const {
    const double margin = std::max(1.15, std::pow(high / low, 0.07));
    const std::vector<double> wide = {1, 2, 5}, narrow = {1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8};
    std::string tics;
    const int last = static_cast<int>(std::floor(std::log10(high * margin)));
    for (int power = static_cast<int>(std::floor(std::log10(low / margin))); power <= last; ++power)
      for (const double digit : high > 5 * low ? wide : narrow)
        tics += fmt::format("{}{}e{}", tics.empty() ? "" : ",", digit, power);
    return fmt::format("set {0}range [{1:.9g}:{2:.9g}]\nset {0}tics ({3})\n", name, low / margin,
                       high * margin, tics);
  }
  /// \return where x lies between the ends, from 0 to 1
  double place(double x) const {
    return high > low ? std::log(shown(x) / low) / std::log(high / low) : 0;
  }
};

/// The places of rows in a panel: costs to the right, errors up.
class Place {
 public:
  Place(const std::vector<Row>& rows, const Axes& axes)
      : axes_(axes), errors_(rows, axes.error, axes.cell), costs_(rows, axes.cost, axes.cell) {}

  double cost(const Row& row) const { return axes_.cost.of(row, axes_.cell); }
  double error(const Row& row) const { return axes_.error.of(row, axes_.cell); }
  std::string ranges() const { return costs_.axis("x") + errors_.axis("y"); }
  std::string point(const Row& row) const { return line(row, errors_.shown(error(row))); }
  /// The row has no error, and is drawn at the height of the worst one.
  std::string point_at_top(const Row& row) const { return line(row, errors_.high); }

  bool near(const Row& a, const Row& b) const {
    return std::abs(costs_.place(cost(a)) - costs_.place(cost(b))) < 0.06 &&
           std::abs(errors_.place(error(a)) - errors_.place(error(b))) < 0.05;
  }

 private:
  std::string line(const Row& row, double height) const {
    return fmt::format("{:.9g} {:.9g} {}\n", costs_.shown(cost(row)), height, run_number(row));
  }

  const Axes& axes_;
  Span errors_, costs_;
};

Panel panel_of(const std::vector<Row>& rows, const Axes& axes, const std::string& id) {
  Panel panel{id, axes, {}, {}};
  const Place place(rows, axes);
  panel.ranges = place.ranges();
  for (const Row& row : rows) {
    const bool has_cost = !std::isnan(place.cost(row)), has_error = !std::isnan(place.error(row));
    if (has_cost && has_error) {
      panel.series[failed(row)  ? "failed"
                   : sound(row) ? row.text("design")
                                : "wrong"] += place.point(row);
      panel.empty = false;
    } else if (failed(row) && has_cost) {
      panel.series["lost"] += place.point_at_top(row);
    }
  }
  const Row* last = nullptr;  // whose number was written: they are not to cover one another
  for (const std::size_t i : pareto_front(rows, axes.error, axes.cost)) {
    panel.series["front"] += place.point(rows[i]);
    if (last != nullptr && place.near(rows[i], *last)) continue;
    panel.series["numbers"] += place.point(rows[i]);
    last = &rows[i];
  }
  return panel;
}

std::string with_unit(const Criterion& c) {
  return *c.unit == 0 ? std::string(c.name) : fmt::format("{} ({})", c.name, c.unit);
}

std::string draw_panel(const Panel& panel, const std::vector<std::string>& groups) {
  std::string blocks, plots;
  const auto add = [&](const std::string& name, const std::string& with) {
    const auto at = panel.series.find(name);
    if (at == panel.series.end()) return;
    const std::string block = fmt::format("${}_{}", panel.id, plots.size());
    blocks += block + " << EOD\n" + at->second + "EOD\n";
    plots += fmt::format("{} {} {}", plots.empty() ? "plot" : ", \\\n ", block, with);
  };
  add("front", "using 1:2 with steps lw 2.5 lc rgb '#cc0000' notitle");
  for (std::size_t g = groups.size(); g-- > 0;)
    add(groups[g], "using 1:2 with points " + style_of(g, groups.size()) + " notitle");
  add("wrong", "using 1:2 with points pt 10 ps 1.5 lw 2 lc rgb '#cc0000' notitle");
  add("failed", "using 1:2 with points pt 2 ps 1.6 lw 3 lc rgb '#cc0000' notitle");
  add("lost", "using 1:2 with points pt 1 ps 2 lw 3 lc rgb '#cc0000' notitle");
  add("numbers", "using 1:2:3 with labels offset 0.6,0.6 left font ',9' tc rgb '#cc0000' notitle");
  return blocks + panel.ranges +
         fmt::format("set xlabel {}\nset ylabel {}\n", quoted(with_unit(panel.axes.cost)),
                     quoted(with_unit(panel.axes.error))) +
         plots + "\n";
}

/// The fourth panel: what the marks mean.
std::string draw_legend(const std::vector<std::string>& groups, const std::string& reference) {
  std::string out =
      "unset logscale; unset border; unset tics; unset xlabel; unset ylabel; unset grid\n"
      "set xrange [0:1]; set yrange [0:1]\n"
      "set key at graph 0.02,0.99 left top Left reverse vertical samplen 1.5 spacing 0.95 "
      "font ',10'\n";
  out += "set label 1 " + wrapped("Errors are against " + reference, 44) +
         " at graph 0.52,0.97 left font ',10'\n";
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
  entry("Pareto front, numbers of runs", "lines lw 2.5 lc rgb '#cc0000'");
  entry("topology not the right one", "points pt 10 ps 1.5 lw 2 lc rgb '#cc0000'");
  entry("failed: surgeries were refused", "points pt 2 ps 1.6 lw 3 lc rgb '#cc0000'");
  entry("failed: no surface (height is void)", "points pt 1 ps 2 lw 3 lc rgb '#cc0000'");
  return out + plots + "\nunset label 1\n";
}

/// Draws all errors against the cost with this index.
std::string draw_front(const std::vector<Row>& rows, const PlotOptions& options, std::size_t cost) {
  const std::vector<std::string> groups = groups_of(rows);
  std::string out = "reset\nset output " + quoted(kPictures[cost]) +
                    "\nset term pngcairo size 1400,1050 font 'Sans,11' noenhanced\n"
                    "set multiplot layout 2,2 title " +
                    quoted(options.title) +
                    " font ',14'\nset logscale xy\nset grid lc rgb '#dddddd' lt 1\n"
                    "set format xy '%g'\n";
  for (std::size_t i = 0; i < kErrors.size(); ++i) {
    const Axes axes{kErrors[i], kCosts[cost], options.cell_size};
    const Panel panel = panel_of(rows, axes, "p" + std::to_string(i));
    out += panel.empty ? "set multiplot next\n" : draw_panel(panel, groups);
  }
  return out + draw_legend(groups, options.reference) + "unset multiplot\nunset output\n";
}

/// A choice's seconds, memory and error as multiples of the scene's own, a line each.
struct Choices {
  std::array<std::string, 3> points;
  std::string tics, failures, wrong;
  int places = 0;
  Span span;

  Choices(const std::vector<Row>& rows, const Row& own) {
    for (const Row& row : rows) {
      if (row.text("design") == "own" || row.text("design") == "grid") continue;
      ++places;
      tics += fmt::format("{}{} {}", tics.empty() ? "" : ", ", quoted(row.text("change")), -places);
      for (std::size_t i = 0; i < kShown.size(); ++i) {
        const double ratio = kShown[i]->of(row, 1) / kShown[i]->of(own, 1);
        if (!(ratio > 0 && std::isfinite(ratio))) continue;
        points[i] += fmt::format("{:.6g} {}\n", ratio, -places);
        span.take(ratio);
      }
      if (!sound(row)) (failed(row) ? failures : wrong) += fmt::format("{}\n", -places);
    }
  }

  static constexpr std::array<const Criterion*, 3> kShown = {&kCosts[0], &kCosts[1], &kErrors[0]};
};

std::string choices_heading(const Choices& choices, const PlotOptions& options) {
  return fmt::format(
             "reset\nset output {}\nset term pngcairo size 1200,{} font 'Sans,11' noenhanced\n"
             "set title {} font ',14'\nset logscale x\nset yrange [{}:0]\nset ytics ({})\n"
             "set bmargin 6\n"
             "set grid lc rgb '#dddddd' lt 1\nset key at screen 0.5,0.012 center bottom horizontal "
             "maxrows 1 width 2\nset format x '%g'\n"
             "set xlabel 'multiples of what the scene as it is has (1: the same; further left is "
             "better)'\n"
             "set arrow 1 from 1,graph 0 to 1,graph 1 nohead lc rgb '#000000' lw 1.5\n",
             quoted(kPictures[2]), 190 + 26 * choices.places,
             quoted(options.title + ": one choice at a time"), -choices.places - 1, choices.tics) +
         choices.span.axis("x");
}

std::string draw_choices(const std::vector<Row>& rows, const PlotOptions& options) {
  const auto own = std::find_if(rows.begin(), rows.end(),
                                [](const Row& row) { return row.text("design") == "own"; });
  if (own == rows.end() || failed(*own)) return "";
  const Choices choices(rows, *own);
  if (choices.span.high == 0) return "";
  std::string out = choices_heading(choices, options);
  static constexpr const char* styles[] = {"pt 7 ps 1.4 lc rgb '#1f77b4'",
                                           "pt 5 ps 1.2 lc rgb '#999999'",
                                           "pt 9 ps 1.5 lc rgb '#ff7f0e'"};
  std::string plots = "plot";
  for (std::size_t i = 0; i < Choices::kShown.size(); ++i) {
    out += fmt::format("$c{} << EOD\n{}EOD\n", i, choices.points[i]);
    if (!choices.points[i].empty())
      plots += fmt::format("{} $c{} with points {} title {}", plots == "plot" ? "" : ", ", i,
                           styles[i], quoted(Choices::kShown[i]->name));
  }
  const auto mark = [&](const std::string& places, int kind, const char* meaning) {
    if (places.empty()) return;
    out += fmt::format("$m{} << EOD\n{}EOD\n", kind, places);
    plots += fmt::format(
        ", $m{} using ({:.9g}):1 with points pt {} ps 1.6 lw 2.5 lc rgb '#cc0000' title '{}'", kind,
        choices.span.low, kind, meaning);
  };
  mark(choices.failures, 2, "failed");
  mark(choices.wrong, 10, "wrong topology");
  return out + plots + "\nunset output\n";
}

}  // namespace

std::string plot_script(const std::vector<Row>& rows, const PlotOptions& options) {
  return "# Run by gnuplot in this folder; suture trade made it.\n" + draw_front(rows, options, 0) +
         draw_front(rows, options, 1) + draw_choices(rows, options);
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

}  // namespace suture::sims
