#ifndef TETRACONE_KERNEL_BOUND_POINT_TRIANGLE_H
#define TETRACONE_KERNEL_BOUND_POINT_TRIANGLE_H

#include "tetracone/kernel/bound/triangle_distance.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/products.h"

#include <cmath>

namespace tetracone::kernel {

/// Bounds of the distance of the point 0 and a triangle, in double.
struct Point_gap {
  double low = 0;        ///< lower bound of the distance
  double high = 0;       ///< upper bound of the distance
  double nearest = 0;    ///< the distance as computed
  unsigned corners = 0;  ///< bits: the corners of the vertex, edge or triangle that seems nearest
};

namespace detail {

/// Where the nearest point of a triangle seems to be: a + s (b - a) + r (c - a), s and r from 0 to 1.
struct Nearest_place {
  double s = 0, r = 0;
  unsigned corners;
};

/// Returns the place of the triangle's point nearest to 0, by the regions of its corners and edges (after Ericson,
/// Real-Time Collision Detection, 5.1.5). No error is bounded: `point_gap` needs none.
inline Nearest_place nearest_place(const Double_triangle& t)
{
  const Double_vector &a = t[0], &b = t[1], &c = t[2], e = difference(b, a), f = difference(c, a);
  const double ea = -dot(e, a), fa = -dot(f, a);
  if (ea <= 0 && fa <= 0) return {0, 0, 1};
  const double eb = -dot(e, b), fb = -dot(f, b);
  if (eb >= 0 && fb <= eb) return {1, 0, 2};
  const double of_c = ea * fb - eb * fa;
  if (of_c <= 0 && ea >= 0 && eb <= 0) return {ea / (ea - eb), 0, 3};
  const double ec = -dot(e, c), fc = -dot(f, c);
  if (fc >= 0 && ec <= fc) return {0, 1, 4};
  const double of_b = ec * fa - ea * fc;
  if (of_b <= 0 && fa >= 0 && fc <= 0) return {0, fa / (fa - fc), 5};
  const double of_a = eb * fc - ec * fb, to_c = fb - eb, to_b = ec - fc;
  if (of_a <= 0 && to_c >= 0 && to_b >= 0) {
    const double r = to_c / (to_c + to_b);
    return {1 - r, r, 6};
  }
  const double whole = of_a + of_b + of_c, s = minimum(of_b / whole, 1.0);
  return {s, minimum(of_c / whole, 1 - s), 7};
}

}  // namespace detail

/// Returns bounds of the distance of 0 and a triangle. Its coordinates are at most `largest` and have an error of at
/// most `error`, which includes the error of the point. A NaN gives low = 0, and a high that is NaN.
///
/// The bounds are computed as in `triangle_gap`, from a point in the triangle and the direction to it. A place may be
/// outside by two roundings, at most 2 u in s + r: an error of 4 u `largest` in a coordinate.
inline Point_gap point_gap(const Double_triangle& t, double error, double largest)
{
  namespace td = triangle_distance;
  const auto place = detail::nearest_place(t);
  const Double_vector nearest = td::point_in_triangle(t, place.s, place.r);
  const double length = std::sqrt(dot(nearest, nearest)), slack = td::slack(error + 4 * td::u * largest, largest);
  Point_gap gap{0, td::above(length, slack), length, place.corners};
  // Below that, products of the direction underflow.
  if (length > 0x1p-400) gap.low = td::below(td::least_along(nearest, t), length, slack);
  return gap;
}

}  // namespace tetracone::kernel

#endif
