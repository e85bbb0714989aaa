#include "experiments/speed/race.h"

#include "experiments/support/stopwatch.h"
#include "verify/truth/cgal_truth.h"

#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <utility>

namespace tetracone::experiments {
namespace {

using kernel::Pose;
using kernel::Question;

/// A's pose in every frame: made once, outside the time of a query.
const Pose unmoved;

/// The shortest time that the clock tells between two readings.
double clock_ns()
{
  static const double least = [] {
    double ns = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 1000; ++k) ns = std::min(ns, Stopwatch().nanoseconds());
    return ns;
  }();
  return least;
}

/// The bytes of the heap that are in use.
std::size_t heap()
{
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

Prepared_contestant prepare(const Contestant& contestant, const Race_course& course)
{
  Prepared_contestant prepared{contestant, nullptr, {}};
  const auto build = [&](const Contestant::Prepare& how) {
    const Stopwatch watch;
    prepared.pair = how(course.a, course.b);
    return watch.milliseconds();
  };
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
  const std::size_t before = heap();
  prepared.build.milliseconds = build(contestant.prepare);
  prepared.build.bytes = heap() - before + (prepared.pair ? prepared.pair->mapped_bytes() : 0);
  constexpr double soon_milliseconds = 100;
  if (!prepared.pair || prepared.build.milliseconds > soon_milliseconds) return prepared;
  prepared.pair.reset();
  prepared.build.milliseconds = std::min(prepared.build.milliseconds, build(contestant.prepare));
  return prepared;
}

/// A contestant's passes over its poses.
class Laps {
 public:
  Laps(Prepared_contestant& prepared, const Race_course& course, Question question, const std::vector<char>& reference)
      : prepared_(prepared), course_(course), question_(question), poses_(reference, prepared.contestant.one_in)
  {}

  const Timed_poses& poses() const { return poses_; }

  /// Processor time of all laps.
  double seconds() const { return seconds_; }

  void lap()
  {
    if (timing_.passes == 0) prepared_.pair->take_counts();
    const std::clock_t start = std::clock();  // processor time: waiting for a core does not count
    double mean = clocked_pass();
    if (timing_.passes == 0) timing_.counts = prepared_.pair->take_counts();
    ++timing_.passes;
    // Fast queries: the mean is of a pass without the clock, whose own time matters. The poses are clocked again after
    // it: the caches are no longer those that the contestant before has filled.
    constexpr double long_ns = 1e8;
    if (mean * double(poses_.numbers().size()) < long_ns) {
      mean = pass();
      clocked_pass();
    }
    mean_ = std::min(mean_, mean);
    seconds_ += double(std::clock() - start) / CLOCKS_PER_SEC;
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
  /// One pass without the clock: the mean time of a pose.
  double pass()
  {
    const Stopwatch watch;
    for (const std::size_t k : poses_.numbers()) found_ += collide(k);
    return watch.nanoseconds() / poses_.numbers().size();
  }

  double clocked_pass()
  {
    return poses_.pass([this](std::size_t k) { return collide(k); }, clock_ns());
  }

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

Race::Race(const Race_course& course, const std::vector<Contestant>& contestants) : course_(course)
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
  const auto& answers = reference(question);
  std::vector<std::optional<Laps>> laps;
  for (Prepared_contestant& prepared : contestants_) {
    laps.emplace_back();
    if (prepared.pair && (question == Question::surface || prepared.contestant.knows_solids))
      laps.back().emplace(prepared, course_, question, answers);
  }
  for (int pass = 0; pass < passes; ++pass)
    for (auto& each : laps)
      if (each && (pass == 0 || each->seconds() < seconds)) each->lap();
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

const std::vector<char>& Race::reference(Question question)
{
  auto& known = question == Question::surface ? surface_ : solid_;
  if (known) return *known;
  known.emplace();
  for (const Pose& pose : course_.poses_b) known->push_back(contestants_[0].pair->collide(unmoved, pose, question));
  return *known;
}

Race::Checked Race::check(Question question)
{
  const auto& answers = reference(question);
  const std::size_t faces = course_.a.face_count() + course_.b.face_count(), wanted = faces > 20000 ? 1 : 6;
  const verify::Brute_body a(course_.a), b(course_.b);
  Checked checked;
  for (const bool hit : {false, true}) {
    std::vector<std::size_t> frames;
    for (std::size_t k = 0; k < answers.size(); ++k)
      if (bool(answers[k]) == hit) frames.push_back(k);
    const std::size_t stride = std::max<std::size_t>(1, frames.size() / wanted);
    for (std::size_t i = 0, asked = 0; i < frames.size() && asked < wanted; i += stride, ++asked) {
      ++checked.frames;
      checked.wrong += verify::collide(a, unmoved, b, course_.poses_b[frames[i]], question) != hit;
    }
  }
  return checked;
}

}  // namespace tetracone::experiments
