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

/// What a row of L^T L, its diagonal entry less the others, loses: a share of the sum of the squares of all entries.
inline constexpr double row_rounding = 32 * u;
/// What the root of such a row loses, a share of itself.
inline constexpr double root_rounding = 4 * u;
/// What twice a volume over that sum loses, a share of itself.
inline constexpr double quotient_rounding = 32 * u;

/// A diagonal entry of L^T L less the others of its row: of a column and the two others.
template <class Number>
Number row_of_gram(const std::array<Number, 3>& column, const std::array<Number, 3>& second,
                   const std::array<Number, 3>& third)
{
  using std::abs;
  return dot(column, column) - abs(dot(column, second)) - abs(dot(third, column));
}

}  // namespace least_stretch_bound

/// A lower bound of the factor by which the linear map of these rows shortens a vector, all entries exact.
///
/// The least eigenvalue of L^T L is at least each diagonal entry less the others of its row (Gershgorin), which is
/// close where L is nearly a similarity. Elsewhere the least singular value is |det L| over the product of the two
/// others, which is at most half the sum of the squares of all. The determinant is off by `Pose::determinant_rounding`
/// of its permanent. 0 where nothing is known.
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

/// Two placed bodies in coordinates that are common to both, in double: those of space, from where A's local origin is
/// placed, times a power of two that makes the larger body about as large as 1. A point is off by at most
/// `position_error` in a coordinate, which is infinite where no bound is known.
///
/// A local point p, off by 2 u (`Bvh8_elements::local_error`), is placed by L p, whose entries are rounded where they
/// are fractions. B's is moved by D, which is off by its own error, and the sum is rounded.
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

  /// What an image of a local point loses, a share of the sum of its row's magnitudes.
  static constexpr double image_rounding = 8 * unit_roundoff<double>;
  /// What the sum of an image and the offset loses, a share of the magnitudes of both.
  static constexpr double way_rounding = 2 * unit_roundoff<double>;
  /// What the sums and products that these bounds are made of lose, a share of themselves.
  static constexpr double sum_rounding = 16 * unit_roundoff<double>;
  /// Above what products of an image lose where they underflow.
  static constexpr double underflow = 0x1p-300;
  /// What rounded entries of fractions take from a map's least stretch, a share of the largest sum of a row.
  static constexpr double entry_rounding = 4 * unit_roundoff<double>;

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
    // Entries that were fractions are off by u each: the map by u of the root of the sum of their squares.
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
