#ifndef TETRACONE_KERNEL_BOUND_COMMON_FRAME_H
#define TETRACONE_KERNEL_BOUND_COMMON_FRAME_H

#include "tetracone/kernel/bound/origin_offset.h"
#include "tetracone/kernel/bound/triangle_distance.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/products.h"

#include <array>
#include <cmath>
#include <limits>

namespace tetracone::kernel {

/// At most the factor by which the linear map of these rows shortens a vector, all entries exact.
///
/// The least eigenvalue of L^T L is at least each diagonal entry less the others of its row (Gershgorin), which is close
/// where L is nearly a similarity. Elsewhere the least singular value is |det L| over the product of the two others,
/// which is at most half the sum of the squares of all.
/// Entries of L^T L and the sum of squares are off by 4 roundings of what `norm`, the sum of squares, bounds; the
/// determinant by `Pose::determinant_rounding` of its permanent. 0 where nothing is known.
inline double least_stretch(const std::array<std::array<double, 3>, 3>& l)
{
  constexpr double u = unit_roundoff<double>;
  std::array<std::array<double, 3>, 3> column;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) column[j][i] = l[i][j];
  const double xx = dot(column[0], column[0]), yy = dot(column[1], column[1]), zz = dot(column[2], column[2]),
               xy = std::abs(dot(column[0], column[1])), yz = std::abs(dot(column[1], column[2])),
               zx = std::abs(dot(column[2], column[0])), norm = xx + yy + zz;
  if (!(norm >= 0x1p-400 && norm <= 0x1p400)) return 0;
  const double square = minimum(xx - xy - zx, yy - yz - xy, zz - zx - yz) - 32 * u * norm;
  const double by_rows = square > 0 ? std::sqrt(square) * (1 - 4 * u) : 0;
  const double volume = std::abs(determinant(column[0], column[1], column[2])) -
                        Pose::determinant_bound(permanent(column[0], column[1], column[2]));
  const double by_volume = volume > 0 ? 2 * volume / norm * (1 - 32 * u) : 0;
  return maximum(by_rows, by_volume);
}

/// Two placed bodies in coordinates that are common to both, in double: those of space, from where A's local origin is
/// placed, times a power of two that makes the larger body about as large as 1. A point is off by at most
/// `position_error` in a coordinate, which is infinite where no bound is known.
///
/// A local point p, off by 2 u (`Bvh8_elements::local_error`), is placed by L p, three products and two sums of entries
/// of which fractions are rounded: 2 u + 3 u + u of a row's sum, taken as 8 u. B's is moved by D, which is off by its
/// own error, and by a rounding of each of the product and the sum: 2 u (row's sum + |D|).
class Common_frame {
 public:
  using Row = std::array<double, 3>;

  Common_frame(const Pose& a, const Local_scale& in_a, const Pose& b, const Local_scale& in_b)
  {
    const double largest = maximum(norm(a) * in_a.unit, norm(b) * in_b.unit);
    if (!(in_a.is_in_range() && in_b.is_in_range() && largest > 0x1p-200 && largest < 0x1p200)) return;
    const int exponent = std::ilogb(largest) + 1;
    const double to_common = std::ldexp(1.0, -exponent);
    Origin_offset d(a, in_a, b, in_b);
    if (!(d.error() <= 4 * u * largest)) d = Origin_offset::in_double_double(a, in_a, b, in_b);
    if (!(d.largest() <= 0x1p300)) return;
    exponent_ = exponent;
    const double of_a = take(0, a, in_a.unit * to_common), of_b = take(1, b, in_b.unit * to_common);
    const double way = d.largest() * to_common;
    for (int i = 0; i < 3; ++i) offset_[i] = d[i] * to_common;
    largest_ = maximum(of_a, of_b + way) * (1 + 16 * u);
    position_error_ =
        maximum(8 * u * of_a, 8 * u * of_b + 2 * u * (of_b + way) + d.error() * to_common) * (1 + 16 * u) + 0x1p-300;
  }

  /// Of a local point of a body, 0 or 1.
  Double_vector operator()(int body, const Double_vector& p) const
  {
    const auto& l = linear_[body];
    Double_vector at = {dot(l[0], p), dot(l[1], p), dot(l[2], p)};
    if (body == 1)
      for (int k = 0; k < 3; ++k) at[k] += offset_[k];
    return at;
  }

  double position_error() const { return position_error_; }

  /// At least the magnitude of every coordinate.
  double largest() const { return largest_; }

  /// At most the distance here of two points of a body that are 1 apart in its local units.
  double least_stretch(int body) const { return stretch_[body]; }

  /// Distances in space are those here times 2^exponent.
  int exponent() const { return exponent_; }

 private:
  static constexpr double u = unit_roundoff<double>;

  static double norm(const Pose& pose)
  {
    double largest = 0;
    for (int i = 0; i < 3; ++i)
      largest = maximum(largest, std::abs(pose[4 * i]) + std::abs(pose[4 * i + 1]) + std::abs(pose[4 * i + 2]));
    return largest;
  }

  /// Returns the largest sum of a row's magnitudes.
  double take(int body, const Pose& pose, double scale)
  {
    auto& l = linear_[body];
    double largest = 0;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) l[i][j] = pose[4 * i + j] * scale;
      largest = maximum(largest, std::abs(l[i][0]) + std::abs(l[i][1]) + std::abs(l[i][2]));
    }
    // Entries that were fractions are off by u each: the map by u of its entries' norm, below 2 largest.
    const double stretch = kernel::least_stretch(l) - (pose.is_rational() ? 4 * u * largest : 0);
    stretch_[body] = stretch > 0 ? stretch : 0;
    return largest;
  }

  std::array<std::array<Row, 3>, 2> linear_{};
  Row offset_{};
  double position_error_ = std::numeric_limits<double>::infinity(), largest_ = 0;
  double stretch_[2] = {0, 0};
  int exponent_ = 0;
};

}  // namespace tetracone::kernel

#endif
