#ifndef TETRACONE_COVERING_IO_READ_POSES_H
#define TETRACONE_COVERING_IO_READ_POSES_H

#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/read_numbers.h"
#include "tetracone/kernel/number/pose.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace tetracone::covering {

/// Returns the pose whose matrix begins on the current line; the last line read is then the current one. A matrix is 12
/// numbers, row-major 3x4; 16, row-major 4x4; or a row of four on each of four lines. The last row of a 4x4 matrix is 0
/// 0 0 1. Throws Input_error for another count, another last row, or det M exactly 0. `expected` is the text for a
/// wrong count.
inline kernel::Pose read_pose(Number_lines& lines, const std::string& expected)
{
  std::array<Number, 16> numbers;
  std::size_t count = 0;
  const auto take = [&] {
    for (std::size_t k = 0; k < lines.words().size(); ++k) numbers[count++] = lines.number(k);
  };
  switch (lines.words().size()) {
    case 12:
    case 16: take(); break;
    case 4:
      for (int row = 1; row <= 4; ++row) {
        if (row > 1) lines.need_next("expected row " + std::to_string(row) + " of a 4x4 matrix");
        if (lines.words().size() != 4)
          lines.fail(lines.found(), "expected 4, row " + std::to_string(row) + " of a 4x4 matrix");
        take();
      }
      break;
    default: lines.fail(lines.found(), expected);
  }
  if (count == 16)
    for (std::size_t k = 12; k < 16; ++k)
      if (numbers[k].exact() != (k == 15 ? 1 : 0))
        lines.fail("the last row of a 4x4 matrix is another", "expected 0 0 0 1");

  bool fractions = false;
  std::array<double, 12> nearest;
  std::array<kernel::Rational, 12> exact;
  for (std::size_t k = 0; k < 12; ++k) {
    nearest[k] = numbers[k].nearest;
    fractions = fractions || numbers[k].fraction.has_value();
  }
  for (std::size_t k = 0; fractions && k < 12; ++k) exact[k] = numbers[k].exact();
  kernel::Pose pose = fractions ? kernel::Pose(exact) : kernel::Pose(nearest);
  if (pose.determinant_sign() == CGAL::ZERO)
    lines.fail("the 3x3 part has determinant 0", "expected a matrix that flattens nothing");
  return pose;
}

/// Returns the poses of a text file, each as by `read_pose`. Throws Input_error as `read_pose` and `Number_lines`, and
/// where the file holds no pose.
inline std::vector<kernel::Pose> read_poses(const std::filesystem::path& file)
{
  Number_lines lines(file);
  std::vector<kernel::Pose> poses;
  while (lines.next()) poses.push_back(read_pose(lines, "expected 12 or 16, the rows of a 3x4 or 4x4 matrix"));
  if (poses.empty()) throw Input_error(lines.file(), 0, "holds no pose", "expected twelve numbers a line");
  return poses;
}

}  // namespace tetracone::covering

#endif
