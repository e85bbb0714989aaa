#ifndef TETRACONE_KERNEL_BOUND_CONE_PROBE_H
#define TETRACONE_KERNEL_BOUND_CONE_PROBE_H

#include "tetracone/kernel/bound/cone_cells.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/simd/short_vectors.h"

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace tetracone::kernel {

/// A model's `Local_point`, rounded to float; 0 in the last lane.
using Rounded_point = Four_floats;
inline Rounded_point rounded(const Local_point& p) { return Rounded_point{float(p[0]), float(p[1]), float(p[2]), 0}; }

/// A filter in float for a point p against triangles as they are seen from the origin, four at a time.
///
/// The axis z along which p is largest is kept. The others are sheared so that the line from the origin through p
/// becomes the z axis: (x, y, z) -> (X, Y, z) = (x - z p_x / p_z, y - z p_y / p_z, z). How an edge of the triangle
/// turns about the line is the sign of one 2D determinant. Its numbers are as small as the triangle is beside the line.
class Cone_probe {
 public:
  /// One corner of each of four triangles.
  using Corners = std::array<Rounded_point, 4>;

  /// The answers of four triangles w a b about p, a bit each. All other triangles are missed by the line from the
  /// origin through p.
  /// - `left`, `right`: the line meets the triangle's interior, and its edges turn about p to the left or to the right
  /// (1 or -1 in `cone_holds`).
  /// - `before`: p is before the plane of such a triangle, which lies on p's side of the origin.
  /// - `undecided`: the filter is uncertain.
  struct Views {
    unsigned left, right, before, undecided;

    /// Returns the answer of triangle k in the form of `cone_holds`.
    int facing(unsigned k) const
    {
      return undecided >> k & 1 ? cone_undecided : int(left >> k & 1) - int(right >> k & 1);
    }
  };

  /// Requires Cone_cells::core <= octahedral_norm(p) <= 4.
  explicit Cone_probe(const Local_point& p)
  {
    assert(octahedral_norm(p) >= Cone_cells::core && octahedral_norm(p) <= 4);
    const double x = std::abs(p[0]), y = std::abs(p[1]), z = std::abs(p[2]);
    z_ = z >= x && z >= y ? 2 : y >= x ? 1 : 0;
    // The axes are in cyclic order as seen from p. Where z points away from p, it is seen from the other side.
    const bool is_up = p[z_] > 0;
    const std::size_t next = z_ == 2 ? 0 : z_ + 1, last = z_ == 0 ? 2 : z_ - 1;
    x_ = is_up ? next : last;
    y_ = is_up ? last : next;
    up_ = is_up ? 1 : -1;
    x_shear_ = float(p[x_] / p[z_]);
    y_shear_ = float(p[y_] / p[z_]);
    height_ = float(p[z_]);
  }

  /// Returns the views of four triangles, by the corners of a model.
  ///
  /// The errors of X and Y are at most E, `sheared_error`. They come from the shear, which is rounded to float, and
  /// from p, whose error is `local_error` over |p_z| >= core / 3. A determinant X Y' - Y X' of numbers of at most B <=
  /// 2 has an error below t, `turn_slack(B)`.
  ///
  /// The line meets the triangle's plane at z = p_z + D / S. S is the sum of the three determinants e_k, and D the sum
  /// of e_k (z_k - p_z), with z_k of the corner opposite. The error of a difference, which is at most Z <= 5, is at
  /// most `height_error`. With |e| <= L and an error of e of at most t, the error of D is below `plane_slack(t, L, Z)`.
  Views operator()(const Corners& w, const Corners& a, const Corners& b) const
  {
    const auto [wx, wy, wz] = sheared(w);
    const auto [ax, ay, az] = sheared(a);
    const auto [bx, by, bz] = sheared(b);
    const Four_floats ab = turn(ax, ay, bx, by), bw = turn(bx, by, wx, wy), wa = turn(wx, wy, ax, ay);
    const Four_floats B = maximum_of_defined(magnitudes(wx), magnitudes(wy), magnitudes(ax), magnitudes(ay),
                                             magnitudes(bx), magnitudes(by));
    const Four_floats t = turn_slack(B);
    const Four_ints some_left = (ab > t) | (bw > t) | (wa > t), some_right = (ab < -t) | (bw < -t) | (wa < -t);
    const Four_ints all_left = (ab > t) & (bw > t) & (wa > t), all_right = (ab < -t) & (bw < -t) & (wa < -t);

    const Four_floats w_above = wz - height_, a_above = az - height_, b_above = bz - height_;
    const Four_floats D = sum_above(ab, w_above, bw, a_above, wa, b_above);
    const Four_floats L = maximum_of_defined(magnitudes(ab), magnitudes(bw), magnitudes(wa));
    const Four_floats Z = maximum_of_defined(magnitudes(w_above), magnitudes(a_above), magnitudes(b_above));
    const Four_floats d = plane_slack(t, L, Z);
    const Four_ints is_certain = magnitudes(D) > d;
    const Four_ints left = all_left & is_certain, right = all_right & is_certain;
    // D / S has the sign of p_z where the plane is beyond p.
    const Four_ints is_positive = up_ * D > 0;
    const Four_ints before = (left & is_positive) | (right & ~is_positive);
    const Four_ints undecided = ~(some_left & some_right) & ~left & ~right;
    const Four_ints one{1, 2, 4, 8};
    const auto bits =
        unsigned(sum_of_lanes((left & one) | (right & one << 4) | (before & one << 8) | (undecided & one << 12))[0]);
    return {bits & 15, bits >> 4 & 15, bits >> 8 & 15, bits >> 12 & 15};
  }

  // All are proved in verify/proofs/cone_proofs.h.
  static constexpr float sheared_error = 0x1p-22f,  ///< upper bound of the error of a sheared coordinate, E
      turn_bound = 8 * sheared_error,               ///< upper bound of the error of a determinant, over B + E
      height_error = 0x1p-21f;                      ///< upper bound of the error of a height above p, H
  static constexpr float plane_factor = 4,          ///< error of D, over t (Z + H) + L (H + `height_rounding` Z)
      height_rounding = 0x1p-22f;                   ///< relative rounding of the terms of D

  template <class Floats, class Float>
  static Floats sheared(const Floats& x, const Floats& z, const Float& shear)
  {
    return x - shear * z;
  }
  template <class Floats>
  static Floats turn(const Floats& ax, const Floats& ay, const Floats& bx, const Floats& by)
  {
    return ax * by - ay * bx;
  }
  template <class Floats>
  static Floats turn_slack(const Floats& B)
  {
    return turn_bound * (B + sheared_error);
  }
  template <class Floats>
  static Floats sum_above(const Floats& ab, const Floats& w, const Floats& bw, const Floats& a, const Floats& wa,
                          const Floats& b)
  {
    return ab * w + bw * a + wa * b;
  }
  template <class Floats>
  static Floats plane_slack(const Floats& t, const Floats& L, const Floats& Z)
  {
    return plane_factor * (t * (Z + height_error) + L * (height_error + height_rounding * Z));
  }

 private:
  /// Returns X, Y and z of four corners.
  std::array<Four_floats, 3> sheared(const Corners& p) const
  {
    const Four_floats xy01 = __builtin_shufflevector(p[0], p[1], 0, 4, 1, 5);
    const Four_floats xy23 = __builtin_shufflevector(p[2], p[3], 0, 4, 1, 5);
    const Four_floats z01 = __builtin_shufflevector(p[0], p[1], 2, 6, 2, 6);
    const Four_floats z23 = __builtin_shufflevector(p[2], p[3], 2, 6, 2, 6);
    const Four_floats by_axis[3] = {__builtin_shufflevector(xy01, xy23, 0, 1, 4, 5),
                                    __builtin_shufflevector(xy01, xy23, 2, 3, 6, 7),
                                    __builtin_shufflevector(z01, z23, 0, 1, 4, 5)};
    const Four_floats z = by_axis[z_];
    return {sheared(by_axis[x_], z, x_shear_), sheared(by_axis[y_], z, y_shear_), z};
  }

  std::size_t x_, y_, z_;  ///< axes, in cyclic order where p_z is positive
  float x_shear_, y_shear_, height_, up_;
};

}  // namespace tetracone::kernel

#endif
