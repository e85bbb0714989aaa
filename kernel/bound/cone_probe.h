#ifndef TETRACONE_KERNEL_BOUND_CONE_PROBE_H
#define TETRACONE_KERNEL_BOUND_CONE_PROBE_H

#include "tetracone/kernel/bound/cone_cells.h"
#include "tetracone/kernel/number/floating_point.h"

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace tetracone::kernel {

/// A model's `Local_point`, rounded.
using Rounded_point = std::array<float, 3>;
inline Rounded_point rounded(const Local_point& p) { return {float(p[0]), float(p[1]), float(p[2])}; }

/// A point p against triangles as they are seen from the origin, by a filter in float.
///
/// The axis z along which p is largest is kept, the others are sheared so that the line from the origin through p
/// becomes z's: (x, y, z) -> (X, Y, z) = (x - z p_x / p_z, y - z p_y / p_z, z). How an edge of the triangle turns about
/// the line is the sign of one 2D determinant, of numbers as small as the triangle is beside the line.
class Cone_probe {
 public:
  /// What a triangle w a b says of p. `facing` is as by `cone_holds`; where it is 1 or -1, `is_before` tells whether p
  /// is before the triangle's plane, with the triangle on p's side of the origin, or else beyond it.
  struct View {
    int facing;
    bool is_before;
  };

  /// Requires Cone_cells::core <= octahedral_norm(p) <= 4.
  explicit Cone_probe(const Local_point& p)
  {
    assert(octahedral_norm(p) >= Cone_cells::core && octahedral_norm(p) <= 4);
    const double x = std::abs(p[0]), y = std::abs(p[1]), z = std::abs(p[2]);
    z_ = z >= x && z >= y ? 2 : y >= x ? 1 : 0;
    x_ = z_ == 2 ? 0 : z_ + 1;
    y_ = z_ == 0 ? 2 : z_ - 1;
    x_shear_ = float(p[x_] / p[z_]);
    y_shear_ = float(p[y_] / p[z_]);
    height_ = float(p[z_]);
  }

  /// Of corners of a model's triangle.
  ///
  /// X: a shear is off by 2^-25 for being a float and by 2^-28 for p, which is off by 2^-51 over |p_z| >= core / 3; a
  /// corner's coordinates by 2^-25 and 2^-51; the product, at most 1, is rounded by 2^-25 and the difference, at most 2,
  /// by 2^-24. With |z| <= 1 that is less than 7 2^-25 in all, and `sheared_error`, E, is more. Y likewise.
  ///
  /// A determinant X Y' - Y X' of numbers computed to be at most B <= 2: 2 (2 B E + E^2) for E, and 2^-22 B^2 <= 2 B E
  /// for its roundings; `turn_bound` (B + E), with 8 E for 6 E, is more, and what it is rounded by itself.
  ///
  /// The line meets the triangle's plane at z = p_z + D / S, with e the three determinants, S their sum and D the sum of
  /// e_k (z_k - p_z), z_k of the corner opposite. A difference, at most Z <= 5, is off by 2^-25 for z_k, 2^-23 for p_z
  /// and by its rounding, 2^-22: `height_error`, H, is more. With |e| <= L, off by t, D is off by 3 (t (Z + H) + L H) and
  /// by 9 L Z 2^-24 of roundings: 4 (t (Z + H) + L (H + 2^-22 Z)) is more, and what it is rounded by itself. What
  /// underflows is below E^2 by far.
  View operator()(const Rounded_point& w, const Rounded_point& a, const Rounded_point& b) const
  {
    const float wx = w[x_] - x_shear_ * w[z_], wy = w[y_] - y_shear_ * w[z_];
    const float ax = a[x_] - x_shear_ * a[z_], ay = a[y_] - y_shear_ * a[z_];
    const float bx = b[x_] - x_shear_ * b[z_], by = b[y_] - y_shear_ * b[z_];
    const float ab = ax * by - ay * bx, bw = bx * wy - by * wx, wa = wx * ay - wy * ax;
    const float B =
        maximum_of_defined(std::abs(wx), std::abs(wy), std::abs(ax), std::abs(ay), std::abs(bx), std::abs(by));
    const float t = turn_bound * (B + sheared_error);
    // No branch but the last two: each is a guess.
    const bool some_left = (ab > t) | (bw > t) | (wa > t), some_right = (ab < -t) | (bw < -t) | (wa < -t);
    if (some_left & some_right) return {0, false};
    const bool all_left = (ab > t) & (bw > t) & (wa > t), all_right = (ab < -t) & (bw < -t) & (wa < -t);
    if (!(all_left | all_right)) return {cone_undecided, false};

    const float w_above = w[z_] - height_, a_above = a[z_] - height_, b_above = b[z_] - height_;
    const float D = ab * w_above + bw * a_above + wa * b_above;
    const float L = maximum_of_defined(std::abs(ab), std::abs(bw), std::abs(wa));
    const float Z = maximum_of_defined(std::abs(w_above), std::abs(a_above), std::abs(b_above));
    const float d = 4 * (t * (Z + height_error) + L * (height_error + 0x1p-22f * Z));
    if (!(D > d) && !(D < -d)) return {cone_undecided, false};
    // Both are turned about where z points the other way.
    const bool is_up = height_ > 0;
    return {all_left == is_up ? 1 : -1, ((D > 0) == all_left) == is_up};
  }

  static constexpr float sheared_error = 0x1p-22f, turn_bound = 8 * sheared_error, height_error = 0x1p-21f;

 private:
  std::size_t x_, y_, z_;  ///< axes, in cyclic order
  float x_shear_, y_shear_, height_;
};

}  // namespace tetracone::kernel

#endif
