#ifndef TETRACONE_COVERING_IO_READ_RIGID_POSES_H
#define TETRACONE_COVERING_IO_READ_RIGID_POSES_H

#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/read_poses.h"
#include "tetracone/covering/io/text_lines.h"
#include "tetracone/kernel/motion/body_motion.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace tetracone::covering {

/// A rigid pose, and the line of the file that it is on.
struct Rigid_pose_line {
  kernel::Rigid_pose pose;
  std::size_t line = 0;
};

/// The rigid poses of a text file: one a line, seven numbers, `w x y z` of a quaternion of any length above 0 and the
/// translation; decimals or fractions. '#' starts a comment, blank lines are skipped. Throws Input_error where a line
/// holds another count of numbers, a number is none or is not finite, the quaternion is 0, or the file holds no pose.
inline std::vector<Rigid_pose_line> read_rigid_poses(const std::filesystem::path& file)
{
  const std::string text = read_text(file);
  Text_lines lines(file.native(), text, '#');
  std::vector<Rigid_pose_line> poses;
  while (lines.next()) {
    const auto numbers = read_numbers<7>(lines, "a quaternion w x y z and a translation");
    Rigid_pose_line pose{{}, lines.line()};
    bool is_zero = true;
    for (std::size_t k = 0; k < 4; ++k) {
      pose.pose.quaternion[k] = numbers[k].exact();
      is_zero = is_zero && pose.pose.quaternion[k] == 0;
    }
    if (is_zero) lines.fail("the quaternion is 0", "expected one of any other length");
    for (std::size_t k = 0; k < 3; ++k) pose.pose.translation[k] = numbers[4 + k].exact();
    poses.push_back(pose);
  }
  if (poses.empty()) throw Input_error(file.native(), 0, "holds no pose", "expected seven numbers a line");
  return poses;
}

}  // namespace tetracone::covering

#endif
