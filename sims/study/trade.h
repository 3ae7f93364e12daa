// Speed against accuracy: a scene run over many choices, each measured for what it costs and gives.
#pragma once

#include "sims/study/reference.h"
#include "sims/study/table/row.h"

namespace suture::sims {

/// The plan of a study.
struct TradeOptions {
  std::filesystem::path scene, folder;
  std::vector<std::string> factors;  ///< as read_factor has them; empty: the default ones
  std::string design;                ///< "one", "grid", "both"; empty: both with the default
                                     ///< factors, a grid with given ones
  ReferenceOptions reference;
  std::vector<std::int64_t> topology;  ///< components and Euler characteristic that are right at
                                       ///< the end; empty: the reference's
  ProcessOptions processes;
  std::uint64_t seed = 1;  ///< of the order in which runs are made, so that a drift of the
                           ///< machine's speed does not follow the plan
  int repeat = 1;          ///< processes for each run, whose medians count
  std::size_t samples = 20000;
};

/// Hears of a study as it goes.
class TradeWatcher {
 public:
  virtual ~TradeWatcher() = default;
  virtual void referring() = 0;  ///< the reference is made next, which may take long
  virtual void planned(std::size_t runs, std::size_t there) = 0;  ///< of which `there` are in the
                                                                  ///< table already
  virtual void referenced(const Reference& reference) = 0;
  virtual void ended(std::size_t done, std::size_t of, const Row& row) = 0;
};

struct TradeSummary {
  std::string title;
  std::size_t runs = 0, made = 0, failed = 0, wrong = 0;  ///< wrong: topology not the right one
  std::string trouble;  ///< why there are no pictures, and what to do; or empty
};

/// Makes the runs that the folder's trade.csv lacks, each in processes of its own, and writes the
/// table after each; then the plots and recommendation.md, of the plan's runs only. A run that
/// crashes, runs out of time or is refused is a row that says so. \throw InvalidInput for bad
/// factors and a bad scene, before anything is run; and for a folder with a study of another scene
TradeSummary trade(const TradeOptions& options, TradeWatcher* watcher = nullptr);

}  // namespace suture::sims
