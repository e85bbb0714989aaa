#ifndef TETRACONE_KERNEL_PREDICATE_ENCLOSED_DISTANCE_H
#define TETRACONE_KERNEL_PREDICATE_ENCLOSED_DISTANCE_H

#include "tetracone/kernel/number/double_double_ball.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/number/vertex.h"
#include "tetracone/kernel/predicate/adaptive_double_double.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

/// The distance of two features of triangles, enclosed in double-double. It is the answer of face_distance.h where the
/// enclosures decide.
namespace tetracone::kernel {

using Ball_vector = std::array<Double_double_ball, 3>;

/// The enclosed corners, one to three, that span a feature of a triangle.
struct Ball_hull {
  std::array<Ball_vector, 3> corner;
  int count = 0;

  /// Adds the enclosed image of a vertex.
  void add(const Vertex& vertex, const Pose& pose)
  {
    const auto image = Adaptive_double_double::double_double_image(Adaptive_points::placed(vertex, pose));
    for (std::size_t k = 0; k < 3; ++k) corner[std::size_t(count)][k] = {image.coordinate[k], image.error};
    ++count;
  }
  /// Adds the difference of a vertex and a point, which is exact where it does not overflow.
  void add_difference(const Vertex& vertex, const Vertex& point)
  {
    for (std::size_t k = 0; k < 3; ++k) corner[std::size_t(count)][k] = {Double_double::sum(vertex[k], -point[k]), 0};
    ++count;
  }

  /// Returns this hull relative to a point.
  Ball_hull from(const Ball_vector& point) const
  {
    Ball_hull relative;
    for (; relative.count < count; ++relative.count)
      relative.corner[std::size_t(relative.count)] = difference(corner[std::size_t(relative.count)], point);
    return relative;
  }
};

/// The distance height / sqrt(square), along a direction from A's feature to B's of |direction|^2 = square.
struct Enclosed_distance {
  Double_double_ball height, square;
  std::array<double, 3> direction;  ///< the high parts of `way`, up to `direction_error` of the sum of their magnitudes
  Ball_vector way;                  ///< the direction, enclosed

  // Upper bounds relative to the sum of the direction's magnitudes.
  static constexpr double most_radii = 0x1p-52,  ///< of the sum of the radii of an accepted direction, which is tested
      direction_error = 0x1p-51;  ///< of all errors of a direction: these radii, and a rounding of each coordinate
  /// Upper bound of an error of `is_surely_over`. It is proved, as the others are, in verify/proofs/nearest_proofs.h.
  static constexpr double side_rounding = 0x1p-48;
};

namespace detail {

/// Returns a positive multiple of the vector from 0 to the line of an edge. Returns nothing unless the nearest point is
/// surely within the edge.
inline std::optional<Ball_vector> way_to_edge(const Ball_vector& a, const Ball_vector& b)
{
  const Ball_vector e = difference(b, a);
  const Double_double_ball length = dot(e, e), at = -dot(a, e);
  if (!at.is_positive() || !(length - at).is_positive()) return std::nullopt;
  return sum(scaled(e, at), scaled(a, length));
}

/// Returns the cross product of two edges; nothing unless the nearest points of their lines are surely within both.
inline std::optional<Ball_vector> way_across_edges(const Ball_vector& a, const Ball_vector& b, const Ball_vector& c,
                                                   const Ball_vector& d)
{
  const Ball_vector e = difference(b, a), f = difference(d, c), r = difference(a, c);
  const Double_double_ball ee = dot(e, e), ef = dot(e, f), ff = dot(f, f), er = dot(e, r), fr = dot(f, r);
  const Double_double_ball weight = ee * ff - ef * ef, s = ef * fr - ff * er, t = ee * fr - ef * er;
  if (!s.is_positive() || !t.is_positive() || !(weight - s).is_positive() || !(weight - t).is_positive())
    return std::nullopt;
  return cross(e, f);
}

/// True when 0 is surely over the interior of a triangle with this normal, by doubles, provided that the normal is
/// known up to `most_radii`. `distance_along` tests that.
///
/// L is the largest coordinate of a corner, and n the normal. A corner's coordinate has an error of 2 u L: its low part
/// and its radius. For a side from p to q, n . (p x q) then has an error of at most `side_rounding` |n|_1 L^2.
inline bool is_surely_over(const std::array<Ball_vector, 3>& t, const Ball_vector& normal)
{
  std::array<std::array<double, 3>, 3> p;
  double largest = 0, radius = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      p[i][k] = t[i][k].middle.high;
      largest = maximum(largest, std::abs(p[i][k]));
      radius = maximum(radius, t[i][k].radius);
    }
  const std::array<double, 3> n = {normal[0].middle.high, normal[1].middle.high, normal[2].middle.high};
  const double length = std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]);
  const bool is_in_range = largest > 0x1p-200 && largest < 0x1p200 && length > 0x1p-400 && length < 0x1p400;
  if (!is_in_range || !(radius <= unit_roundoff<double> * largest)) return false;
  const double slack = Enclosed_distance::side_rounding * length * (largest * largest);
  return dot(n, cross(p[0], p[1])) > slack && dot(n, cross(p[1], p[2])) > slack && dot(n, cross(p[2], p[0])) > slack;
}

/// Returns the normal of a triangle; nothing unless 0 is surely over its interior, or the normal is not known up to
/// `most_radii`.
inline std::optional<Ball_vector> way_to_triangle(const std::array<Ball_vector, 3>& t)
{
  const Ball_vector normal = normal_of(t);
  if (is_surely_over(t, normal)) return normal;
  for (std::size_t k = 0; k < 3; ++k)
    if (!dot(normal, cross(t[k], t[(k + 1) % 3])).is_positive()) return std::nullopt;
  return normal;
}

/// Returns the distance of 0 from a plane or a point. `way` is the normal or the vector, of either sign, and `point` is
/// on it. Returns nothing unless the point is
/// surely apart from 0, and the direction is known up to `most_radii`.
inline std::optional<Enclosed_distance> distance_along(Ball_vector way, const Ball_vector& point)
{
  Enclosed_distance found;
  found.height = dot(way, point);
  if (!found.height.is_positive()) {
    found.height = -found.height;
    way = negated(way);
  }
  if (!found.height.is_positive()) return std::nullopt;
  found.square = dot(way, way);
  double off = 0, magnitude = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    found.direction[k] = way[k].middle.high;
    off += way[k].radius;
    magnitude += std::abs(found.direction[k]);
  }
  if (!(off < Enclosed_distance::most_radii * magnitude)) return std::nullopt;
  found.way = way;
  return found;
}

}  // namespace detail

/// Returns the distance of 0 and a hull, as `enclosed_distance` does.
inline std::optional<Enclosed_distance> enclosed_distance_of_origin(const Ball_hull& hull)
{
  const auto& [a, b, c] = hull.corner;
  const auto way = hull.count == 1   ? std::optional(a)
                   : hull.count == 2 ? detail::way_to_edge(a, b)
                                     : detail::way_to_triangle(hull.corner);
  return way ? detail::distance_along(*way, a) : std::nullopt;
}

/// Returns the distance that `distance_of_hulls` (face_distance.h) gives for exact corners. Returns nothing unless the
/// enclosures show that the nearest points of the affine hulls are apart and within both hulls. The direction must be
/// known up to `most_radii`.
inline std::optional<Enclosed_distance> enclosed_distance(const Ball_hull& a, const Ball_hull& b)
{
  if (a.count == 1) return enclosed_distance_of_origin(b.from(a.corner[0]));
  if (b.count == 1) {
    auto found = enclosed_distance_of_origin(a.from(b.corner[0]));
    if (found) {
      found->direction = negated(found->direction);
      found->way = negated(found->way);
    }
    return found;
  }
  if (a.count != 2 || b.count != 2) return std::nullopt;
  const auto way = detail::way_across_edges(a.corner[0], a.corner[1], b.corner[0], b.corner[1]);
  return way ? detail::distance_along(*way, difference(b.corner[0], a.corner[0])) : std::nullopt;
}

}  // namespace tetracone::kernel

#endif
