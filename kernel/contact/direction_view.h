#ifndef TETRACONE_KERNEL_CONTACT_DIRECTION_VIEW_H
#define TETRACONE_KERNEL_CONTACT_DIRECTION_VIEW_H

#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/products.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetracone::kernel {

/// Coordinates in which a direction d is upright: a step along d changes z alone. They come from a shear along d.
class Direction_view {
 public:
  /// Requires d != 0.
  explicit Direction_view(const Rational_point& d)
  {
    const int up = largest_axis(d);
    height_ = abs(d[up]);
    for (int i = 0; i < 2; ++i) {
      const int side = (up + 1 + i) % 3;
      row_[i] = {0, 0, 0};
      row_[i][side] = 1;
      row_[i][up] = -d[side] / d[up];
    }
    row_[2] = {0, 0, 0};
    row_[2][up] = sgn(d[up]);
  }

  /// Returns the height of d in the view.
  const Rational& height() const { return height_; }

  /// Returns the normal, in space, of a plane that has the normal `seen` in the view.
  Rational_point normal(const Rational_point& seen) const
  {
    Rational_point n = {0, 0, 0};
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) n[k] += seen[i] * row_[i][k];
    return n;
  }

  /// Returns a pose followed by the view, as a row-major 3x4 matrix.
  std::array<Rational, 12> of(const Pose& pose) const
  {
    std::array<Rational, 12> m;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 4; ++k)
        m[4 * i + k] = dot(row_[i], Rational_point{pose.exact(k), pose.exact(4 + k), pose.exact(8 + k)});
    return m;
  }

 private:
  std::array<Rational_point, 3> row_;
  Rational height_;
};

/// Returns the pose a moved by s d, and the pose b. Where an entry of the first exceeds the doubles, both are divided
/// by one number, which changes no relation of bodies.
inline std::array<Pose, 2> moved_along(const Pose& a, const Pose& b, const Rational_point& d, const Rational& s)
{
  std::array<std::array<Rational, 12>, 2> rows = {rows_of(a), rows_of(b)};
  for (int i = 0; i < 3; ++i) rows[0][4 * i + 3] += s * d[i];
  const auto is_finite = [](const Rational& x) { return std::isfinite(nearest_double(x)); };
  if (std::ranges::all_of(rows[0], is_finite)) return {Pose(rows[0]), b};
  Rational largest = 1;
  for (const Rational& x : rows[0]) largest = x > largest ? x : -x > largest ? Rational(-x) : largest;
  for (auto& row : rows)
    for (Rational& x : row) x /= largest;
  return {Pose(rows[0]), Pose(rows[1])};
}

}  // namespace tetracone::kernel

#endif
