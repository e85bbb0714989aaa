#ifndef TETRACONE_EXPERIMENTS_SPEED_TIMED_POSES_H
#define TETRACONE_EXPERIMENTS_SPEED_TIMED_POSES_H

#include "experiments/support/stopwatch.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace tetracone::experiments {

/// Answers held against the truth.
struct Judged_answers {
  std::size_t poses = 0, collisions = 0, false_positives = 0, false_negatives = 0;
};

/// The poses that one contestant is asked, pass by pass, each clocked for itself: the fastest time of each pose is
/// kept, the answers of the first pass are judged.
class Timed_poses {
 public:
  /// Every `one_in`-th of the poses of `truth`, which must outlive this.
  Timed_poses(const std::vector<char>& truth, std::size_t one_in) : truth_(truth), one_in_(one_in)
  {
    for (std::size_t k = 0; k < truth.size(); k += one_in) numbers_.push_back(k);
    fastest_.assign(numbers_.size(), std::numeric_limits<double>::infinity());
    judged_.poses = numbers_.size();
  }

  /// The numbers of the poses.
  const std::vector<std::size_t>& numbers() const { return numbers_; }

  const Judged_answers& judged() const { return judged_; }

  /// One pass: `collide(k)` is the answer in pose k. `clock_ns`, what the clock itself takes, is subtracted from the
  /// time of each pose. Returns the mean in nanoseconds.
  template <class Collide>
  double pass(const Collide& collide, double clock_ns = 0)
  {
    double total = 0;
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      const Stopwatch watch;
      const bool answer = collide(numbers_[i]);
      const double ns = std::max(0.0, watch.nanoseconds() - clock_ns);
      total += ns;
      fastest_[i] = std::min(fastest_[i], ns);
      if (is_first_) judge(answer, truth_[numbers_[i]]);
    }
    is_first_ = false;
    return total / numbers_.size();
  }

  /// The mean of the fastest times in the poses of `other`. Requires that these poses contain those.
  double mean_ns(const Timed_poses& other) const
  {
    const std::size_t step = other.one_in_ / one_in_;
    double total = 0;
    for (std::size_t i = 0; i < other.numbers_.size(); ++i) total += fastest_[i * step];
    return total / other.numbers_.size();
  }

  /// The fastest time of each pose of `numbers()`.
  const std::vector<double>& fastest_ns() const { return fastest_; }

  /// The fastest time of a pose, such that `share` of the poses have a shorter one.
  double quantile_ns(double share) const
  {
    std::vector<double> sorted = fastest_;
    const std::size_t at = std::min(sorted.size() - 1, static_cast<std::size_t>(share * sorted.size()));
    std::nth_element(sorted.begin(), sorted.begin() + at, sorted.end());
    return sorted[at];
  }

 private:
  void judge(bool answer, bool truth)
  {
    judged_.collisions += truth;
    judged_.false_positives += answer && !truth;
    judged_.false_negatives += !answer && truth;
  }

  const std::vector<char>& truth_;
  std::size_t one_in_;
  std::vector<std::size_t> numbers_;
  std::vector<double> fastest_;
  Judged_answers judged_;
  bool is_first_ = true;
};

}  // namespace tetracone::experiments

#endif
