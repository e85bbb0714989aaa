#ifndef TETRACONE_KERNEL_BOUND_TRIANGLE_DISTANCE_H
#define TETRACONE_KERNEL_BOUND_TRIANGLE_DISTANCE_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/products.h"

#include <array>
#include <cmath>

/// The distance of two triangles in double, enclosed.
///
/// Whatever leads to two points, one in each triangle, their distance is an upper bound; and along whatever direction n,
/// the gap min n . b - max n . a over the corners is |n| times a lower bound. Of convex sets the two meet where the
/// points are nearest and n leads from one to the other: so the search for them needs no error bound, the two bounds
/// have one each.
namespace tetracone::kernel {

using Double_vector = std::array<double, 3>;
using Double_triangle = std::array<Double_vector, 3>;

/// What is known of the distance of two triangles.
struct Triangle_gap {
  double low = 0;      ///< at most the distance
  double high = 0;     ///< at least the distance
  double nearest = 0;  ///< the distance as computed
  unsigned of_a = 0;   ///< corners that span the feature that seems to hold A's nearest point, as bits
  unsigned of_b = 0;
  Double_vector direction{};  ///< from A's nearest point to B's
};

namespace triangle_distance {

constexpr double u = unit_roundoff<double>;

/// Roundings of a length that is computed as the root of a sum of three squares, and of one more product: 4 u and
/// second order.
inline constexpr double length_rounding = 8 * u;

/// Of a point in a triangle or a product with a direction, a share of the largest coordinate R.
inline constexpr double point_rounding = 16 * u;

/// What a distance of points may be off by, and what a gap over |n| may be off by: points are off by `position_error`
/// in a coordinate, and then rounded. 4 is above 2 sqrt(3), the length of two errors in three coordinates; n has
/// |n|_1 <= sqrt(3) |n|_2.
template <class Number>
Number slack(const Number& position_error, const Number& largest)
{
  return Number(4) * (position_error + Number(point_rounding) * largest);
}

/// a + s (b - a) + t (c - a).
template <class Number>
std::array<Number, 3> point_in_triangle(const std::array<std::array<Number, 3>, 3>& t, const Number& s, const Number& r)
{
  const auto at = [&](std::size_t k) { return t[0][k] + (s * (t[1][k] - t[0][k]) + r * (t[2][k] - t[0][k])); };
  return {at(0), at(1), at(2)};
}

/// A lower bound of the distance from a gap along n, and the root of n . n as computed.
inline double below(double gap, double length, double slack)
{
  const double low = gap / length * (1 - length_rounding) - slack;
  return low > 0 ? low : 0;
}
inline double above(double distance, double slack) { return distance * (1 + length_rounding) + slack; }

/// Two points, and the corners that span the features that hold them.
struct Nearest {
  Double_vector p{}, q{};
  unsigned of_a = 0, of_b = 0;
  double square = 0;
};

inline double clamped(double x) { return x > 0 ? (x < 1 ? x : 1) : 0; }

/// The nearest points of edges i of A and j of B.
inline Nearest of_edges(const Double_triangle& a, int i, const Double_triangle& b, int j)
{
  const int i1 = i == 2 ? 0 : i + 1, j1 = j == 2 ? 0 : j + 1;
  const Double_vector e = difference(a[i1], a[i]), f = difference(b[j1], b[j]), r = difference(a[i], b[j]);
  const double ee = dot(e, e), ff = dot(f, f), ef = dot(e, f), er = dot(e, r), fr = dot(f, r);
  const double weight = ee * ff - ef * ef;
  double s = weight > 0 ? clamped((ef * fr - ff * er) / weight) : 0;
  double t = ff > 0 ? clamped((ef * s + fr) / ff) : 0;
  s = ee > 0 ? clamped((ef * t - er) / ee) : 0;
  Nearest n;
  for (int k = 0; k < 3; ++k) {
    n.p[k] = a[i][k] + s * e[k];
    n.q[k] = b[j][k] + t * f[k];
  }
  n.of_a = (s < 1 ? 1u << i : 0) | (s > 0 ? 1u << i1 : 0);
  n.of_b = (t < 1 ? 1u << j : 0) | (t > 0 ? 1u << j1 : 0);
  const Double_vector d = difference(n.q, n.p);
  n.square = dot(d, d);
  return n;
}

/// Where all corners of `x` are on one side of the plane of `t`, and the nearest of them is over `t`: that corner, and
/// the point below it.
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

/// The least n . x of the corners.
inline double least_along(const Double_vector& n, const Double_triangle& t)
{
  return minimum(dot(n, t[0]), dot(n, t[1]), dot(n, t[2]));
}

}  // namespace triangle_distance

/// A lower bound of the distance: the gap along a direction; 0 where it tells nothing.
inline double least_gap(const Double_triangle& a, const Double_triangle& b, const Double_vector& n,
                        double position_error, double largest)
{
  namespace td = triangle_distance;
  const double length = std::sqrt(dot(n, n));
  // Below that, products of n underflow.
  if (!(length > 0x1p-400)) return 0;
  const double gap = td::least_along(n, b) + td::least_along({-n[0], -n[1], -n[2]}, a);
  return td::below(gap, length, td::slack(position_error, largest));
}

/// The distance of triangles whose coordinates are at most `largest` and off by at most `position_error`. Infinite or
/// undefined errors give low = 0 and a high that is no bound to anything: infinite or undefined.
inline Triangle_gap triangle_gap(const Double_triangle& a, const Double_triangle& b, double position_error,
                                 double largest)
{
  namespace td = triangle_distance;
  td::Nearest best;
  int which = 0;
  if (td::over_triangle(a, b, best.p, best.q, which)) {
    best.of_a = 1u << which;
    best.of_b = 7;
  } else if (td::over_triangle(b, a, best.q, best.p, which)) {
    best.of_a = 7;
    best.of_b = 1u << which;
  } else {
    best.square = HUGE_VAL;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (const td::Nearest n = td::of_edges(a, i, b, j); n.square < best.square) best = n;
  }
  Triangle_gap found;
  found.direction = difference(best.q, best.p);
  found.nearest = std::sqrt(dot(found.direction, found.direction));
  found.high = td::above(found.nearest, td::slack(position_error, largest));
  found.low = least_gap(a, b, found.direction, position_error, largest);
  found.of_a = best.of_a;
  found.of_b = best.of_b;
  return found;
}

}  // namespace tetracone::kernel

#endif
