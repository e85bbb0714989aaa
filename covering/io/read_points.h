#ifndef TETRACONE_COVERING_IO_READ_POINTS_H
#define TETRACONE_COVERING_IO_READ_POINTS_H

#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/read_poses.h"
#include "tetracone/covering/io/text_lines.h"

#include <array>
#include <filesystem>
#include <vector>

namespace tetracone::covering {

/// A point as its file gives it: each coordinate a double (`nearest`), or a fraction beside it.
using Point_numbers = std::array<Number, 3>;

/// The points of a text file: one a line, three numbers, by the rules of `read_poses` (decimals or fractions
/// n/d, '#' starts a comment, blank lines are skipped). Throws Input_error where a line holds another count of numbers,
/// a number is none or is not finite, or the file holds no point.
inline std::vector<Point_numbers> read_points(const std::filesystem::path& file)
{
  const std::string text = read_text(file);
  Text_lines lines(file.native(), text, '#');
  std::vector<Point_numbers> points;
  while (lines.next()) points.push_back(read_numbers<3>(lines, "the coordinates of a point"));
  if (points.empty()) throw Input_error(file.native(), 0, "holds no point", "expected three numbers a line");
  return points;
}

}  // namespace tetracone::covering

#endif
