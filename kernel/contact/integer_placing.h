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

/// A map of vertices to integers: a scale times the coordinates of their images. Sums and products of integers need no
/// greatest common divisor, so they take a fraction of the time of rationals.
class Integer_map {
 public:
  /// Maps all to 0.
  Integer_map() = default;

  /// Takes a row-major 3x4 matrix. Requires bits n >= 0 such that all vertices times 2^n are integers, and a positive
  /// multiple of `least_scale`.
  Integer_map(const std::array<Rational, 12>& map, int bits, const mpz_class& scale) : bits_(bits)
  {
    for (int k = 0; k < 12; ++k) {
      map_[k] = map[k].get_num() * (scale / map[k].get_den());
      if (k % 4 != 3) map_[k] >>= bits;
    }
  }

  /// Returns a scale: a common denominator of the matrix, times 2^bits.
  static mpz_class least_scale(const std::array<Rational, 12>& map, int bits)
  {
    mpz_class common = 1;
    for (const Rational& entry : map)
      if (const mpz_class& divisor = entry.get_den(); !mpz_divisible_p(common.get_mpz_t(), divisor.get_mpz_t()))
        common = lcm(common, divisor);
    return common << bits;
  }

  /// Returns the image of a vertex, times the scale. Requires a vertex whose coordinates times 2^bits are integers.
  Number_point<mpz_class> operator()(const Vertex& v) const
  {
    return image(std::array{integer(v[0], bits_), integer(v[1], bits_), integer(v[2], bits_)}, map_);
  }

 private:
  int bits_ = 0;
  std::array<mpz_class, 12> map_;
};

/// The placed vertices of two bodies in integers, over one scale.
class Integer_placing {
 public:
  using Number = mpz_class;

  /// Requires, for each body, a number of bits n >= 0 such that its coordinates times 2^n are integers.
  Integer_placing(const std::array<const Pose*, 2>& poses, const std::array<int, 2>& bits)
  {
    const std::array<std::array<Rational, 12>, 2> rows = {rows_of(*poses[0]), rows_of(*poses[1])};
    scale = lcm(Integer_map::least_scale(rows[0], bits[0]), Integer_map::least_scale(rows[1], bits[1]));
    for (int body = 0; body < 2; ++body) map_[body] = Integer_map(rows[body], bits[body], scale);
  }

  /// Returns the placed vertex, times `scale`. Requires a vertex whose coordinates times 2^bits are integers.
  Number_point<mpz_class> operator()(int body, const Vertex& v) const { return map_[body](v); }

  mpz_class scale;  ///< the factor of all coordinates, a positive integer

 private:
  std::array<Integer_map, 2> map_;
};

}  // namespace tetracone::kernel

#endif
