#ifndef TETRACONE_COVERING_IO_READ_RAYS_H
#define TETRACONE_COVERING_IO_READ_RAYS_H

#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/read_poses.h"
#include "tetracone/covering/io/text_lines.h"

#include <array>
#include <filesystem>
#include <vector>

namespace tetracone::covering {

/// The rays of a text file: one a line, six decimals, the origin and a direction other than 0; '#' starts a comment,
/// blank lines are skipped. Throws Input_error where a line holds another count of numbers, a number is no decimal or is
/// not finite, the direction is 0, or the file holds no ray.
inline std::vector<std::array<double, 6>> read_rays(const std::filesystem::path& file)
{
  const std::string text = read_text(file);
  Text_lines lines(file.native(), text, '#');
  std::vector<std::array<double, 6>> rays;
  while (lines.next()) {
    const auto numbers = read_numbers<6>(lines, "the origin and the direction of a ray");
    std::array<double, 6> ray;
    for (std::size_t k = 0; k < 6; ++k) {
      if (numbers[k].fraction)
        lines.fail(in_quotes(lines.words()[k]) + " as number " + std::to_string(k + 1),
                   "expected a finite decimal number");
      ray[k] = numbers[k].nearest;
    }
    if (ray[3] == 0 && ray[4] == 0 && ray[5] == 0)
      lines.fail("the direction is 0", "expected a direction of any other length");
    rays.push_back(ray);
  }
  if (rays.empty()) throw Input_error(file.native(), 0, "holds no ray", "expected six numbers a line");
  return rays;
}

}  // namespace tetracone::covering

#endif
