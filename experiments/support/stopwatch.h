#ifndef TETRACONE_EXPERIMENTS_SUPPORT_STOPWATCH_H
#define TETRACONE_EXPERIMENTS_SUPPORT_STOPWATCH_H

#include <chrono>

namespace tetracone::experiments {

/// The time since it was made.
class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  double milliseconds() const { return 1e3 * seconds(); }
  double nanoseconds() const { return std::chrono::duration<double, std::nano>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace tetracone::experiments

#endif
