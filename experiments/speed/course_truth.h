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

/// Returns a file name, NAME-HASH.csv: the course's name, and 16 digits of the hash of its bodies and poses. The hash
/// takes all bits, so that another seed, size or number of frames has another file.
std::string truth_file(const Race_course& course);

}  // namespace tetracone::experiments

#endif
