#ifndef TETRACONE_EXPERIMENTS_SPEED_COURSE_TRUTH_H
#define TETRACONE_EXPERIMENTS_SPEED_COURSE_TRUTH_H

#include "experiments/speed/benchmark_workload.h"
#include "tetracone/kernel/predicate/question.h"

namespace tetracone::experiments {

/// The right answers of every pose of a course to both questions: 1 if the bodies share a point, else 0.
struct Course_truth {
  std::vector<char> surface, solid;

  const std::vector<char>& of(kernel::Question question) const
  {
    return question == kernel::Question::surface ? surface : solid;
  }
};

/// Returns the truth of a course by `verify/truth/cgal_truth.h`, which shares no tree and no predicate with our
/// contestants. Every pair of elements whose outward-rounded boxes meet is decided, in rationals where intervals are
/// not certain. Requires closed bodies with planar faces. It uses all processors: call it before anything is timed.
Course_truth course_truth(const Race_course& course);

/// As above, with the truth saved in `folder` under a name that encodes its whole input (see `truth_file`), and read
/// from there the next time. A part that was saved before the program was stopped is continued. Throws
/// covering::Input_error when the file cannot be written, or belongs to another course.
Course_truth kept_course_truth(const Race_course& course, const std::filesystem::path& folder);

/// Returns the course's name and a hash of its bodies and poses, to the last bit; these depend on seed, size and
/// frames.
std::string truth_file(const Race_course& course);

}  // namespace tetracone::experiments

#endif
