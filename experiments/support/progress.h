#ifndef TETRACONE_EXPERIMENTS_SUPPORT_PROGRESS_H
#define TETRACONE_EXPERIMENTS_SUPPORT_PROGRESS_H

#include "experiments/support/stopwatch.h"

#include <unistd.h>

#include <cstdio>
#include <string>
#include <utility>

namespace tetracone::experiments {

/// A progress line on stderr: fraction done, count per second, time left. It appears only on a terminal, after two
/// seconds. The destructor clears it.
class Progress {
 public:
  /// `what` names the things that are counted; `total` is their number.
  Progress(std::string what, std::size_t total)
      : what_(std::move(what)), total_(total), shown_(isatty(STDERR_FILENO) != 0)
  {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress()
  {
    if (printed_) std::fputs("\r\033[K", stderr);
  }

  /// Tells that `count` more are done.
  void step(std::size_t count = 1)
  {
    done_ += count;
    if (!shown_) return;
    const double seconds = start_.seconds();
    if (seconds < 2 || (printed_ && last_.seconds() < 0.2)) return;
    last_ = Stopwatch();
    printed_ = true;
    const double rate = done_ / seconds, left = rate > 0 ? (total_ - done_) / rate : 0;
    std::fprintf(stderr, "\r\033[K%s: %zu of %zu (%.0f %%), %.3g a second, %.0f s left", what_.c_str(), done_, total_,
                 100.0 * done_ / total_, rate, left);
    std::fflush(stderr);
  }

 private:
  std::string what_;
  std::size_t total_, done_ = 0;
  bool shown_, printed_ = false;
  Stopwatch start_, last_;
};

}  // namespace tetracone::experiments

#endif
