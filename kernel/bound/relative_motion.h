#ifndef TETRACONE_KERNEL_BOUND_RELATIVE_MOTION_H
#define TETRACONE_KERNEL_BOUND_RELATIVE_MOTION_H

#include "tetracone/kernel/bound/relative_frame.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/products.h"

#include <array>
#include <cmath>

namespace tetracone::kernel {

/// A box that holds a body, in its local units: all c + sum_j s_j h_j with |s_j| <= 1.
struct Body_box {
  using Row = std::array<double, 3>;
  Row centre{};
  std::array<Row, 3> half_edge{};

  /// At least the magnitude of every coordinate of its points.
  double reach() const
  {
    double most = 0;
    for (int k = 0; k < 3; ++k)
      most = maximum(most, std::abs(centre[k]) + std::abs(half_edge[0][k]) + std::abs(half_edge[1][k]) +
                               std::abs(half_edge[2][k]));
    return most * (1 + few_roundings);
  }
};

/// At least how far any point p of the box with |p_k| <= 1 has moved from its image under the exact map of `before` to
/// that under the exact map of `after`, in the units into which both lead. Infinite or undefined where nothing is known.
///
/// The maps in double are L0 p + o0 and L1 p + o1, off by e0 and e1 in a coordinate: so p has moved by |D p + d| and at
/// most sqrt(3) (e0 + e1), D = L1 - L0 and d = o1 - o0. |D p + d| is convex: over the box it is largest at a corner
/// m + sum_j +-g_j, with m = D c + d and g_j = D h_j, of square
///
///     m^2 + sum_j g_j^2 + 2 sum_j +-m . g_j + 2 sum_{i<j} +-+-g_i . g_j,
///
/// and of all corners at least the first two terms, the mean: so no more is lost by cancellation than a few roundings of
/// the result. D and d are rounded once, m and g_j a few times: by a share of W = |d|_1 + r sum |D_ij|, r the reach of
/// the box. Squares that underflow are those of less than 2^-500, far below e0.
inline double motion_bound(const Relative_frame& before, const Relative_frame& after, const Body_box& box, double reach)
{
  using Row = Body_box::Row;
  const std::array<Row, 3>&first = before.linear(), &last = after.linear();
  std::array<Row, 3> turned;
  Row shift;
  double of_turned = 0, of_shift = 0;
  for (int i = 0; i < 3; ++i) {
    shift[i] = after.offset()[i] - before.offset()[i];
    of_shift += std::abs(shift[i]);
    for (int j = 0; j < 3; ++j) {
      turned[i][j] = last[i][j] - first[i][j];
      of_turned += std::abs(turned[i][j]);
    }
  }
  const auto image = [&](const Row& p) { return Row{dot(turned[0], p), dot(turned[1], p), dot(turned[2], p)}; };
  Row m = image(box.centre);
  for (int i = 0; i < 3; ++i) m[i] += shift[i];
  const Row g0 = image(box.half_edge[0]), g1 = image(box.half_edge[1]), g2 = image(box.half_edge[2]);
  const double mean = dot(m, m) + (dot(g0, g0) + (dot(g1, g1) + dot(g2, g2)));
  const double m0 = dot(m, g0), m1 = dot(m, g1), m2 = dot(m, g2), g01 = dot(g0, g1), g12 = dot(g1, g2),
               g20 = dot(g2, g0);
  // Of two opposite corners, that on m's side: along g_0 the sign of s0 m0, and so on.
  const auto corner = [&](double with_m, double among) { return std::abs(with_m) + among; };
  const double most = maximum(corner(m0 + m1 + m2, g01 + g12 + g20), corner(m0 + m1 - m2, g01 - g12 - g20),
                              corner(m0 - m1 + m2, g20 - g01 - g12), corner(m0 - m1 - m2, g12 - g01 - g20));
  const double rounded = few_roundings * (of_shift + reach * of_turned);
  return std::sqrt(mean + 2 * most) * (1 + few_roundings) + rounded + 2 * (before.error() + after.error());
}

/// At least the norm of the difference of two maps' linear parts, as they are in double: how much a vector's image
/// changes, a share of the vector.
inline double linear_step(const Relative_frame& before, const Relative_frame& after)
{
  double square = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double change = after.linear()[i][j] - before.linear()[i][j];
      square += change * change;
    }
  // What underflows is less than 2^-500.
  return std::sqrt(square) * (1 + few_roundings) + 0x1p-500;
}

}  // namespace tetracone::kernel

#endif
