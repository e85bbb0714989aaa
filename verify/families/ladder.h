#ifndef TETRACONE_VERIFY_FAMILIES_LADDER_H
#define TETRACONE_VERIFY_FAMILIES_LADDER_H

#include "verify/cases/object_placing.h"

#include <array>
#include <vector>

namespace tetracone::verify {

/// A rung of the family `ladder`: a size of two cubes, and their gap as a share of it. Rung 25 i + j has size i; j = 0
/// is flush, odd j a gap, and even j an overlap of the same share.
struct Rung {
  static constexpr std::array sizes = {-10, -7, -4, 0, 3, 7, 10, 13};                ///< of 2^s metres: 1 mm to 8 km
  static constexpr std::array shares = {1, 2, 4, 6, 8, 10, 12, 16, 20, 24, 32, 48};  ///< of 2^-bits
  static constexpr int steps = 1 + 2 * int(shares.size()), count = steps * int(sizes.size());

  explicit Rung(int number) : exponent(sizes[std::size_t(number / steps)]), step(number % steps) {}

  /// Positive for a gap, negative for an overlap, 0 where the cubes are flush.
  kernel::Rational gap() const
  {
    if (step == 0) return 0;
    const kernel::Rational share = object_family::power_of_two(-bits());
    return step % 2 == 1 ? share : kernel::Rational(-share);
  }

  /// The share's exponent. Requires that the cubes are not flush.
  int bits() const { return shares[std::size_t(step - 1) / 2]; }

  int exponent, step;
};

/// Returns all rungs in an order of which each beginning has all sizes and shares alike.
inline std::vector<double> all_rungs()
{
  constexpr int stride = 89;  // prime to the number of rungs, and no near multiple of a size's
  static_assert(Rung::count % stride != 0);
  std::vector<double> rungs;
  for (int k = 0; k < Rung::count; ++k) rungs.push_back(k * stride % Rung::count);
  return rungs;
}

}  // namespace tetracone::verify

#endif
