#ifndef TETRACONE_EXPERIMENTS_SPEED_TIMED_POSES_H
#define TETRACONE_EXPERIMENTS_SPEED_TIMED_POSES_H

#include "experiments/support/stopwatch.h"
#include "tetracone/tetratree/query_statistics.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace tetracone::experiments {

/// Answers compared with the truth, and the course of their poses.
struct Judged_answers {
  std::size_t poses = 0, collisions = 0, false_positives = 0, false_negatives = 0;
  std::size_t course_poses = 0, course_collisions = 0;

  /// Returns how the course's values are estimated from these poses.
  const char* estimator() const { return poses == course_poses ? "every pose" : "hits and misses by their share"; }
};

/// Poses of one kind; each represents `weight` poses of the course.
struct Stratum {
  std::vector<std::size_t> numbers;
  double weight = 1;
};

/// Returns `count` of these poses, evenly spread. Requires 1 <= count <= of.size().
inline Stratum spread_sample(const std::vector<std::size_t>& of, std::size_t count)
{
  Stratum sample;
  for (std::size_t k = 0; k < count; ++k) sample.numbers.push_back(of[(2 * k + 1) * of.size() / (2 * count)]);
  sample.weight = double(of.size()) / double(count);
  return sample;
}

/// Returns the counts, each times the weight, rounded.
inline tetratree::Query_statistics weighted(const tetratree::Query_statistics& counts, double weight)
{
  using Fields = std::array<std::uint64_t, sizeof(counts) / sizeof(std::uint64_t)>;
  auto fields = std::bit_cast<Fields>(counts);
  for (std::uint64_t& field : fields) field = std::uint64_t(std::llround(weight * double(field)));
  return std::bit_cast<tetratree::Query_statistics>(fields);
}

/// The own clock of a contestant without one.
struct No_own_clock {
  std::optional<double> operator()() const { return std::nullopt; }
};

/// The poses that one contestant is asked, pass by pass. Each pose is timed separately and keeps its fastest time. The
/// answers of the first pass are judged.
///
/// A contestant that is not asked every pose gets equally many colliding and separate poses, as far as there are
/// enough. The colliding ones are few and take longest. Times are weighted by the fraction of each kind in the course.
/// Each is therefore an estimate of its value over the whole course.
class Timed_poses {
 public:
  /// Takes one in `one_in` poses of `truth`, which must outlive this; if it is 1, all poses in their order.
  Timed_poses(const std::vector<char>& truth, std::size_t one_in) : truth_(truth), has_all_(one_in == 1)
  {
    std::vector<std::size_t> hits, others;  // all are others where none is left out
    for (std::size_t k = 0; k < truth.size(); ++k) (truth[k] && !has_all_ ? hits : others).push_back(k);
    const std::size_t count = (truth.size() + one_in - 1) / one_in, half = std::min(hits.size(), (count + 1) / 2);
    const std::size_t of_hits = std::max(half, count - std::min(count, others.size()));
    const std::size_t of_others = std::min(others.size(), std::max<std::size_t>(1, count - of_hits));
    if (of_others > 0) strata_.push_back(spread_sample(others, of_others));
    if (of_hits > 0) strata_.push_back(spread_sample(hits, of_hits));
    for (const Stratum& stratum : strata_) judged_.poses += stratum.numbers.size();
    fastest_.assign(judged_.poses, std::numeric_limits<double>::infinity());
    judged_.course_poses = truth.size();
    judged_.course_collisions = truth.size() - std::size_t(std::ranges::count(truth, 0));
  }

  const std::vector<Stratum>& strata() const { return strata_; }
  const Judged_answers& judged() const { return judged_; }

  /// Runs one pass, in which `answer(k)` answers pose k. `clock_ns`, the clock's own time, is subtracted from the time
  /// of each pose. Where `own_ns()` tells the time of the last answer, that one counts. After each stratum it calls
  /// `done` with the stratum's weight. Returns the course's mean in nanoseconds.
  template <class Answer, class Done, class Own_clock = No_own_clock>
  double pass(const Answer& answer, double clock_ns, const Done& done, const Own_clock& own_ns = {})
  {
    double total = 0;
    std::size_t place = 0;
    for (const Stratum& stratum : strata_) {
      for (const std::size_t k : stratum.numbers) {
        const Stopwatch watch;
        const int told = answer(k);
        const double watched = watch.nanoseconds();
        const double ns = own_ns().value_or(std::max(0.0, watched - clock_ns));
        total += stratum.weight * ns;
        fastest_[place] = std::min(fastest_[place], ns);
        ++place;
        if (is_first_) judge(told, truth_[k]);
      }
      done(stratum.weight);
    }
    is_first_ = false;
    return total / double(truth_.size());
  }

  /// Runs one pass without timing single poses. Returns the course's mean in nanoseconds.
  template <class Collide>
  double pass_without_clock(const Collide& collide) const
  {
    double total = 0;
    for (const Stratum& stratum : strata_) {
      const Stopwatch watch;
      for (const std::size_t k : stratum.numbers) collide(k);
      total += stratum.weight * watch.nanoseconds();
    }
    return total / double(truth_.size());
  }

  /// Returns the course's mean of the fastest times, from the poses of `other`. Requires that `*this` has all poses, or
  /// is `other`.
  double mean_ns(const Timed_poses& other) const
  {
    double total = 0;
    std::size_t place = 0;
    for (const Stratum& stratum : other.strata_)
      for (const std::size_t k : stratum.numbers) total += stratum.weight * fastest_[has_all_ ? k : place++];
    return total / double(truth_.size());
  }

  /// Returns the fastest time of each pose, in the order of `strata()`.
  const std::vector<double>& fastest_ns() const { return fastest_; }

  /// Returns the quantile of the fastest times: a fraction `share` of the course's poses has a shorter one.
  double quantile_ns(double share) const
  {
    std::vector<std::pair<double, double>> times;  // with the weight of each
    std::size_t place = 0;
    for (const Stratum& stratum : strata_)
      for (std::size_t i = 0; i < stratum.numbers.size(); ++i) times.emplace_back(fastest_[place++], stratum.weight);
    std::ranges::sort(times);
    double below = share * double(truth_.size());
    for (const auto& [ns, weight] : times)
      if ((below -= weight) < 0) return ns;
    return times.back().first;
  }

 private:
  void judge(int told, int truth)
  {
    judged_.collisions += truth > 0;
    judged_.false_positives += told > truth;
    judged_.false_negatives += told < truth;
  }

  const std::vector<char>& truth_;
  bool has_all_;
  std::vector<Stratum> strata_;
  std::vector<double> fastest_;
  Judged_answers judged_;
  bool is_first_ = true;
};

}  // namespace tetracone::experiments

#endif
