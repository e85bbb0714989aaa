#ifndef TETRACONE_KERNEL_BOUND_TRIANGLE_DISTANCE_H
#define TETRACONE_KERNEL_BOUND_TRIANGLE_DISTANCE_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/simd/simd.h"

#include <array>
#include <cmath>
#include <cstddef>

/// Bounds of the distance of two triangles, in double.
///
/// The distance of any two points, one in each triangle, is an upper bound. Along any direction n, the gap min n . b -
/// max n . a over the corners is |n| times a lower bound. For convex sets the two bounds are equal where the points are
/// nearest and n leads from one to the other. So the search for the points needs no error bound; the two bounds have
/// one each.
namespace tetracone::kernel {

using Double_vector = std::array<double, 3>;
using Double_triangle = std::array<Double_vector, 3>;

/// A triangle, and its edges, a lane each; the fourth is the first again. `at` is the start of an edge, `way` the
/// vector to its end.
struct alignas(32) Edged_triangle {
  double at[3][4] = {}, way[3][4] = {};
  Double_triangle corner{};

  Edged_triangle() = default;
  Edged_triangle(const Double_triangle& t) : corner(t)
  {
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 4; ++i) {
        at[k][i] = t[i % 3][k];
        way[k][i] = t[(i + 1) % 3][k] - t[i % 3][k];
      }
  }
};

/// Bounds of the distance of two triangles.
struct Triangle_gap {
  double low = 0;             ///< lower bound of the distance
  double high = 0;            ///< upper bound of the distance
  double nearest = 0;         ///< the distance as computed
  unsigned of_a = 0;          ///< corners of A that span the feature which seems to hold the nearest point, as bits
  unsigned of_b = 0;          ///< corners of B, likewise
  Double_vector direction{};  ///< from A's nearest point to B's
};

namespace triangle_distance {

constexpr double u = unit_roundoff<double>;

/// Upper bound of the relative error of a length that is computed as the root of a sum of three squares. It also covers
/// one more product. These are 4 u and terms of second order (verify/proofs/distance_proofs.h).
inline constexpr double length_rounding = 8 * u;

/// Upper bound of what a length loses where squares underflow: the root of three times 2^-1075. It is counted by hand
/// (verify/proofs/other_constants.h).
inline constexpr double length_underflow = 0x1p-536;

/// Upper bound of the error of a point in a triangle, or of a product with a direction, relative to the largest
/// coordinate R (verify/proofs/distance_proofs.h).
inline constexpr double point_rounding = 16 * u;

/// Returns an upper bound of the error of a distance of points, and of a gap along n over |n|. Points have an error of
/// at most `position_error` in a coordinate, and are then rounded. 4 is above 2 sqrt(3), the length of two errors in
/// three coordinates. For a gap, |n|_1 is at most sqrt(3) |n|_2.
template <class Number>
Number slack(const Number& position_error, const Number& largest)
{
  return Number(4) * (position_error + Number(point_rounding) * largest);
}

/// Returns a + s (b - a) + r (c - a).
template <class Number>
std::array<Number, 3> point_in_triangle(const std::array<std::array<Number, 3>, 3>& t, const Number& s, const Number& r)
{
  const auto at = [&](std::size_t k) { return t[0][k] + (s * (t[1][k] - t[0][k]) + r * (t[2][k] - t[0][k])); };
  return {at(0), at(1), at(2)};
}

/// Returns a lower bound of the distance, by a gap along n and by `length`, the root of n . n as computed.
inline double below(double gap, double length, double slack)
{
  const double low = gap / length * (1 - length_rounding) - slack;
  return low > 0 ? low : 0;
}
/// Returns an upper bound of a distance of points, by the distance as computed.
inline double above(double distance, double slack)
{
  return distance * (1 + length_rounding) + slack + length_underflow;
}

/// Two points, p of A and q of B, and the corners that span the features that hold them, as bits.
struct Nearest {
  Double_vector p{}, q{};
  unsigned of_a = 0, of_b = 0;
};

/// For each edge of A: the nearest edge of B, the places of the nearest points on both, and their squared distance.
struct alignas(32) Near_edges {
  double square[4], s[4], t[4], of_b[4];
};

}  // namespace triangle_distance
}  // namespace tetracone::kernel

#define TETRACONE_SIMD_FILE "tetracone/kernel/bound/triangle_distance_simd.inl"
#include "tetracone/kernel/simd/simd_rounds.h"

namespace tetracone::kernel {
namespace triangle_distance {

/// Returns the nearest points of the edges of both, as computed, and the features that hold them.
inline Nearest nearest_on_edges(const Edged_triangle& a, const Edged_triangle& b)
{
  static auto* const fastest = TETRACONE_SIMD_FASTEST(nearest_on_edges_simd);
  Near_edges near;
  fastest(a, b, near);
  int i = 0;
  for (int k = 1; k < 3; ++k)
    if (near.square[k] < near.square[i]) i = k;
  const int j = int(near.of_b[i]), i1 = i == 2 ? 0 : i + 1, j1 = j == 2 ? 0 : j + 1;
  const double s = near.s[i], t = near.t[i];
  Nearest n;
  for (int k = 0; k < 3; ++k) {
    n.p[k] = a.at[k][i] + s * a.way[k][i];
    n.q[k] = b.at[k][j] + t * b.way[k][j];
  }
  n.of_a = (s < 1 ? 1u << i : 0) | (s > 0 ? 1u << i1 : 0);
  n.of_b = (t < 1 ? 1u << j : 0) | (t > 0 ? 1u << j1 : 0);
  return n;
}

/// True when all corners of `x` are on one side of the plane of `t`, and the nearest of them is over `t`. Then it
/// writes that corner, its number, and the foot of its perpendicular on `t`.
inline bool over_triangle(const Double_triangle& x, const Double_triangle& t, Double_vector& corner,
                          Double_vector& foot, int& which)
{
  const Double_vector e = difference(t[1], t[0]), f = difference(t[2], t[0]), normal = cross(e, f);
  const double square = dot(normal, normal);
  const auto height = [&](int k) { return dot(normal, difference(x[k], t[0])); };
  const double h[3] = {height(0), height(1), height(2)};
  const bool above = h[0] > 0 && h[1] > 0 && h[2] > 0, below = h[0] < 0 && h[1] < 0 && h[2] < 0;
  if (!(above || below) || !(square > 0)) return false;
  which = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(h[k]) < std::abs(h[which])) which = k;
  const Double_vector d = difference(x[which], t[0]);
  const double s = dot(cross(d, f), normal) / square, r = dot(cross(e, d), normal) / square;
  if (!(s >= 0 && r >= 0 && s + r <= 1)) return false;
  corner = x[which];
  foot = point_in_triangle(t, s, r);
  return true;
}

/// Returns the least n . x of the corners.
inline double least_along(const Double_vector& n, const Double_triangle& t)
{
  return minimum(dot(n, t[0]), dot(n, t[1]), dot(n, t[2]));
}

}  // namespace triangle_distance

/// Returns a lower bound of the distance, by the gap along a direction n from A to B; 0 where that gives none.
/// Coordinates are at most `largest` and have an error of at most `position_error`.
inline double least_gap(const Double_triangle& a, const Double_triangle& b, const Double_vector& n,
                        double position_error, double largest)
{
  namespace td = triangle_distance;
  const double length = std::sqrt(dot(n, n));
  // Below that, products of n underflow.
  if (!(length > 0x1p-400)) return 0;
  const double gap = td::least_along(n, b) + td::least_along(negated(n), a);
  return td::below(gap, length, td::slack(position_error, largest));
}

/// True when m . x < m . p is certain for every direction m with |m - n|_1 <= 2^-51 |n|_1. Coordinates of x and p are
/// at most `largest` and have an error of at most `position_error`. False for numbers near the ends of the doubles'
/// range.
///
/// The error of n . (x - p) is the sum of three terms, each times |n|_1: 2 `position_error` for the points, 2^-51 times
/// 2 `largest` for n, and 5 u times 2 `largest` for roundings.
inline bool is_surely_before(const Double_vector& x, const Double_vector& p, const Double_vector& n,
                             double position_error, double largest)
{
  const double length = std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]);
  // Below these sizes, products underflow by more than the slack.
  return length > 0x1p-400 && length < 0x1p400 && largest > 0x1p-500 &&
         dot(n, difference(x, p)) < -length * triangle_distance::slack(position_error, largest);
}

namespace triangle_distance {

/// Returns the bounds that two points, one in each triangle, give. The other arguments are those of `least_gap`.
inline Triangle_gap gap_of(const Nearest& points, const Double_triangle& a, const Double_triangle& b,
                           double position_error, double largest)
{
  Triangle_gap found;
  found.direction = difference(points.q, points.p);
  found.nearest = std::sqrt(dot(found.direction, found.direction));
  found.high = above(found.nearest, slack(position_error, largest));
  found.low = least_gap(a, b, found.direction, position_error, largest);
  found.of_a = points.of_a;
  found.of_b = points.of_b;
  return found;
}

}  // namespace triangle_distance

/// Returns bounds of the distance of triangles whose coordinates are at most `largest` and have an error of at most
/// `position_error`. Infinite or undefined errors give low = 0 and an infinite or undefined high. Where the distance is
/// above `limit`, the bounds need not be close.
///
/// The nearest points of triangles that are apart are on two edges, or are a corner and a point inside the other. If on
/// edges, the first bounds agree. For triangles that cross, low is 0 and high need not be close.
inline Triangle_gap triangle_gap(const Edged_triangle& with_edges_a, const Edged_triangle& with_edges_b,
                                 double position_error, double largest, double limit = HUGE_VAL)
{
  namespace td = triangle_distance;
  const Double_triangle &a = with_edges_a.corner, &b = with_edges_b.corner;
  const Triangle_gap found =
      td::gap_of(td::nearest_on_edges(with_edges_a, with_edges_b), a, b, position_error, largest);
  if (found.low > limit || found.low >= found.nearest * (1 - 0x1p-40)) return found;
  td::Nearest inside;
  int which = 0;
  if (td::over_triangle(a, b, inside.p, inside.q, which)) {
    inside.of_a = 1u << which;
    inside.of_b = 7;
  } else if (td::over_triangle(b, a, inside.q, inside.p, which)) {
    inside.of_a = 7;
    inside.of_b = 1u << which;
  } else {
    return found;
  }
  return td::gap_of(inside, a, b, position_error, largest);
}

}  // namespace tetracone::kernel

#endif
