// A study's table in words: what to choose, what it costs, what fails.
#include "sims/study/report/recommend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "sims/study/report/front.h"

namespace suture::sims {
namespace {

double megabytes(const Row& row) { return row.number("peak_megabytes"); }

bool is_own(const Row& row) { return row.text("design") == "own"; }

std::string choice(const Row& row) {
  return row.text("change").empty() ? "the scene as it is" : "`" + row.text("change") + "`";
}

/// The page as it grows.
class Page {
 public:
  Page(const std::vector<Row>& rows, const RecommendOptions& options)
      : rows_(rows), options_(options) {
    for (const Row& row : rows)
      if (is_own(row)) own_ = &row;
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
    return fmt::format("mean distance {} cells, largest {}, volume {:+.2g} %, {:.3g} s, {:.0f} MB",
                       cells(mean_distance(row)), cells(max_distance(row)),
                       100 * row.number("volume_error"), tracker_seconds(row),
                       row.number("peak_megabytes"));
  }

  /// Compares a row's cost and error with the scene's own, where that is sound.
  std::string beside_own(const Row& row) const {
    if (own_ == nullptr || !sound(*own_) || &row == own_) return "";
    return fmt::format(
        " ({:.2g} × the seconds and {:.2g} × the mean distance of the scene as it is)",
        tracker_seconds(row) / tracker_seconds(*own_), mean_distance(row) / mean_distance(*own_));
  }

  void choose() {
    const Row& best = *least_error(rows_);
    say("## Choose\n\n- For the smallest error: {} (run {}): {}{}.\n", choice(best),
        run_number(best), figures(best), beside_own(best));
    if (own_ != nullptr && sound(*own_)) {
      const Row& cheaper = *as_good_for_less(rows_, *own_);
      if (&cheaper == own_)
        say("- Nothing tried is as good as the scene as it is in distances, volume and "
            "self-intersections, and cheaper: {}.\n",
            figures(*own_));
      else
        say("- For no more error or self-intersections than the scene as it is, at the least cost: "
            "{} (run {}): {}{}.\n",
            choice(cheaper), run_number(cheaper), figures(cheaper), beside_own(cheaper));
    } else if (own_ != nullptr) {
      say("- The scene as it is is no sound choice: {}.\n", why(*own_));
    }
    const Row& fast = rows_[pareto_front(rows_, kErrors[0], kCosts[0]).front()];
    say("- For the least seconds: {} (run {}): {}{}.\n\n", choice(fast), run_number(fast),
        figures(fast), beside_own(fast));
  }

  void front() {
    say("## The best error at a given cost\n\nThe Pareto front of mean distance against seconds: "
        "for what a row costs, no run is nearer to the reference. Take the last that you can "
        "afford.\n\n"
        "| run | choice | s | MB | mean | largest | volume | pairs | least angle |\n"
        "|--:|---|--:|--:|--:|--:|--:|--:|--:|\n");
    for (const std::size_t i : pareto_front(rows_, kErrors[0], kCosts[0])) {
      const Row& r = rows_[i];
      say("| {} | {} | {:.3g} | {:.0f} | {} | {} | {:+.2g} % | {:.0f} | {:.2g}° |\n", run_number(r),
          choice(r), tracker_seconds(r), r.number("peak_megabytes"), cells(mean_distance(r)),
          cells(max_distance(r)), 100 * r.number("volume_error"),
          r.number("self_intersecting_pairs"), r.number("least_angle"));
    }
    say("\nPairs are self-intersecting triangles of the last surface.\n\n");
  }

  /// A row's figure as a multiple of the scene's own.
  std::string times(double (*of)(const Row&), const Row& row) const {
    const double ratio = of(row) / of(*own_);
    return std::isfinite(ratio) ? fmt::format("{:.2f}", ratio) : "–";
  }

  void choices() {
    say("## What each choice costs\n\nOne at a time, as multiples of the scene as it is ({}).\n\n"
        "| run | choice | seconds | memory | mean | largest | \\|volume error\\| | what else |\n"
        "|--:|---|--:|--:|--:|--:|--:|---|\n",
        failed(*own_) ? why(*own_) : figures(*own_));
    for (const Row& row : rows_) {
      if (is_own(row) || row.text("design") == "grid") continue;
      say("| {} | {} | {} | {} | {} | {} | {} | {} |\n", run_number(row), choice(row),
          times(tracker_seconds, row), times(megabytes, row), times(mean_distance, row),
          times(max_distance, row), times(volume_error, row), remark(row));
    }
    say("\n");
  }

  std::string remark(const Row& row) const {
    const bool same = !row.text("surface").empty() &&
                      row.text("surface") == own_->text("surface") && &row != own_;
    std::string remark = sound(row) ? "" : (failed(row) ? "" : "other topology: ") + why(row);
    if (same) remark += (remark.empty() ? "" : "; ") + std::string("the same surface, bit for bit");
    return remark;
  }

  std::string why(const Row& row) const {
    if (row.text("outcome") == kRefusedRun)
      return fmt::format("{:.0f} of {:.0f} remodels were refused, the first because: {}",
                         row.number("refused"), row.number("remodels"), row.text("failure"));
    if (failed(row)) return row.text("outcome") + ": " + row.text("failure");
    return fmt::format("{:.0f} components, Euler characteristic {:.0f}", row.number("components"),
                       row.number("euler"));
  }

  void failures() {
    say("## What fails\n\n");
    bool any = false;
    for (const Row& row : rows_)
      if (failed(row)) {
        say("- run {}, {}: {}.\n", run_number(row), choice(row), why(row));
        any = true;
      }
    if (!any) say("Nothing: every run went to its end, and no surgery was refused.\n");
    std::map<std::string, std::string> others;
    for (const Row& row : rows_) {
      if (failed(row) || sound(row)) continue;
      std::string& runs = others[why(row)];
      runs += (runs.empty() ? "" : ", ") + std::to_string(run_number(row));
    }
    if (others.empty()) return;
    say("\nThese went to their end with another topology than {}, and are not on the front:\n\n",
        options_.topology);
    for (const auto& [topology, runs] : others) say("- {}: runs {}.\n", topology, runs);
    if (own_ != nullptr && !failed(*own_) && !sound(*own_))
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
    if (!sound(row) || !(tracker_seconds(row) < tracker_seconds(*best))) continue;
    const bool as_good =
        mean_distance(row) <= mean_distance(than) && max_distance(row) <= max_distance(than) &&
        volume_error(row) <= volume_error(than) &&
        !(row.number("self_intersecting_pairs") > than.number("self_intersecting_pairs"));
    if (as_good) best = &row;
  }
  return best;
}

std::string recommendation(const std::vector<Row>& rows, const RecommendOptions& options) {
  return Page(rows, options).write();
}

}  // namespace suture::sims
