// What a study's table says, in words: what to choose, what it costs, what fails.
#include "sims/study/report/recommend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "sims/study/report/front.h"

namespace suture::sims {
namespace {

double seconds(const Row& row) { return row.figures.tracker_seconds; }
double volume_error(const Row& row) { return std::abs(row.figures.volume_error); }

std::string choice(const Row& row) {
  return row.change.empty() ? "the scene as it is" : "`" + row.change + "`";
}

/// The page as it grows.
class Page {
 public:
  Page(const std::vector<Row>& rows, const RecommendOptions& options)
      : rows_(rows), options_(options) {
    for (const Row& row : rows)
      if (row.design == "own") own_ = &row;
  }

  std::string write() {
    say("# {}: what to choose\n\n", options_.title);
    say("{} runs. Errors are against {}. Distances are in cells of the scene as it is ({:.4g}); "
        "seconds are CPU seconds in the tracker (remodels and improvement).\n\n",
        rows_.size(), options_.reference, options_.cell_size);
    if (least_error(rows_) == nullptr) {
      say("No run is sound: each failed, or has another topology than the reference. Nothing can "
          "be recommended.\n\n");
    } else {
      choose();
      front();
    }
    if (own_ != nullptr) choices();
    failures();
    return std::move(page_);
  }

 private:
  template <class... Args>
  void say(fmt::format_string<Args...> text, Args&&... args) {
    page_ += fmt::format(text, std::forward<Args>(args)...);
  }

  std::string cells(double length) const {
    return fmt::format("{:.3g}", length / options_.cell_size);
  }

  std::string figures(const Row& row) const {
    const Figures& f = row.figures;
    return fmt::format("mean distance {} cells, largest {}, volume {:+.2g} %, {:.3g} s, {:.0f} MB",
                       cells(f.mean_distance()), cells(f.max_distance()), 100 * f.volume_error,
                       f.tracker_seconds, f.peak_megabytes);
  }

  /// How a row's cost and error compare with the scene's own, where that is sound.
  std::string beside_own(const Row& row) const {
    if (own_ == nullptr || !own_->sound() || &row == own_) return "";
    return fmt::format(
        " ({:.2g} × the seconds and {:.2g} × the mean distance of the scene as it is)",
        seconds(row) / seconds(*own_), row.figures.mean_distance() / own_->figures.mean_distance());
  }

  void choose() {
    const Row& best = *least_error(rows_);
    say("## Choose\n\n- For the smallest error: {} (run {}): {}{}.\n", choice(best), best.run,
        figures(best), beside_own(best));
    if (own_ != nullptr && own_->sound()) {
      const Row& cheaper = *as_good_for_less(rows_, *own_);
      if (&cheaper == own_)
        say("- Nothing tried is as good as the scene as it is in distances, volume and "
            "self-intersections, and cheaper: {}.\n",
            figures(*own_));
      else
        say("- For no more error or self-intersections than the scene as it is, at the least cost: "
            "{} (run {}): {}{}.\n",
            choice(cheaper), cheaper.run, figures(cheaper), beside_own(cheaper));
    } else if (own_ != nullptr) {
      say("- The scene as it is is no sound choice: {}.\n", why(*own_));
    }
    const Row& fast = rows_[pareto_front(rows_, kErrors[0], kCosts[0]).front()];
    say("- For the least seconds: {} (run {}): {}{}.\n\n", choice(fast), fast.run, figures(fast),
        beside_own(fast));
  }

  void front() {
    say("## The best error at a given cost\n\nThe Pareto front of mean distance against seconds: "
        "for what a row costs, no run is nearer to the reference. Take the last that you can "
        "afford.\n\n"
        "| run | choice | s | MB | mean | largest | volume | pairs | least angle |\n"
        "|--:|---|--:|--:|--:|--:|--:|--:|--:|\n");
    for (const std::size_t i : pareto_front(rows_, kErrors[0], kCosts[0])) {
      const Row& r = rows_[i];
      const Figures& f = r.figures;
      say("| {} | {} | {:.3g} | {:.0f} | {} | {} | {:+.2g} % | {:.0f} | {:.2g}° |\n", r.run,
          choice(r), f.tracker_seconds, f.peak_megabytes, cells(f.mean_distance()),
          cells(f.max_distance()), 100 * f.volume_error, f.intersecting_pairs, f.least_angle);
    }
    say("\nPairs are self-intersecting triangles of the last surface.\n\n");
  }

  std::string times(double value, double of) const {
    const double ratio = value / of;
    return std::isfinite(ratio) ? fmt::format("{:.2f}", ratio) : "–";
  }

  void choices() {
    const Figures& o = own_->figures;
    say("## What each choice costs\n\nOne at a time, as multiples of the scene as it is ({}).\n\n"
        "| run | choice | seconds | memory | mean | largest | \\|volume error\\| | what else |\n"
        "|--:|---|--:|--:|--:|--:|--:|---|\n",
        own_->failed() ? why(*own_) : figures(*own_));
    for (const Row& row : rows_) {
      if (row.design == "own" || row.design == "grid") continue;
      const Figures& f = row.figures;
      say("| {} | {} | {} | {} | {} | {} | {} | {} |\n", row.run, choice(row),
          times(f.tracker_seconds, o.tracker_seconds), times(f.peak_megabytes, o.peak_megabytes),
          times(f.mean_distance(), o.mean_distance()), times(f.max_distance(), o.max_distance()),
          times(volume_error(row), volume_error(*own_)), remark(row));
    }
    say("\n");
  }

  std::string remark(const Row& row) const {
    const bool same = !row.surface.empty() && row.surface == own_->surface && &row != own_;
    std::string remark = row.sound() ? "" : (row.failed() ? "" : "other topology: ") + why(row);
    if (same) remark += (remark.empty() ? "" : "; ") + std::string("the same surface, bit for bit");
    return remark;
  }

  std::string why(const Row& row) const {
    const Figures& f = row.figures;
    if (row.outcome == kRefusedRun)
      return fmt::format("{:.0f} of {:.0f} remodels were refused, the first because: {}", f.refused,
                         f.remodels, row.failure);
    if (row.failed()) return row.outcome + ": " + row.failure;
    return fmt::format("{:.0f} components, Euler characteristic {:.0f}", f.components, f.euler);
  }

  void failures() {
    say("## What fails\n\n");
    bool any = false;
    for (const Row& row : rows_)
      if (row.failed()) {
        say("- run {}, {}: {}.\n", row.run, choice(row), why(row));
        any = true;
      }
    if (!any) say("Nothing: every run went to its end, and no surgery was refused.\n");
    std::map<std::string, std::string> others;
    for (const Row& row : rows_) {
      if (row.failed() || row.sound()) continue;
      std::string& runs = others[why(row)];
      runs += (runs.empty() ? "" : ", ") + std::to_string(row.run);
    }
    if (others.empty()) return;
    say("\nThese went to their end with another topology than {}, and are not on the front:\n\n",
        options_.topology);
    for (const auto& [topology, runs] : others) say("- {}: runs {}.\n", topology, runs);
    if (own_ != nullptr && !own_->failed() && !own_->sound())
      say("\nThe scene as it is is one of them. Topology changes at the size of a cell, so a finer "
          "run splits later: let the scene end well after its last event, or say which topology is "
          "right (`--topology`).\n");
  }

  const std::vector<Row>& rows_;
  const RecommendOptions& options_;
  const Row* own_ = nullptr;
  std::string page_;
};

}  // namespace

const Row* least_error(const std::vector<Row>& rows) {
  const auto front = pareto_front(rows, kErrors[0], kCosts[0]);
  return front.empty() ? nullptr : &rows[front.back()];
}

const Row* as_good_for_less(const std::vector<Row>& rows, const Row& than) {
  const Row* best = &than;
  for (const Row& row : rows) {
    if (!row.sound() || !(seconds(row) < seconds(*best))) continue;
    const bool as_good = row.figures.mean_distance() <= than.figures.mean_distance() &&
                         row.figures.max_distance() <= than.figures.max_distance() &&
                         volume_error(row) <= volume_error(than) &&
                         !(row.figures.intersecting_pairs > than.figures.intersecting_pairs);
    if (as_good) best = &row;
  }
  return best;
}

std::string recommendation(const std::vector<Row>& rows, const RecommendOptions& options) {
  return Page(rows, options).write();
}

}  // namespace suture::sims
