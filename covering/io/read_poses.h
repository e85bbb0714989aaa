#ifndef TETRACONE_COVERING_IO_READ_POSES_H
#define TETRACONE_COVERING_IO_READ_POSES_H

#include "tetracone/covering/io/text_lines.h"
#include "tetracone/kernel/number/pose.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <vector>

namespace tetracone::covering {

/// A number of a pose or of a point: a decimal stands for the double nearest to it, a fraction "n/d" for itself.
struct Number {
  double nearest;
  std::optional<kernel::Rational> fraction;  ///< the exact value, where the word is a fraction

  kernel::Rational exact() const { return fraction ? *fraction : kernel::Rational(nearest); }
};

/// Word `k` of the line as a number; throws Input_error. A fraction beyond the largest double is refused as infinite.
inline Number read_number(const Text_lines& lines, std::size_t k)
{
  const std::string_view word = lines.words()[k];
  if (const auto decimal = kernel::parse_double(word)) return {*decimal, std::nullopt};
  if (const auto fraction = kernel::parse_fraction(word)) {
    const double nearest = kernel::nearest_double(*fraction);
    if (std::isfinite(nearest)) return {nearest, fraction};
  }
  lines.fail(in_quotes(word) + " as number " + std::to_string(k + 1),
             "expected a finite decimal number or a fraction n/d");
}

/// The numbers of a line that must hold exactly `N`; throws Input_error.
template <std::size_t N>
std::array<Number, N> read_numbers(const Text_lines& lines, const std::string& what)
{
  const std::size_t found = lines.words().size();
  if (found != N)
    lines.fail(std::to_string(found) + (found == 1 ? " number" : " numbers"),
               "expected " + std::to_string(N) + ", " + what);
  std::array<Number, N> numbers;
  for (std::size_t k = 0; k < N; ++k) numbers[k] = read_number(lines, k);
  return numbers;
}

/// The poses of a text file: one a line, twelve numbers, row-major 3x4. '#' starts a comment, blank lines are skipped.
/// Throws Input_error where a line holds another count of numbers, a number is none or is not finite, det M = 0
/// (exactly), or the file holds no pose.
inline std::vector<kernel::Pose> read_poses(const std::filesystem::path& file)
{
  const std::string text = read_text(file);
  Text_lines lines(file.native(), text, '#');
  std::vector<kernel::Pose> poses;
  while (lines.next()) {
    const auto numbers = read_numbers<12>(lines, "the rows of a 3x4 matrix");
    std::array<double, 12> nearest;
    bool fractions = false;
    for (int k = 0; k < 12; ++k) {
      nearest[k] = numbers[k].nearest;
      fractions = fractions || numbers[k].fraction.has_value();
    }
    if (fractions) {
      std::array<kernel::Rational, 12> entries;
      for (int k = 0; k < 12; ++k) entries[k] = numbers[k].exact();
      poses.emplace_back(entries);
    } else {
      poses.emplace_back(nearest);
    }
    if (poses.back().determinant_sign() == CGAL::ZERO)
      lines.fail("the 3x3 part has determinant 0", "expected a matrix that flattens nothing");
  }
  if (poses.empty()) throw Input_error(file.native(), 0, "holds no pose", "expected twelve numbers a line");
  return poses;
}

}  // namespace tetracone::covering

#endif
