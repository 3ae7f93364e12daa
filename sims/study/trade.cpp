// Speed against accuracy: a scene run over many choices, each measured for what it costs and gives.
#include "sims/study/trade.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <map>

#include "kernel/errors.h"
#include "kernel/files.h"
#include "kernel/lists.h"
#include "kernel/random.h"
#include "sims/study/report/plot.h"
#include "sims/study/report/recommend.h"
#include "sims/study/table/trade_row.h"
#include "sims/study/trade_run.h"
#include "sims/support/fingerprint.h"
#include "sims/support/process_pool.h"

namespace suture::sims {
namespace {

namespace fs = std::filesystem;

std::vector<PlannedRun> planned(const TradeOptions& o, const Settings& own) {
  const bool given = !o.factors.empty();
  const std::string design = !o.design.empty() ? o.design : given ? "grid" : "both";
  const DesignChoice choice{.one = design != "grid", .grid = design != "one"};
  return plan(own, given ? designs_of(o.factors, own, choice) : default_designs(own, choice));
}

/// Reads each single change as the scene's own, so that a bad one is refused at once.
void require_readable(const fs::path& scene, const std::vector<PlannedRun>& runs) {
  std::map<std::string, bool> seen;
  for (const PlannedRun& run : runs)
    for (const auto& [name, value] : run.changes)
      if (seen.emplace(name + text_of(value), true).second) read_scene(scene, {{name, value}});
}

std::vector<double> all_of(const std::vector<Row>& rows, const char* figure) {
  std::vector<double> values;
  for (const Row& row : rows) values.push_back(row.number(figure));
  return values;
}

/// The row that several processes of a run make: the first that failed, or the medians.
Row combined(const std::vector<Row>& parts) {
  for (const Row& part : parts)
    if (failed(part) && part.text("outcome") != kRefusedRun) return part;
  Row row = parts.front();
  for (const Row& part : parts)
    if (part.text("surface") != row.text("surface")) {
      row.set("outcome", kStoppedRun);
      row.set("failure", "two runs of the same gave different surfaces");
      return row;
    }
  const std::vector<double> seconds = all_of(parts, "tracker_seconds");
  const auto [least, most] = std::minmax_element(seconds.begin(), seconds.end());
  const double middle = median(seconds);
  if (parts.size() > 1 && middle > 0) row.set("seconds_spread", (*most - *least) / middle);
  for (const char* figure : {"tracker_seconds", "remodel_seconds", "improve_seconds",
                             "move_seconds", "total_seconds", "peak_megabytes"})
    row.set(figure, median(all_of(parts, figure)));
  return row;
}

/// The row of a run whose process did not finish.
Row lost(const Ended& ended) {
  return {{"outcome", ended.out_of_time ? kTimedOutRun : kCrashedRun},
          {"failure", ended.words()},
          {"tracker_seconds", ended.cpu_seconds},
          {"total_seconds", ended.cpu_seconds},
          {"peak_megabytes", ended.peak_megabytes}};
}

class Study : public PoolClient {
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
    if (fs::exists(table_)) rows_ = read_trade_table(table_);
    ReferenceOptions how = options_.reference;
    how.limit = options_.processes;
    how.limit.limit_seconds *= 20;  // finer than every run, so dearer than the dearest
    if (watcher_ != nullptr) watcher_->referring();
    reference_ = make_reference({options_.scene, options_.folder, runs_}, how);
    study_ = fingerprint(read_file(options_.scene) + scene_bits_ +
                         fingerprint(read_file(reference_.mesh)) +
                         fmt::format("{}", fmt::join(options_.topology, " ")));
    for (const Row& row : rows_)
      if (row.text("study") != study_ || !same_settings(row))
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

  /// \return whether the row has the settings that this version knows, whatever their values
  bool same_settings(const Row& row) const {
    const SettingTexts theirs = setting_texts(row);
    return std::equal(theirs.begin(), theirs.end(), own_.begin(), own_.end(),
                      [](const auto& cell, const Setting& s) { return cell.first == s.key; });
  }

  /// The row of a planned run, if the table has it with as many repeats.
  Row* find(const PlannedRun& run) {
    const SettingTexts want = texts_of(run);
    const auto at = std::find_if(rows_.begin(), rows_.end(),
                                 [&](const Row& row) { return setting_texts(row) == want; });
    return at == rows_.end() || at->number("repeats") < options_.repeat ? nullptr : &*at;
  }

  SettingTexts texts_of(const PlannedRun& run) const {
    SettingTexts texts;
    for (const Setting& s : changed(own_, run.changes)) texts.emplace_back(s.key, text_of(s.value));
    return texts;
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
    to_make_ = order.size();
    for (const std::size_t run : order)
      tasks_.insert(tasks_.end(), static_cast<std::size_t>(options_.repeat), run);
    run_pool(*this, options_.processes);
  }

  std::optional<ProcessTask> next() override {
    if (tasks_.empty()) return std::nullopt;
    const std::size_t run = tasks_.front();
    tasks_.pop_front();
    return ProcessTask{run, [this, run](const Say& say) {
                         say(packed({run_once({.scene = options_.scene,
                                               .changes = runs_[run].changes,
                                               .reference = reference_.mesh,
                                               .topology = options_.topology,
                                               .surface = {},
                                               .samples = options_.samples})}));
                       }};
  }

  void ended(std::size_t run, const Ended& how) override {
    std::vector<Row>& parts = parts_[run];
    parts.push_back(how.finished ? unpacked(how.said).at(0) : lost(how));
    if (parts.size() < static_cast<std::size_t>(options_.repeat)) return;
    const Row& row = store(runs_[run], combined(parts));
    ++made_;
    if (watcher_ != nullptr) watcher_->ended(made_, to_make_, row);
  }

  /// Completes a row, puts it into the table, and the table onto the disk.
  const Row& store(const PlannedRun& run, const Row& known) {
    const SettingTexts settings = texts_of(run);
    std::erase_if(rows_, [&](const Row& old) { return setting_texts(old) == settings; });
    int number = 1;
    for (const Row& old : rows_) number = std::max(number, run_number(old) + 1);
    Row row = trade_row(settings);
    for (const auto& [column, cell] : known.cells()) row.set(column, cell);
    row.set("run", std::to_string(number));
    row.set("design", run.design);
    row.set("change", words_of(own_, run.changes));
    row.set("repeats", std::to_string(options_.repeat));
    row.set("study", study_);
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
        rows.back().set("design", run.design);
      }
    for (const Row& row : rows) {
      summary.failed += failed(row) ? 1 : 0;
      summary.wrong += !failed(row) && !sound(row) ? 1 : 0;
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
  std::deque<std::size_t> tasks_;  ///< runs still to be started, as often as repeated
  std::map<std::size_t, std::vector<Row>> parts_;  ///< of a run, what its processes made
  std::size_t to_make_ = 0, made_ = 0;
};

}  // namespace

TradeSummary trade(const TradeOptions& options, TradeWatcher* watcher) {
  return Study(options, watcher).all();
}

}  // namespace suture::sims
