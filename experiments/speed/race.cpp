#include "experiments/speed/race.h"

#include "experiments/support/heap.h"

#include <unistd.h>

#include <ctime>
#include <iostream>

namespace tetracone::experiments {
namespace {

using kernel::Pose;
using kernel::Question;

/// A's pose in every frame, made once, outside the time of a query.
const Pose unmoved;

/// Returns the shortest time between two readings of the clock.
double clock_ns()
{
  static const double least = [] {
    double ns = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 1000; ++k) ns = std::min(ns, Stopwatch().nanoseconds());
    return ns;
  }();
  return least;
}

/// Returns the numbers of `Race::cold_poses` poses, evenly spread over the course; for a short course, one in twenty.
std::vector<std::size_t> spread_poses(const Race_course& course)
{
  const std::size_t all = course.poses_b.size(), count = std::min({Race::cold_poses, all / 20 + 1, all});
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < count; ++k) numbers.push_back((2 * k + 1) * all / (2 * count));
  return numbers;
}

/// Empties the processor's caches by writing to twice as many bytes as the system reports for the largest, and to at
/// least 64 MB.
void empty_caches()
{
  constexpr std::size_t line = 64, least = std::size_t(64) << 20;
  static std::vector<unsigned char> buffer(
      std::max(least, 2 * std::size_t(std::max(0L, sysconf(_SC_LEVEL3_CACHE_SIZE)))));
  for (std::size_t k = 0; k < buffer.size(); k += line) ++buffer[k];
}

void clock_first_queries(Prepared_contestant& prepared, const Race_course& course)
{
  const Contestant& contestant = prepared.contestant;
  const auto& how = contestant.prepare_on_demand ? contestant.prepare_on_demand : contestant.prepare;
  constexpr double enough_seconds = 0.5;  // large bodies are made fewer times
  const Stopwatch all;
  double build = 0, query = 0, count = 0;
  for (const std::size_t k : spread_poses(course)) {
    const Stopwatch whole;
    const auto pair = how(course.a, course.b);
    if (!pair) return;
    build += whole.milliseconds();
    const Stopwatch first;
    pair->collide(unmoved, course.poses_b[k], Question::surface);
    query += first.milliseconds();
    ++count;
    if (all.seconds() > enough_seconds) break;
  }
  prepared.build.first_build_milliseconds = build / count;
  prepared.build.first_query_milliseconds = query / count;
}

Prepared_contestant prepare(const Contestant& contestant, const Race_course& course)
{
  Prepared_contestant prepared{contestant, nullptr, {}};
  const auto build = [&](const Contestant::Prepare& how) {
    const Stopwatch watch;
    prepared.pair = how(course.a, course.b);
    return watch.milliseconds();
  };
  if (contestant.clocked_cold) clock_first_queries(prepared, course);
  if (contestant.prepare_on_demand) {
    const Stopwatch watch;
    build(contestant.prepare_on_demand);
    for (std::size_t k = 0; k < std::min(Race::first_poses, course.poses_b.size()); ++k) {
      prepared.pair->collide(unmoved, course.poses_b[k], Question::surface);
      if (k == 0) prepared.build.nodes_after_one = prepared.pair->node_count();
    }
    prepared.build.with_first_milliseconds = watch.milliseconds();
    prepared.build.nodes_after_first = prepared.pair->node_count();
    prepared.pair.reset();
  }
  const std::size_t before = heap_bytes();
  prepared.build.milliseconds = build(contestant.prepare);
  prepared.build.bytes = heap_bytes() - before + (prepared.pair ? prepared.pair->mapped_bytes() : 0);
  constexpr double soon_milliseconds = 25;
  if (!prepared.pair || prepared.build.milliseconds > soon_milliseconds) return prepared;
  prepared.pair.reset();
  prepared.build.milliseconds = std::min(prepared.build.milliseconds, build(contestant.prepare));
  return prepared;
}

/// A contestant's passes over its poses.
class Laps {
 public:
  Laps(Prepared_contestant& prepared, const Race_course& course, Question question, const std::vector<char>& truth)
      : prepared_(prepared), course_(course), question_(question), poses_(truth, prepared.contestant.one_in)
  {}

  const Timed_poses& poses() const { return poses_; }

  /// Returns the processor time of all passes.
  double seconds() const { return seconds_; }

  void lap()
  {
    if (timing_.passes == 0) prepared_.pair->take_counts();
    const std::clock_t start = std::clock();  // processor time: waiting for a core does not count
    const Stopwatch watch;                    // of a program's pass, whose processor time is not ours
    double mean = poses_.pass([this](std::size_t k) { return collide(k); }, clock_ns(),
                              [this](double weight) {
                                if (timing_.passes == 0)
                                  timing_.counts += weighted(prepared_.pair->take_counts(), weight);
                              },
                              [this] { return prepared_.pair->own_ns(); });
    ++timing_.passes;
    if (prepared_.pair->own_ns()) {
      mean_ = std::min(mean_, mean);
      seconds_ += watch.seconds();
      return;
    }
    // For fast queries the mean is taken from a pass without the clock, whose own time matters. The poses are timed
    // again after it, when the caches no longer hold the previous contestant's data.
    constexpr double long_ns = 1e8;
    if (mean * double(poses_.judged().poses) < long_ns) {
      mean = poses_.pass_without_clock([this](std::size_t k) { found_ += collide(k); });
      poses_.pass([this](std::size_t k) { return collide(k); }, clock_ns(), [](double) {});
    }
    mean_ = std::min(mean_, mean);
    seconds_ += double(std::clock() - start) / CLOCKS_PER_SEC;
  }

  /// Times one pose at a time with empty caches, after the passes. Requires a contestant that is asked every pose.
  void clock_cold()
  {
    const auto numbers = spread_poses(course_);
    timing_.cold_ns = timing_.warm_ns = 0;
    for (const std::size_t k : numbers) {
      empty_caches();
      const Stopwatch watch;
      found_ += collide(k);
      timing_.cold_ns += std::max(0.0, watch.nanoseconds() - clock_ns()) / double(numbers.size());
      timing_.warm_ns += poses_.fastest_ns()[k] / double(numbers.size());
    }
  }

  Timing timing() const
  {
    Timing timing = timing_;
    static_cast<Judged_answers&>(timing) = poses_.judged();
    timing.mean_ns = mean_;
    timing.median_ns = poses_.quantile_ns(0.5);
    timing.p99_ns = poses_.quantile_ns(0.99);
    return timing;
  }

 private:
  bool collide(std::size_t k) { return prepared_.pair->collide(unmoved, course_.poses_b[k], question_); }

  Prepared_contestant& prepared_;
  const Race_course& course_;
  Question question_;
  Timed_poses poses_;
  double mean_ = std::numeric_limits<double>::infinity(), seconds_ = 0;
  std::size_t found_ = 0;  // uses the answers
  Timing timing_;
};

}  // namespace

Race::Race(const Race_course& course, const Course_truth& truth, const std::vector<Contestant>& contestants)
    : course_(course), truth_(truth)
{
  for (const Contestant& contestant : contestants) {
    Prepared_contestant prepared = prepare(contestant, course);
    std::unique_ptr<Prepared_pair> shared;
    for (std::size_t k = 0; k < contestants_.size() && !shared; ++k)
      if (prepared.pair && contestants_[k].pair && contestant.share) shared = contestant.share(*contestants_[k].pair);
    if (shared) prepared.pair = std::move(shared);
    contestants_.push_back(std::move(prepared));
  }
}

std::vector<std::optional<Timing>> Race::run(Question question, int passes, double seconds)
{
  std::vector<std::optional<Laps>> laps;
  for (Prepared_contestant& prepared : contestants_) {
    laps.emplace_back();
    if (prepared.pair && (question == Question::surface || prepared.contestant.knows_solids))
      laps.back().emplace(prepared, course_, question, truth_.of(question));
  }
  for (int pass = 0; pass < passes; ++pass)
    for (auto& each : laps) try {
        if (each && (pass == 0 || each->seconds() < seconds)) each->lap();
      } catch (const No_answer& what) {
        std::cerr << what.what() << "; it has no row of " << course_.scenario << ", " << to_string(question) << '\n';
        each.reset();
      }
  if (question == Question::surface)
    for (std::size_t k = 0; k < laps.size(); ++k)
      if (laps[k] && contestants_[k].contestant.clocked_cold) laps[k]->clock_cold();
  std::vector<std::optional<Timing>> timings;
  const Laps* fcl = nullptr;
  for (std::size_t k = 0; k < laps.size(); ++k)
    if (laps[k] && contestants_[k].contestant.name == "FCL OBBRSS") fcl = &*laps[k];
  for (const auto& each : laps) {
    timings.emplace_back();
    if (!each) continue;
    timings.back() = each->timing();
    timings.back()->same_poses_ns = each->poses().mean_ns(each->poses());
    timings.back()->first_same_poses_ns = laps[0]->poses().mean_ns(each->poses());
    if (fcl) timings.back()->fcl_same_poses_ns = fcl->poses().mean_ns(each->poses());
  }
  return timings;
}

}  // namespace tetracone::experiments
