// suture trade: a scene over many choices, with what each costs and what it gives.
#include "sims/study/trade.h"

#include <fmt/format.h>
#include <unistd.h>

#include "sims/cli/commands.h"
#include "sims/study/table/trade_row.h"

namespace suture::sims {
namespace {

/// Draws over a single line where somebody watches, and writes a line a run where nobody does.
class TradeProgress : public TradeWatcher {
 public:
  void planned(std::size_t runs, std::size_t there) override {
    fmt::print(stderr, "{} runs, of which {} are in the table already\n", runs, there);
  }
  void referring() override { fmt::print(stderr, "the reference is found or made\n"); }
  void referenced(const Reference& reference) override {
    fmt::print(stderr, "errors are measured against {}\n", reference.words);
  }
  void ended(std::size_t done, std::size_t of, const Row& row) override {
    const bool over = isatty(STDERR_FILENO) == 1;
    const std::string change = row.text("change");
    fmt::print(stderr, "{}[{}/{}] {}: {}, {:.3g} s, mean distance {:.3g}{}", over ? "\r\033[K" : "",
               done, of, change.empty() ? "as it is" : change, row.text("outcome"),
               tracker_seconds(row), mean_distance(row), over && done < of ? "" : "\n");
    std::fflush(stderr);
  }
};

int run_trade(const TradeOptions& options) {
  TradeProgress progress;
  const TradeSummary s = trade(options, &progress);
  fmt::print(
      "{}: {} runs, {} of them now; {} failed, {} ended with the wrong topology; trade.csv, "
      "recommendation.md{} in {}\n",
      s.title, s.runs, s.made, s.failed, s.wrong, s.trouble.empty() ? " and plots" : "",
      options.folder.string());
  if (s.trouble.empty()) return kDone;
  fmt::print(stderr, "{}\n", s.trouble);
  return kBadInput;
}

/// The options of how runs are made, which do not say what is compared.
void add_run_options(CLI::App& command, TradeOptions& o) {
  command
      .add_option("--jobs", o.processes.jobs, "Processes at a time; above 1 seconds are noisier")
      ->check(CLI::Range(1, 1024));
  command.add_option("--repeat", o.repeat, "Processes for each run, whose medians count")
      ->check(CLI::Range(1, 1000));
  command.add_option("--seed", o.seed, "Of the order in which the runs are made");
  command
      .add_option("--limit-seconds", o.processes.limit_seconds,
                  "CPU seconds after which a run has failed; the reference has 20 times that")
      ->check(CLI::Range(1.0, 1e9));
  command.add_option("--samples", o.samples, "Samples on each surface, for distances")
      ->check(CLI::Range(100, 100000000));
}

}  // namespace

void add_trade(CLI::App& app, int& exit) {
  auto o = std::make_shared<TradeOptions>();
  CLI::App* command = app.add_subcommand(
      "trade", "Run a scene over many choices: a table, the Pareto front, a recommendation");
  command->add_option("scene", o->scene, "Scene file")->required()->type_name("SCENE.toml");
  command->add_option("-o,--output", o->folder, "Folder for trade.csv, plots, recommendation.md")
      ->required()
      ->type_name("DIR");
  command
      ->add_option("--factors", o->factors,
                   "What to vary: name=value,value,... for any key of [tracker], [quality] and "
                   "[time]; x0.5 is half of the scene's own; resolution is cell_size and "
                   "edge_length together. Default: each choice alone, and a grid of resolution, "
                   "step and remodel_every")
      ->type_name("NAME=V,V");
  command->add_option("--design", o->design, "one factor at a time, the grid of all, or both")
      ->check(CLI::IsMember({"one", "grid", "both"}));
  command
      ->add_option("--reference", o->reference.kind,
                   "What errors are against: start; flow, the first surface carried by the motion "
                   "alone; finest; or a mesh file. Default: start where the motion brings "
                   "everything back, else finest")
      ->type_name("KIND|FILE");
  command
      ->add_option("--topology", o->topology,
                   "Components and Euler characteristic that are right at the end. Default: the "
                   "reference's")
      ->expected(2);
  command
      ->add_option("--finest", o->reference.finest,
                   "The finer run's cells, edges and steps, times the least of the plan")
      ->check(CLI::Range(0.01, 1.0));
  add_run_options(*command, *o);
  command->callback([o, &exit] { exit = run_trade(*o); });
}

}  // namespace suture::sims
