#ifndef TETRACONE_KERNEL_CONTACT_INTEGER_PLACING_H
#define TETRACONE_KERNEL_CONTACT_INTEGER_PLACING_H

#include "tetracone/kernel/contact/corner_point.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/number/vertex.h"

#include <array>
#include <span>

namespace tetracone::kernel {

/// Returns the least n >= 0 such that all coordinates times 2^n are integers. Requires finite coordinates.
inline int fraction_bits(std::span<const Vertex> vertices)
{
  int bits = 0;
  for (const Vertex& v : vertices)
    for (const double x : v) bits = maximum(bits, fraction_bits(x));
  return bits;
}

/// The placed vertices of two bodies in integers: a scale times their coordinates. Sums and products of integers need
/// no greatest common divisor, so they take a fraction of the time of rationals.
class Integer_placing {
 public:
  using Number = mpz_class;

  /// Requires, for each body, a number of bits n >= 0 such that its coordinates times 2^n are integers. The scale is a
  /// common denominator of the poses, times a power of two that clears the vertices.
  Integer_placing(const std::array<const Pose*, 2>& poses, const std::array<int, 2>& bits) : bits_(bits)
  {
    std::array<mpz_class, 2> common = {1, 1};
    const std::array<std::array<Rational, 12>, 2> entries = {rows_of(*poses[0]), rows_of(*poses[1])};
    for (int body = 0; body < 2; ++body)
      for (const Rational& entry : entries[body])
        if (const mpz_class& divisor = entry.get_den(); !mpz_divisible_p(common[body].get_mpz_t(), divisor.get_mpz_t()))
          common[body] = lcm(common[body], divisor);
    scale = lcm(mpz_class(common[0] << bits_[0]), mpz_class(common[1] << bits_[1]));
    for (int body = 0; body < 2; ++body)
      for (int k = 0; k < 12; ++k) {
        map_[body][k] = entries[body][k].get_num() * (scale / entries[body][k].get_den());
        if (k % 4 != 3) map_[body][k] >>= bits_[body];
      }
  }

  /// Returns the placed vertex, times `scale`. Requires a vertex whose coordinates times 2^bits are integers.
  Number_point<mpz_class> operator()(int body, const Vertex& v) const
  {
    const int bits = bits_[body];
    return image(std::array{integer(v[0], bits), integer(v[1], bits), integer(v[2], bits)}, map_[body]);
  }

  mpz_class scale;  ///< the factor of all coordinates, a positive integer

 private:
  std::array<int, 2> bits_;
  std::array<std::array<mpz_class, 12>, 2> map_;
};

}  // namespace tetracone::kernel

#endif
