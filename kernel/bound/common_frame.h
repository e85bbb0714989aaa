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

namespace least_stretch_bound {

constexpr double u = unit_roundoff<double>;

/// Upper bound of the error of a row of L^T L: its diagonal entry less the magnitudes of the others. It is relative to
/// the sum of the squares of all entries: verify/proofs/nearest_proofs.h.
inline constexpr double row_rounding = 32 * u;
/// Upper bound of the relative error of the root of that row: verify/proofs/nearest_proofs.h.
inline constexpr double root_rounding = 4 * u;
/// Upper bound of the relative error of twice a volume over the sum of squares: verify/proofs/nearest_proofs.h.
inline constexpr double quotient_rounding = 32 * u;

/// Returns a diagonal entry of L^T L less the magnitudes of the other entries of its row. The first argument is the
/// entry's column of L.
template <class Number>
Number row_of_gram(const std::array<Number, 3>& column, const std::array<Number, 3>& second,
                   const std::array<Number, 3>& third)
{
  using std::abs;
  return dot(column, column) - abs(dot(column, second)) - abs(dot(third, column));
}

}  // namespace least_stretch_bound

/// Returns a lower bound of |L x| / |x| over all x; 0 where nothing is known. L has these rows. The entries are taken
/// exactly.
///
/// The least eigenvalue of L^T L has a lower bound by its rows (Gershgorin). It is the smallest, over the rows, of the
/// diagonal entry minus the magnitudes of the others. It is close where L is nearly a similarity. The least singular
/// value is also |det L| over the product of the two others. That product is at most half the sum of all squares. The
/// larger bound is returned. The determinant's error is at most `Pose::determinant_rounding` of its permanent.
inline double least_stretch(const std::array<std::array<double, 3>, 3>& l)
{
  namespace bound = least_stretch_bound;
  std::array<std::array<double, 3>, 3> column;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) column[j][i] = l[i][j];
  const auto& [x, y, z] = column;
  const double norm = dot(x, x) + dot(y, y) + dot(z, z);
  if (!(norm >= 0x1p-400 && norm <= 0x1p400)) return 0;
  const double square = minimum(bound::row_of_gram(x, y, z), bound::row_of_gram(y, z, x), bound::row_of_gram(z, x, y)) -
                        bound::row_rounding * norm;
  const double by_rows = square > 0 ? std::sqrt(square) * (1 - bound::root_rounding) : 0;
  const double volume = std::abs(determinant(column[0], column[1], column[2])) -
                        Pose::determinant_bound(permanent(column[0], column[1], column[2]));
  const double by_volume = volume > 0 ? 2 * volume / norm * (1 - bound::quotient_rounding) : 0;
  return maximum(by_rows, by_volume);
}

/// Two placed bodies in common coordinates, in double. These are the coordinates of space relative to the place of A's
/// local origin, times a power of two. The power makes the larger body about as large as 1. `position_error` is an
/// upper bound of the error of a point's coordinate.
///
/// A local point p, whose coordinates have an error of at most 2 u (`Bvh8_elements::local_error`), is placed by L p.
/// The entries of L are rounded where they are fractions. B's points are then moved by D, the place of B's local origin
/// relative to A's. D has its own error, and the sum is rounded.
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
    largest_ = maximum(of_a, of_b + way) * (1 + sum_rounding);
    position_error_ =
        maximum(image_rounding * of_a, image_rounding * of_b + way_rounding * (of_b + way) + d.error() * to_common) *
            (1 + sum_rounding) +
        underflow;
  }

  /// Returns the common coordinates of a local point of body 0 (A) or 1 (B).
  Double_vector operator()(int body, const Double_vector& p) const
  {
    const auto& l = linear_[body];
    Double_vector at = {dot(l[0], p), dot(l[1], p), dot(l[2], p)};
    if (body == 1)
      for (int k = 0; k < 3; ++k) at[k] += offset_[k];
    return at;
  }

  /// Returns an upper bound of the error of a coordinate of a point; infinite where no bound is known.
  double position_error() const { return position_error_; }

  /// Upper bound of the error of a local point's image, relative to the sum of the magnitudes of its row:
  /// verify/proofs/nearest_proofs.h.
  static constexpr double image_rounding = 8 * unit_roundoff<double>;
  /// Upper bound of the error of the sum of an image and the offset, relative to the magnitudes of both:
  /// verify/proofs/nearest_proofs.h.
  static constexpr double way_rounding = 2 * unit_roundoff<double>;
  /// Upper bound of the relative error of the sums and products that make up these bounds:
  /// verify/proofs/nearest_proofs.h.
  static constexpr double sum_rounding = 16 * unit_roundoff<double>;
  /// Upper bound of the errors of an image by products that underflow: verify/proofs/nearest_proofs.h.
  static constexpr double underflow = 0x1p-300;
  /// Upper bound of the error of a map's least stretch by entries that are rounded fractions, relative to the largest
  /// sum of a row: verify/proofs/nearest_proofs.h.
  static constexpr double entry_rounding = 4 * unit_roundoff<double>;

  /// Returns an upper bound of the magnitude of every coordinate, if `position_error` is finite.
  double largest() const { return largest_; }

  /// Returns a lower bound of the distance, in common coordinates, of two points of a body that are 1 apart in its
  /// local units.
  double least_stretch(int body) const { return stretch_[body]; }

  /// Returns the exponent of the scale: a distance in space is the distance in common coordinates times 2^exponent.
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

  /// Stores the body's map, times `scale`, and its least stretch. Returns the largest sum of a row's magnitudes.
  double take(int body, const Pose& pose, double scale)
  {
    auto& l = linear_[body];
    double largest = 0;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) l[i][j] = pose[4 * i + j] * scale;
      largest = maximum(largest, std::abs(l[i][0]) + std::abs(l[i][1]) + std::abs(l[i][2]));
    }
    // Entries that were fractions have a relative error of u each. The map's error is u times the root of the sum of
    // their squares.
    const double stretch = kernel::least_stretch(l) - (pose.is_rational() ? entry_rounding * largest : 0);
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
