#ifndef TETRACONE_KERNEL_PREDICATE_FACE_DISTANCE_H
#define TETRACONE_KERNEL_PREDICATE_FACE_DISTANCE_H

#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/products.h"

#include <CGAL/Mpzf.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

/// The exact distance of two faces. It is 0 where the faces cross. Else it is attained between a vertex and a face, a
/// vertex and an edge, two vertices, or two edges. Coordinates are binary fractions. Those of both faces are multiplied
/// by one common weight.
namespace tetracone::kernel {

using Exact_number = CGAL::Mpzf;
using Exact_vector = std::array<Exact_number, 3>;

/// The point at / weight, weight > 0.
struct Exact_point {
  Exact_vector at;
  Exact_number weight = 1;
};

/// The nearest points of two sets, and the direction m from A's to B's. It has m . a <= low for all points a of A's
/// feature, and m . b >= high for all points b of B's. The squared distance is top() / bottom() = (high - low)^2 / m^2.
/// Where the sets meet, low = high; where an edge crosses a face, both are 0 and bound nothing.
struct Exact_distance {
  Exact_vector direction;
  Exact_number low, high;
  Exact_point on_a, on_b;

  /// Return the numerator and the divisor of the squared distance. The divisor is 1 where the direction is 0.
  Exact_number top() const { return (high - low) * (high - low); }
  Exact_number bottom() const
  {
    const Exact_number square = dot(direction, direction);
    return square.sign() == CGAL::ZERO ? Exact_number(1) : square;
  }
  /// True when the sets meet.
  bool is_zero() const { return low == high; }

  /// Compares the distances.
  friend bool operator<(const Exact_distance& x, const Exact_distance& y)
  {
    return x.top() * y.bottom() < y.top() * x.bottom();
  }

  /// Returns the distance as seen from B.
  Exact_distance reversed() const { return {negated(direction), -high, -low, on_b, on_a}; }
};

namespace detail {

/// Returns the distance along a direction, from a point of A to one of B. It turns the direction so that B is beyond A.
inline Exact_distance along(Exact_vector direction, const Exact_vector& a, const Exact_vector& b, Exact_point on_a,
                            Exact_point on_b)
{
  Exact_number low = dot(direction, a), high = dot(direction, b);
  if (high < low) {
    direction = negated(direction);
    low = -low;
    high = -high;
  }
  return {std::move(direction), std::move(low), std::move(high), std::move(on_a), std::move(on_b)};
}

}  // namespace detail

/// Returns the distance of two points.
inline Exact_distance distance_of_points(const Exact_vector& x, const Exact_vector& y)
{
  return detail::along(difference(y, x), x, y, {x}, {y});
}

/// Tells whether the nearest points are asked for, or only the direction and the supports of the features along it.
enum class Nearest_points { are_not_asked_for, are_asked_for };

/// Returns the distance of a point and a segment where the nearest point of the segment's line is on the segment.
/// Returns nothing elsewhere, and for a segment that is a point.
inline std::optional<Exact_distance> distance_to_edge(const Exact_vector& x, const Exact_vector& a,
                                                      const Exact_vector& b,
                                                      Nearest_points points = Nearest_points::are_asked_for)
{
  const Exact_vector e = difference(b, a), r = difference(x, a);
  const Exact_number length = dot(e, e), at = dot(r, e), left = length - at;
  if (length.sign() == CGAL::ZERO || at.sign() == CGAL::NEGATIVE || left.sign() == CGAL::NEGATIVE) return {};
  const Exact_vector direction = difference(scaled(e, at), scaled(r, length));
  if (points == Nearest_points::are_not_asked_for) return detail::along(direction, x, a, {}, {});
  return detail::along(direction, x, a, {x}, {sum(scaled(a, left), scaled(b, at)), length});
}

/// Returns the distance of two segments where the nearest points of their lines are on them; nothing elsewhere, and for
/// parallel ones.
inline std::optional<Exact_distance> distance_of_edges(const Exact_vector& a, const Exact_vector& b,
                                                       const Exact_vector& c, const Exact_vector& d,
                                                       Nearest_points points = Nearest_points::are_asked_for)
{
  const Exact_vector e = difference(b, a), f = difference(d, c), r = difference(a, c);
  const Exact_number ee = dot(e, e), ef = dot(e, f), ff = dot(f, f), er = dot(e, r), fr = dot(f, r);
  const Exact_number weight = ee * ff - ef * ef;
  if (weight.sign() == CGAL::ZERO) return {};
  const Exact_number s = ef * fr - ff * er, t = ee * fr - ef * er, s_left = weight - s, t_left = weight - t;
  for (const Exact_number* share : {&s, &t, &s_left, &t_left})
    if (share->sign() == CGAL::NEGATIVE) return {};
  if (points == Nearest_points::are_not_asked_for) return detail::along(cross(e, f), a, c, {}, {});
  return detail::along(cross(e, f), a, c, {sum(scaled(a, s_left), scaled(b, s)), weight},
                       {sum(scaled(c, t_left), scaled(d, t)), weight});
}

/// Returns the distance of a point and the plane through three, wherever the nearest point is. Returns nothing where
/// the three are on a line.
inline std::optional<Exact_distance> distance_to_plane(const Exact_vector& x, const std::array<Exact_vector, 3>& plane,
                                                       Nearest_points points = Nearest_points::are_asked_for)
{
  const Exact_vector normal = normal_of(plane);
  const Exact_number weight = dot(normal, normal);
  if (weight.sign() == CGAL::ZERO) return {};
  if (points == Nearest_points::are_not_asked_for) return detail::along(normal, x, plane[0], {}, {});
  const Exact_number height = dot(normal, difference(x, plane[0]));
  return detail::along(normal, x, plane[0], {x}, {difference(scaled(x, weight), scaled(normal, height)), weight});
}

/// Returns the distance of a point and a triangle where the nearest point of its plane is on it. Returns nothing
/// elsewhere, and for corners on a line.
inline std::optional<Exact_distance> distance_to_triangle(const Exact_vector& x, const std::array<Exact_vector, 3>& t,
                                                          Nearest_points points = Nearest_points::are_asked_for)
{
  const Exact_vector normal = normal_of(t);
  for (int k = 0; k < 3; ++k) {
    const Exact_vector a = difference(t[k], x), b = difference(t[(k + 1) % 3], x);
    if (dot(normal, cross(a, b)).sign() == CGAL::NEGATIVE) return {};
  }
  return distance_to_plane(x, t, points);
}

/// A face in exact coordinates: the directed edges of all loops and, if it is not on a line, three corners that span
/// its plane.
struct Exact_face {
  std::vector<std::array<Exact_vector, 2>> edges;
  std::optional<std::array<Exact_vector, 3>> plane;
};

namespace detail {

/// Returns the winding number of the loops about the line through x along `axis`, which leaves the plane on the side of
/// its normal. The number is arbitrary where the line meets a loop.
inline int winding_about_line(const Exact_face& face, const Exact_vector& x, const Exact_vector& axis)
{
  const Exact_vector start = difference(face.edges.front()[0], x);
  int winding = 0;
  for (const auto& [from, to] : face.edges) {
    const Exact_vector a = difference(from, x), b = difference(to, x);
    const bool from_left = dot(axis, cross(start, a)).sign() != CGAL::NEGATIVE,
               to_left = dot(axis, cross(start, b)).sign() != CGAL::NEGATIVE;
    if (from_left == to_left) continue;
    const CGAL::Sign turn = dot(axis, cross(a, b)).sign();
    if (from_left && turn == CGAL::POSITIVE) ++winding;
    if (!from_left && turn == CGAL::NEGATIVE) --winding;
  }
  return winding;
}

inline void keep_nearer(std::optional<Exact_distance>& best, std::optional<Exact_distance> found)
{
  if (found && (!best || *found < *best)) best = std::move(found);
}

/// Keeps the least distance of the corners and edges of `a` from the interior of `b`. With `turn`, it is kept as seen
/// from `b`.
inline void keep_nearer_inside(std::optional<Exact_distance>& best, const Exact_face& a, const Exact_face& b, bool turn)
{
  if (!b.plane) return;
  const Exact_vector normal = normal_of(*b.plane);
  const auto keep = [&](std::optional<Exact_distance> found) {
    keep_nearer(best, found && turn ? std::optional(found->reversed()) : std::move(found));
  };
  for (const auto& [p, q] : a.edges) {
    if (winding_about_line(b, p, normal) != 0) keep(distance_to_plane(p, *b.plane));
    const Exact_number at_p = dot(normal, difference(p, (*b.plane)[0])),
                       at_q = dot(normal, difference(q, (*b.plane)[0]));
    if (at_p.sign() * at_q.sign() != CGAL::NEGATIVE) continue;
    const bool up = at_p.sign() == CGAL::NEGATIVE;
    const Exact_vector upwards = up ? difference(q, p) : difference(p, q);
    if (winding_about_line(b, p, upwards) == 0) continue;
    const Exact_number weight = up ? at_q - at_p : at_p - at_q;
    const Exact_point both = {up ? sum(scaled(p, at_q), scaled(q, -at_p)) : sum(scaled(p, -at_q), scaled(q, at_p)),
                              weight};
    keep(Exact_distance{normal, 0, 0, both, both});
  }
}

}  // namespace detail

/// Returns the distance of two faces. Requires that each has an edge.
inline Exact_distance distance_of_faces(const Exact_face& a, const Exact_face& b)
{
  std::optional<Exact_distance> best;
  for (const auto& [p, q] : a.edges)
    for (const auto& [r, s] : b.edges) {
      detail::keep_nearer(best, distance_of_points(p, r));
      detail::keep_nearer(best, distance_to_edge(p, r, s));
      if (auto found = distance_to_edge(r, p, q)) detail::keep_nearer(best, found->reversed());
      detail::keep_nearer(best, distance_of_edges(p, q, r, s));
    }
  detail::keep_nearer_inside(best, a, b, false);
  detail::keep_nearer_inside(best, b, a, true);
  return *best;
}

/// Returns the distance of two hulls of one to three corners, where the nearest points of their affine hulls are on
/// them. One of the hulls is a corner, or both are edges. Such hulls may be the features of triangles that hold their
/// nearest points. Returns nothing elsewhere.
inline std::optional<Exact_distance> distance_of_hulls(const std::vector<Exact_vector>& a,
                                                       const std::vector<Exact_vector>& b, Nearest_points points)
{
  if (a.size() > b.size()) {
    auto found = distance_of_hulls(b, a, points);
    if (found) found = found->reversed();
    return found;
  }
  if (a.size() == 1 && b.size() == 1) return distance_of_points(a[0], b[0]);
  if (a.size() == 1 && b.size() == 2) return distance_to_edge(a[0], b[0], b[1], points);
  if (a.size() == 2 && b.size() == 2) return distance_of_edges(a[0], a[1], b[0], b[1], points);
  if (a.size() == 1 && b.size() == 3) return distance_to_triangle(a[0], {b[0], b[1], b[2]}, points);
  return {};
}

}  // namespace tetracone::kernel

#endif
