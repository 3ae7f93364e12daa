// Speed against accuracy: a scene run over many choices, each measured for what it costs and gives.
#include "sims/study/trade.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "kernel/errors.h"
#include "kernel/files.h"
#include "kernel/lists.h"
#include "kernel/random.h"
#include "sims/study/trade_run.h"
#include "sims/study/report/plot.h"
#include "sims/study/report/recommend.h"
#include "sims/study/table/trade_row.h"

namespace suture::sims {
namespace {

namespace fs = std::filesystem;

std::vector<PlannedRun> planned(const TradeOptions& o, const Settings& own) {
  const bool given = !o.factors.empty();
  const std::string design = !o.design.empty() ? o.design : given ? "grid" : "both";
  const DesignChoice choice{.one = design != "grid", .grid = design != "one"};
  return plan(own, given ? designs_of(o.factors, own, choice) : default_designs(own, choice));
}

/// Each single change is read as the scene's own would be, so that a bad one is refused at once.
void require_readable(const fs::path& scene, const std::vector<PlannedRun>& runs) {
  std::map<std::string, bool> seen;
  for (const PlannedRun& run : runs)
    for (const auto& [name, value] : run.changes)
      if (seen.emplace(name + text_of(value), true).second) read_scene(scene, {{name, value}});
}

/// What several processes of one run make of it: the first that failed, or the medians.
Row combined(const std::vector<Row>& parts) {
  for (const Row& part : parts)
    if (part.failed() && part.outcome != kRefusedRun) return part;
  Row row = parts.front();
  for (const Row& part : parts)
    if (part.surface != row.surface) {
      row.outcome = kStoppedRun;
      row.failure = "two runs of the same gave different surfaces";
      return row;
    }
  std::vector<double> seconds;
  for (const Row& part : parts) seconds.push_back(part.figures.tracker_seconds);
  const auto [least, most] = std::minmax_element(seconds.begin(), seconds.end());
  const double middle = median(seconds);
  if (parts.size() > 1 && middle > 0) row.figures.spread = (*most - *least) / middle;
  for (double Figures::*figure :
       {&Figures::tracker_seconds, &Figures::remodel_seconds, &Figures::improve_seconds,
        &Figures::move_seconds, &Figures::total_seconds, &Figures::peak_megabytes}) {
    std::vector<double> values;
    for (const Row& part : parts) values.push_back(part.figures.*figure);
    row.figures.*figure = median(values);
  }
  return row;
}

/// What is known of a run whose process did not finish.
Row lost(const Ended& ended) {
  Row row;
  row.outcome = ended.out_of_time ? kTimedOutRun : kCrashedRun;
  row.failure = ended.words();
  row.figures.tracker_seconds = row.figures.total_seconds = ended.cpu_seconds;
  row.figures.peak_megabytes = ended.peak_megabytes;
  return row;
}

class Study {
 public:
  Study(const TradeOptions& options, TradeWatcher* watcher)
      : options_(options), watcher_(watcher), table_(options.folder / "trade.csv") {
    const Scene scene = read_scene(options.scene);
    title_ = scene.title;
    own_ = settings_of(scene);
    cell_size_ = scene.tracker.cell_size;
    scene_bits_ = fingerprint(scene.surface);
    runs_ = planned(options, own_);
    require_readable(options.scene, runs_);
  }

  TradeSummary all() {
    make_folder();
    if (fs::exists(table_)) rows_ = read_csv(table_);
    ReferenceOptions how = options_.reference;
    how.limit = options_.processes;
    how.limit.limit_seconds *= 20;  // finer than every run, so dearer than the dearest
    if (watcher_ != nullptr) watcher_->referring();
    reference_ = make_reference(options_.scene, options_.folder, runs_, how);
    study_ = fingerprint(read_file(options_.scene) + scene_bits_ +
                         fingerprint(read_file(reference_.mesh)) +
                         fmt::format("{}", fmt::join(options_.topology, " ")));
    for (const Row& row : rows_)
      if (row.study != study_ || !same_settings(row))
        throw InvalidInput(
            table_.string() +
            ": it is of another scene or version, or measured against something else; give "
            "another folder, or remove the file");
    if (watcher_ != nullptr) watcher_->referenced(reference_);
    make_runs();
    return conclude();
  }

 private:
  void make_folder() const {
    std::error_code error;
    fs::create_directories(options_.folder, error);
    if (error)
      throw InvalidInput(options_.folder.string() + ": the folder cannot be made (" +
                         error.message() + "); choose another");
  }

  /// Whether the row has the settings that this version knows, whatever their values.
  bool same_settings(const Row& row) const {
    return std::equal(row.settings.begin(), row.settings.end(), own_.begin(), own_.end(),
                      [](const auto& cell, const Setting& s) { return cell.first == s.key; });
  }

  /// The row of a planned run, if the table has it with as many repeats.
  Row* find(const PlannedRun& run) {
    const Settings want = changed(own_, run.changes);
    const auto same = [&](const Row& row) {
      return std::equal(row.settings.begin(), row.settings.end(), want.begin(), want.end(),
                        [](const auto& cell, const Setting& s) {
                          return cell.first == s.key && cell.second == text_of(s.value);
                        });
    };
    const auto at = std::find_if(rows_.begin(), rows_.end(), same);
    return at == rows_.end() || at->repeats < options_.repeat ? nullptr : &*at;
  }

  /// Indices of the runs to make, in a shuffled order.
  std::vector<std::size_t> missing() {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < runs_.size(); ++i)
      if (find(runs_[i]) == nullptr) order.push_back(i);
    Random random(options_.seed);
    shuffle(order, random);
    return order;
  }

  void make_runs() {
    const std::vector<std::size_t> order = missing();
    if (watcher_ != nullptr) watcher_->planned(runs_.size(), runs_.size() - order.size());
    const auto repeat = static_cast<std::size_t>(options_.repeat);
    std::vector<std::size_t> tasks;
    for (const std::size_t run : order) tasks.insert(tasks.end(), repeat, run);
    std::map<std::size_t, std::vector<Row>> parts;
    in_processes(
        tasks, options_.processes,
        [&](std::size_t run) {
          return packed(run_once({.scene = options_.scene,
                                  .changes = runs_[run].changes,
                                  .reference = reference_.mesh,
                                  .topology = options_.topology,
                                  .surface = {},
                                  .samples = options_.samples}));
        },
        [&](std::size_t run, const Ended& ended) {
          parts[run].push_back(ended.finished ? unpacked(ended.said) : lost(ended));
          if (parts[run].size() < repeat) return;
          const Row& row = store(runs_[run], combined(parts[run]));
          ++made_;
          if (watcher_ != nullptr) watcher_->ended(made_, order.size(), row);
        });
  }

  /// Completes a row, puts it into the table, and the table onto the disk.
  const Row& store(const PlannedRun& run, Row row) {
    row.study = study_;
    row.design = run.design;
    row.change = words_of(own_, run.changes);
    row.repeats = options_.repeat;
    for (const Setting& s : changed(own_, run.changes))
      row.settings.emplace_back(s.key, text_of(s.value));
    std::erase_if(rows_, [&](const Row& old) { return old.settings == row.settings; });
    row.run = 1;
    for (const Row& old : rows_) row.run = std::max(row.run, old.run + 1);
    rows_.push_back(std::move(row));
    write_file(table_, to_csv(rows_));
    return rows_.back();
  }

  std::string right_topology() const {
    if (options_.topology.empty()) return "the reference";
    return fmt::format("{} components of Euler characteristic {}", options_.topology[0],
                       options_.topology[1]);
  }

  TradeSummary conclude() {
    TradeSummary summary;
    std::vector<Row> rows;
    for (const PlannedRun& run : runs_)
      if (const Row* row = find(run); row != nullptr) {
        rows.push_back(*row);
        rows.back().design = run.design;
      }
    for (const Row& row : rows) {
      summary.failed += row.failed() ? 1 : 0;
      summary.wrong += !row.failed() && !row.sound() ? 1 : 0;
    }
    summary.title = title_;
    summary.runs = rows.size();
    summary.made = made_;
    write_file(options_.folder / "recommendation.md",
               recommendation(rows, {title_, reference_.words, right_topology(), cell_size_}));
    summary.trouble = draw(rows, {title_, cell_size_, reference_.words}, options_.folder);
    return summary;
  }

  const TradeOptions& options_;
  TradeWatcher* watcher_;
  fs::path table_;
  std::string title_, scene_bits_, study_;
  double cell_size_ = 0;
  Settings own_;
  std::vector<PlannedRun> runs_;
  Reference reference_;
  std::vector<Row> rows_;
  std::size_t made_ = 0;
};

}  // namespace

TradeSummary trade(const TradeOptions& options, TradeWatcher* watcher) {
  return Study(options, watcher).all();
}

}  // namespace suture::sims
