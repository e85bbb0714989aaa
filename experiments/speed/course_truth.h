#ifndef TETRACONE_EXPERIMENTS_SPEED_COURSE_TRUTH_H
#define TETRACONE_EXPERIMENTS_SPEED_COURSE_TRUTH_H

#include "experiments/speed/benchmark_workload.h"
#include "tetracone/kernel/predicate/question.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tetracone::experiments {

/// The right answer of every pose of a course, to both questions: 1 where the bodies share a point, else 0.
struct Course_truth {
  std::vector<char> surface, solid;

  const std::vector<char>& of(kernel::Question question) const
  {
    return question == kernel::Question::surface ? surface : solid;
  }
};

/// The truth about a course by `verify/truth/cgal_truth.h`, which shares no tree and no predicate with the contestants
/// of ours: every pair of elements whose outward-rounded boxes meet is decided, in rationals where intervals are not
/// certain. Requires closed bodies with planar faces. On all processors: call it before anything is clocked.
Course_truth course_truth(const Race_course& course);

/// The same, kept in `folder` under a name that tells all that the truth depends on (see `truth_file`), and read there
/// the next time; what is there of a course when the program was stopped is gone on with. Throws covering::Input_error
/// when the file cannot be written, or is not one of this course's.
Course_truth kept_course_truth(const Race_course& course, const std::filesystem::path& folder);

/// The course's name and a hash of its bodies and poses, to the last bit: seed, size and frames are in these.
std::string truth_file(const Race_course& course);

}  // namespace tetracone::experiments

#endif
