#ifndef TETRACONE_COVERING_IO_READ_RIGID_POSES_H
#define TETRACONE_COVERING_IO_READ_RIGID_POSES_H

#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/read_numbers.h"
#include "tetracone/covering/io/read_poses.h"
#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/kernel/motion/rotation_quaternion.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace tetracone::covering {

/// A rigid pose, and the line of the file that it begins on.
struct Rigid_pose_line {
  kernel::Rigid_pose pose;
  std::size_t line = 0;
  /// The largest difference between an entry of the matrix and of the quaternion's rotation, rounded to nearest. It is
  /// set where the pose is a matrix. The sign of such a quaternion is arbitrary.
  std::optional<double> matrix_error = {};
};

/// Returns the rigid poses of a text file, one a line. A pose is seven numbers, `w x y z` of a quaternion of any length
/// above 0 and the translation. It may also be a matrix as `read_pose` takes it, which must be a rotation
/// (`kernel::rotation_quaternion`). Numbers are decimals or fractions. Throws Input_error as `read_pose` and
/// `Number_lines`, where the quaternion is 0 or the matrix no rotation, and where the file holds no pose.
inline std::vector<Rigid_pose_line> read_rigid_poses(const std::filesystem::path& file)
{
  Number_lines lines(file);
  std::vector<Rigid_pose_line> poses;
  while (lines.next()) {
    Rigid_pose_line pose{{}, lines.line()};
    if (lines.words().size() == 7) {
      bool is_zero = true;
      for (std::size_t k = 0; k < 4; ++k) {
        pose.pose.quaternion[k] = lines.number(k).exact();
        is_zero = is_zero && pose.pose.quaternion[k] == 0;
      }
      if (is_zero) lines.fail("the quaternion is 0", "expected one of any other length");
      for (std::size_t k = 0; k < 3; ++k) pose.pose.translation[k] = lines.number(4 + k).exact();
    } else {
      const kernel::Pose matrix = read_pose(
          lines, "expected 7, a quaternion w x y z and a translation, or the 12 or 16 of a matrix that is a rotation");
      const auto rotation = kernel::rotation_quaternion(matrix);
      if (!rotation)
        lines.fail("the 3x3 part is no rotation",
                   "expected one to 1e-5 in each entry, or a quaternion w x y z and a translation");
      pose.pose.quaternion = rotation->quaternion;
      for (std::size_t k = 0; k < 3; ++k) pose.pose.translation[k] = matrix.exact(int(4 * k + 3));
      pose.matrix_error = rotation->error;
    }
    poses.push_back(pose);
  }
  if (poses.empty()) throw Input_error(lines.file(), 0, "holds no pose", "expected seven numbers a line");
  return poses;
}

}  // namespace tetracone::covering

#endif
