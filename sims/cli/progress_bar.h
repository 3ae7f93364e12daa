// A progress bar for people; silent where nobody watches.
#pragma once

#include "sims/driver/run.h"

namespace suture::sims {

/// Draws on standard error, and only where that is a terminal.
class ProgressBar : public RunWatcher {
 public:
  ProgressBar();
  ~ProgressBar() override;
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void stepped(const Progress& progress) override;

 private:
  bool terminal_;
  bool drawn_ = false;
};

}  // namespace suture::sims
