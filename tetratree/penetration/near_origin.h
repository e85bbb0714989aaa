#ifndef TETRACONE_TETRATREE_PENETRATION_NEAR_ORIGIN_H
#define TETRACONE_TETRATREE_PENETRATION_NEAR_ORIGIN_H

#include "tetracone/kernel/bound/origin_offset.h"
#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace tetracone::tetratree {

/// The poses of two bodies after one map x -> 2^-exponent (x - origin), which is exact. Exits and depths become those
/// of the given poses, times 2^-exponent.
struct Near_origin {
  std::array<kernel::Pose, 2> pose;
  int exponent = 0;
  kernel::Rational_point origin = {};
};

/// Returns poses near the origin and near size 1, where enclosures in double are narrow.
///
/// The origin is A's translation in the coordinates where this is much larger than A. Poses of doubles stay such poses.
/// The exponent is 0 unless A is smaller than 2^-100 or larger than 2^100.
inline Near_origin near_origin(const kernel::Pose& a, const kernel::Local_scale& scale_of_a, const kernel::Pose& b)
{
  constexpr double much = 0x1p10;  // by which a translation exceeds A's reach where it is taken off
  constexpr int usual = 100;       // the largest exponent of a size that is left as it is
  std::array<double, 3> origin = {};
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const int row = int(4 * i);
    double reach = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double entry = std::abs(a[row + int(k)]);
      reach += entry * (std::abs(scale_of_a.origin[k]) + scale_of_a.unit);
      largest = kernel::maximum(largest, entry);
    }
    const double at = a[row + 3];
    const bool is_exact = b.is_rational() || kernel::two_sum(b[row + 3], -at).low == 0;
    if (std::abs(at) > much * reach && is_exact) origin[i] = at;
  }
  int exponent = largest > 0 ? std::ilogb(largest) + std::ilogb(scale_of_a.unit) : 0;
  if (std::abs(exponent) <= usual) exponent = 0;
  if (exponent == 0 && origin == std::array<double, 3>{}) return {{a, b}};

  const auto moved = [&](const kernel::Pose& pose, int by) {
    std::array<kernel::Rational, 12> rows = kernel::rows_of(pose);
    for (std::size_t i = 0; i < 3; ++i) rows[4 * i + 3] -= kernel::Rational(origin[i]);
    for (kernel::Rational& x : rows) x = kernel::times_power(x, -by);
    return rows;
  };
  const auto is_finite = [](const kernel::Rational& x) { return std::isfinite(kernel::nearest_double(x)); };
  const auto of_a = moved(a, exponent), of_b = moved(b, exponent);
  if (std::ranges::all_of(of_a, is_finite) && std::ranges::all_of(of_b, is_finite))
    return {{kernel::Pose(of_a), kernel::Pose(of_b)}, exponent, kernel::exact_point(origin)};
  return {{a, b}};
}

}  // namespace tetracone::tetratree

#endif
