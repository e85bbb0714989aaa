#ifndef TETRACONE_COVERING_IO_READ_RAYS_H
#define TETRACONE_COVERING_IO_READ_RAYS_H

#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/read_numbers.h"

#include <array>
#include <filesystem>
#include <vector>

namespace tetracone::covering {

/// Returns the rays of a text file: one a line, six decimals, the origin and a direction other than 0. Throws
/// Input_error as `Number_lines`. Throws it also where a line holds another count of numbers, a number is no decimal,
/// the direction is 0, or the file holds no ray.
inline std::vector<std::array<double, 6>> read_rays(const std::filesystem::path& file)
{
  Number_lines lines(file);
  std::vector<std::array<double, 6>> rays;
  while (lines.next()) {
    const auto numbers = lines.numbers<6>("the origin and the direction of a ray");
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
  if (rays.empty()) throw Input_error(lines.file(), 0, "holds no ray", "expected six numbers a line");
  return rays;
}

}  // namespace tetracone::covering

#endif
