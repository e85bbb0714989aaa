#include "experiments/speed/course_truth.h"

#include "experiments/peers/peer_wire.h"
#include "experiments/support/output_file.h"
#include "experiments/support/sha256.h"
#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/text_lines.h"
#include "verify/truth/cgal_truth.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <sstream>

namespace tetracone::experiments {
namespace {

using kernel::Pose;

/// Both bodies of a course, prepared; each thread has a copy of the one that rests.
class Truth_teller {
 public:
  explicit Truth_teller(const Race_course& course) : course_(course), a_(course.a), b_(course.b) {}

  /// Adds the truth of poses first to last - 1.
  void tell(std::size_t first, std::size_t last, Course_truth& truth)
  {
    truth.surface.resize(last);
    truth.solid.resize(last);
    tbb::parallel_for(first, last, [&](std::size_t k) {
      const auto both = verify::collide_both(placed_a_.local(), verify::Placed_body(b_, course_.poses_b[k]));
      truth.surface[k] = both.surface;
      truth.solid[k] = both.solid;
    });
  }

 private:
  const Race_course& course_;
  verify::Brute_body a_, b_;
  tbb::enumerable_thread_specific<verify::Placed_body> placed_a_{[this] { return verify::Placed_body(a_, Pose()); }};
};

constexpr const char* header = "surface,solid\n";

std::string text_of(const Course_truth& truth)
{
  std::string text = header;
  for (std::size_t k = 0; k < truth.surface.size(); ++k)
    text += std::string(truth.surface[k] ? "1," : "0,") + (truth.solid[k] ? "1\n" : "0\n");
  return text;
}

Course_truth read_truth(const std::filesystem::path& file, std::size_t most)
{
  Course_truth truth;
  std::istringstream lines(covering::read_bytes(file));
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    const bool is_right =
        number == 1 ? line + '\n' == header : number <= most + 1 && (line == "0,0" || line == "0,1" || line == "1,1");
    if (!is_right)
      throw covering::Input_error(file.native(), number, "'" + line + "' is no truth of this course",
                                  number == 1 ? "expected the names of two columns, surface,solid"
                                              : "expected 0,0 or 0,1 or 1,1, a line a pose; remove the file");
    if (number == 1) continue;
    truth.surface.push_back(line[0] == '1');
    truth.solid.push_back(line[2] == '1');
  }
  return truth;
}

}  // namespace

std::string truth_file(const Race_course& course)
{
  constexpr std::size_t digits = 16;  // 64 bits of the hash are enough for a name
  std::string bytes;
  wire::append(bytes, course.a);
  wire::append(bytes, course.b);
  for (const Pose& pose : course.poses_b) wire::append(bytes, pose.entries());
  return course.name() + "-" + sha256(bytes).substr(0, digits) + ".csv";
}

Course_truth course_truth(const Race_course& course)
{
  Course_truth truth;
  Truth_teller(course).tell(0, course.poses_b.size(), truth);
  return truth;
}

Course_truth kept_course_truth(const Race_course& course, const std::filesystem::path& folder)
{
  make_folder(folder);
  const std::filesystem::path file = folder / truth_file(course);
  Course_truth truth;
  if (std::filesystem::exists(file)) truth = read_truth(file, course.poses_b.size());
  if (truth.surface.size() == course.poses_b.size()) return truth;
  Truth_teller teller(course);
  constexpr std::size_t at_once = 400;  // seconds of work
  while (truth.surface.size() < course.poses_b.size()) {
    const std::size_t first = truth.surface.size();
    teller.tell(first, std::min(first + at_once, course.poses_b.size()), truth);
    write_whole(file, text_of(truth));
  }
  return truth;
}

}  // namespace tetracone::experiments
