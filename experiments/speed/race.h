#ifndef TETRACONE_EXPERIMENTS_SPEED_RACE_H
#define TETRACONE_EXPERIMENTS_SPEED_RACE_H

#include "experiments/speed/benchmark_workload.h"
#include "experiments/speed/contestant.h"
#include "experiments/speed/timed_poses.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace tetracone::experiments {

/// What it took to make two bodies ready.
struct Build {
  double milliseconds = 0;  ///< the faster of two, where they are fast
  std::size_t bytes = 0;    ///< of the heap in use more than before, the contestant's copy of the meshes included
  double with_first_milliseconds = 0;  ///< where nodes are made on demand: built so, and asked the first hundred poses
  std::size_t nodes_after_one = 0, nodes_after_first = 0;
};

/// How one contestant answered one question on a course: judged by `Race::reference`.
struct Timing : Judged_answers {
  double mean_ns = 0;                ///< of the fastest pass over all poses
  double median_ns = 0, p99_ns = 0;  ///< over the poses, of each the fastest pass, less the least that the clock says
                                     ///< of nothing
  /// Over the poses, the mean of each one's fastest: this contestant's, the first's and FCL's on the very poses that
  /// this one was asked. Ratios of contestants that saw unequal poses are taken from these.
  double same_poses_ns = 0, first_same_poses_ns = 0, fcl_same_poses_ns = 0;
  std::size_t passes = 0;  ///< of each kind: clocked, without the clock, and clocked again; a long one only the first
  tetratree::Query_statistics counts;  ///< of one pass
};

/// A contestant, ready for a course.
struct Prepared_contestant {
  Contestant contestant;
  std::unique_ptr<Prepared_pair> pair;  ///< where that can be, on the trees of a contestant before it; null where the
                                        ///< contestant does not take such bodies
  Build build;
};

/// Contestants on one course: made ready one after the other, asked in turn, pass by pass, so that what slows the
/// machine for a while slows all.
class Race {
 public:
  static constexpr std::size_t first_poses = 100;

  Race(const Race_course& course, const std::vector<Contestant>& contestants);

  const std::vector<Prepared_contestant>& contestants() const { return contestants_; }

  /// Asks all contestants that know the question. After its first pass, one that has had `seconds` of the processor rests.
  /// Absent: not asked.
  std::vector<std::optional<Timing>> run(kernel::Question question, int passes, double seconds);

  /// The answers that all are held against: the first contestant's, which must be exact and see every pose, as FCL must
  /// where it is among them. Checked on a sample by the truth of `verify/truth/cgal_truth.h`, which shares no code with
  /// it: of so many frames, so many were wrong.
  struct Checked {
    std::size_t frames = 0, wrong = 0;
  };
  Checked check(kernel::Question question);

 private:
  const std::vector<char>& reference(kernel::Question question);

  const Race_course& course_;
  std::vector<Prepared_contestant> contestants_;
  std::optional<std::vector<char>> surface_, solid_;
};

}  // namespace tetracone::experiments

#endif
