#ifndef TETRACONE_EXPERIMENTS_SUPPORT_STOPWATCH_H
#define TETRACONE_EXPERIMENTS_SUPPORT_STOPWATCH_H

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

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

/// Asks each question in each way, pass after pass; within a pass each way answers all questions before the next way
/// begins. ask(way, k) alone is clocked. Returns the fastest time of each question in each way, in nanoseconds.
template <class Ask>
std::vector<std::vector<double>> fastest_times(std::size_t ways, std::size_t questions, int passes, const Ask& ask)
{
  std::vector<std::vector<double>> fastest(ways,
                                           std::vector<double>(questions, std::numeric_limits<double>::infinity()));
  for (int pass = 0; pass < passes; ++pass)
    for (std::size_t way = 0; way < ways; ++way)
      for (std::size_t k = 0; k < questions; ++k) {
        const Stopwatch watch;
        ask(way, k);
        fastest[way][k] = std::min(fastest[way][k], watch.nanoseconds());
      }
  return fastest;
}

/// Returns the sum.
inline double sum_of(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// Returns the mean. Requires a value.
inline double mean_of(const std::vector<double>& values) { return sum_of(values) / double(values.size()); }

}  // namespace tetracone::experiments

#endif
