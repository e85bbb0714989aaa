#ifndef TETRACONE_KERNEL_MOTION_ODD_DOUBLE_H
#define TETRACONE_KERNEL_MOTION_ODD_DOUBLE_H

#include <gmpxx.h>

#include <bit>
#include <climits>
#include <cmath>
#include <cstdint>

namespace tetracone::kernel {

/// A finite double as an odd integer times a power of two; 0 as 0 times 2^INT_MAX.
struct Odd_double {
  explicit Odd_double(double x)
  {
    if (x == 0) return;
    const double fraction = std::frexp(x, &exponent);
    odd = static_cast<std::int64_t>(std::ldexp(fraction, 53));
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(odd));
    odd /= std::int64_t(1) << zeros;
    exponent += zeros - 53;
  }

  /// Returns the number divided by 2^least. Requires least <= exponent.
  mpz_class over(int least) const
  {
    static_assert(sizeof(long) == sizeof(std::int64_t));
    mpz_class result(static_cast<long>(odd));
    if (odd != 0) result <<= static_cast<unsigned>(exponent - least);
    return result;
  }

  std::int64_t odd = 0;
  int exponent = INT_MAX;
};

}  // namespace tetracone::kernel

#endif
