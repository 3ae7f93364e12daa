// A progress bar for people; silent where nobody watches.
#include "sims/cli/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace suture::sims {

ProgressBar::ProgressBar() : terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (drawn_) fmt::print(stderr, "\n");
}

void ProgressBar::stepped(const Progress& p) {
  if (!terminal_) return;
  constexpr std::int64_t width = 32;
  const std::int64_t full = width * p.step / p.steps;
  fmt::print(stderr, "\r[{:#<{}}{:.<{}}] {}/{}  t = {:.3f}  {} triangles  {} components   ", "",
             full, "", width - full, p.step, p.steps, p.time, p.triangles, p.components);
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace suture::sims
