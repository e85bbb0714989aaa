#ifndef TETRACONE_EXPERIMENTS_SPEED_RACE_H
#define TETRACONE_EXPERIMENTS_SPEED_RACE_H

#include "experiments/speed/contestant.h"
#include "experiments/speed/course_truth.h"
#include "experiments/speed/timed_poses.h"

namespace tetracone::experiments {

/// The cost of preparing two bodies.
struct Build {
  double milliseconds = 0;             ///< the faster of two builds, if they are fast
  std::size_t bytes = 0;               ///< growth of the heap and mapped bytes; the contestant's meshes included
  double with_first_milliseconds = 0;  ///< if nodes are built on demand: building and asking the first hundred poses
  /// If nodes are built on demand: their number after the first pose, and after the first hundred.
  std::size_t nodes_after_one = 0, nodes_after_first = 0;
  /// For a `clocked_cold` contestant: milliseconds to prepare it (on demand where it can) and to answer the first
  /// surface question then. Both are means over at most `Race::cold_poses` poses, each asked of newly made bodies.
  double first_build_milliseconds = 0, first_query_milliseconds = 0;
};

/// One contestant's answers to one question on a course, judged by the truth.
struct Timing : Judged_answers {
  double mean_ns = 0;                ///< over the course, in the fastest pass
  double median_ns = 0, p99_ns = 0;  ///< over the course, of each pose's fastest time, less the clock's own
  /// The means of the fastest times in the poses that this contestant was asked: its own, the first contestant's and
  /// FCL's. Ratios of contestants that were asked different poses are computed from these.
  double same_poses_ns = 0, first_same_poses_ns = 0, fcl_same_poses_ns = 0;
  /// The means of two kinds of times, for a `clocked_cold` contestant and the surface question. The cold one is over
  /// `Race::cold_poses` poses with the caches emptied before each. The warm one is of the fastest times in the same
  /// poses.
  double cold_ns = 0, warm_ns = 0;
  std::size_t passes = 0;  ///< each is timed, run without the clock, and timed again; a long one is timed once
  tetratree::Query_statistics counts;  ///< work of one pass, weighted to all poses of the course
};

/// A contestant, prepared for a course.
struct Prepared_contestant {
  Contestant contestant;
  std::unique_ptr<Prepared_pair> pair;  ///< where that can be, on the trees of a contestant before it; null where the
                                        ///< contestant does not take such bodies
  Build build;
};

/// Contestants on one course. They are prepared one after the other and asked in turn, pass by pass, so that a
/// temporary slowdown of the machine affects all.
class Race {
 public:
  /// The numbers of poses that are asked first of nodes built on demand, and asked cold. A short course has fewer.
  static constexpr std::size_t first_poses = 100, cold_poses = 16;

  /// Requires that both outlive the race. The others are compared with the first contestant, which must be asked every
  /// pose; so must FCL, if it takes part.
  Race(const Race_course& course, const Course_truth& truth, const std::vector<Contestant>& contestants);

  const std::vector<Prepared_contestant>& contestants() const { return contestants_; }

  /// Asks all contestants that know the question, in at most `passes` passes. After its first pass, a contestant that
  /// has used `seconds` of processor time is asked no more. Returns nothing for one that was not asked. It also returns
  /// nothing for a program that declined a pose or failed, with a line on stderr.
  std::vector<std::optional<Timing>> run(kernel::Question question, int passes, double seconds);

 private:
  const Race_course& course_;
  const Course_truth& truth_;
  std::vector<Prepared_contestant> contestants_;
};

}  // namespace tetracone::experiments

#endif
