#ifndef TETRACONE_COVERING_IO_READ_POINTS_H
#define TETRACONE_COVERING_IO_READ_POINTS_H

#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/read_numbers.h"

#include <array>
#include <filesystem>
#include <vector>

namespace tetracone::covering {

/// A point as its file gives it: each coordinate is a decimal or a fraction, see `Number`.
using Point_numbers = std::array<Number, 3>;

/// Returns the points of a text file: one a line, three numbers, decimals or fractions n/d. Throws Input_error as
/// `Number_lines`, where a line holds another count of numbers, and where the file holds no point.
inline std::vector<Point_numbers> read_points(const std::filesystem::path& file)
{
  Number_lines lines(file);
  std::vector<Point_numbers> points;
  while (lines.next()) points.push_back(lines.numbers<3>("the coordinates of a point"));
  if (points.empty()) throw Input_error(lines.file(), 0, "holds no point", "expected three numbers a line");
  return points;
}

}  // namespace tetracone::covering

#endif
