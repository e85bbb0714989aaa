#ifndef TETRACONE_KERNEL_PREDICATE_TRIANGLE_TRIANGLE_H
#define TETRACONE_KERNEL_PREDICATE_TRIANGLE_TRIANGLE_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/predicate/adaptive_bounds.h"
#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/kernel/predicate/segment_face.h"
#include "tetracone/kernel/predicate/signs.h"

#include <array>
#include <cmath>
#include <optional>

namespace tetracone::kernel {

template <class K>
using Corners = std::array<const Point<K>*, 3>;

/// Returns the sides of three points against the plane of a triangle: `volume_sign` of the triangle with each.
template <class K>
std::array<Sign, 3> sides(const Corners<K>& triangle, const Corners<K>& points)
{
  std::array<Sign, 3> side;
  for (int k = 0; k < 3; ++k) side[k] = volume_sign<K>(*triangle[0], *triangle[1], *triangle[2], *points[k]);
  return side;
}

/// The sides of three points against a plane. A side that is not decided is arbitrary.
struct Some_sides {
  std::array<Sign, 3> side;
  std::array<bool, 3> is_decided;
  /// Returns the number of decided sides.
  int decided() const { return is_decided[0] + is_decided[1] + is_decided[2]; }
};

/// Returns the sides that the filter decides (see `Adaptive`), by one normal and one bound for the three points.
///
/// It is inlined: its result would be packed into registers through the stack, which stalls on store forwarding.
[[gnu::always_inline]] inline Some_sides filtered_sides(const Corners<Adaptive>& triangle,
                                                        const Corners<Adaptive>& points)
{
  const auto &a = triangle[0]->image, &b = triangle[1]->image, &c = triangle[2]->image;
  const Vertex p = difference(b, a), q = difference(c, a), normal = cross(p, q);
  double mx = maximum_of_defined(std::abs(p[0]), std::abs(q[0])),
         my = maximum_of_defined(std::abs(p[1]), std::abs(q[1])),
         mz = maximum_of_defined(std::abs(p[2]), std::abs(q[2]));
  std::array<double, 3> determinant;
  for (int k = 0; k < 3; ++k) {
    const Vertex r = difference(points[k]->image, a);
    determinant[k] = dot(normal, r);
    mx = maximum_of_defined(mx, std::abs(r[0]));
    my = maximum_of_defined(my, std::abs(r[1]));
    mz = maximum_of_defined(mz, std::abs(r[2]));
  }
  const double error = triangle[0]->error + maximum(triangle[1]->error, triangle[2]->error, points[0]->error,
                                                    points[1]->error, points[2]->error);
  const double bound = adaptive_bound::volume_bound(mx, my, mz, error);
  Some_sides sides;
  for (int k = 0; k < 3; ++k) {
    sides.is_decided[k] = determinant[k] > bound || determinant[k] < -bound;
    sides.side[k] = determinant[k] > 0 ? POSITIVE : NEGATIVE;
  }
  return sides;
}

namespace detail {

/// Decides the undecided signs by the stages after the filter, or all three signs where two or more are undecided. The
/// signs that it decides are counted (`Stage_counts`).
inline void decide_others(Some_sides& sides, const Corners<Adaptive>& triangle, const Corners<Adaptive>& points)
{
  const int decided = sides.decided();
  if (decided < 2) sides.side = Adaptive::unfiltered_sides(*triangle[0], *triangle[1], *triangle[2], points);
  for (int k = 0; decided == 2 && k < 3; ++k)
    if (!sides.is_decided[k])
      sides.side[k] = Adaptive::unfiltered_volume_sign(*triangle[0], *triangle[1], *triangle[2], *points[k]);
}

}  // namespace detail

template <>
inline std::array<Sign, 3> sides<Adaptive>(const Corners<Adaptive>& triangle, const Corners<Adaptive>& points)
{
  Some_sides sides = filtered_sides(triangle, points);
  if (sides.decided() < 3) detail::decide_others(sides, triangle, points);
  return sides.side;
}

/// True when three points are on one side of a plane, none in it.
inline bool all_strictly_beside(const std::array<Sign, 3>& side)
{
  return side[0] == side[1] && side[1] == side[2] && side[0] != ZERO;
}

namespace detail {

/// Rotates the corners so that the first is alone on one closed side of the other's plane. The two others are then on
/// the other closed side. Returns the first corner's side or, if it is in the plane, the opposite of the others'.
/// Returns ZERO, and changes nothing, where all three are in the plane.
template <class K>
Sign turn_alone_first(Corners<K>& triangle, const std::array<Sign, 3>& side)
{
  for (int k = 0; k < 3; ++k) {
    const Sign first = side[k], second = side[(k + 1) % 3], third = side[(k + 2) % 3];
    if (first != ZERO ? second != first && third != first : second == third && second != ZERO) {
      triangle = {triangle[k], triangle[(k + 1) % 3], triangle[(k + 2) % 3]};
      return first != ZERO ? first : -second;
    }
  }
  return ZERO;
}

/// True when an edge of p has all corners of q strictly on its outer side, in the projection along `axis`. Requires
/// that p's normal has the sign `turn` there, not ZERO.
template <class K>
bool is_parted_by_edge(const Corners<K>& p, Sign turn, const Corners<K>& q, int axis)
{
  for (int k = 0; k < 3; ++k) {
    const auto is_beyond = [&](const Point<K>* x) { return normal_sign<K>(*p[k], *p[(k + 1) % 3], *x, axis) == -turn; };
    if (is_beyond(q[0]) && is_beyond(q[1]) && is_beyond(q[2])) return true;
  }
  return false;
}

/// True when two triangles of one plane share a point. Returns nothing where the projection along one axis does not
/// keep the area of both, as where one is degenerate. Convex polygons are apart exactly where an edge of one parts
/// them.
template <class K>
std::optional<bool> coplanar_triangles_meet(const Corners<K>& p, const Corners<K>& q)
{
  const int axis = projection_axis<K>(*p[0], *p[1], *p[2]);
  if (axis < 0) return std::nullopt;
  const Sign turn_p = normal_sign<K>(*p[0], *p[1], *p[2], axis), turn_q = normal_sign<K>(*q[0], *q[1], *q[2], axis);
  if (turn_q == ZERO) return std::nullopt;
  return !is_parted_by_edge<K>(p, turn_p, q, axis) && !is_parted_by_edge<K>(q, turn_q, p, axis);
}

}  // namespace detail

/// True when two closed triangles share a point: also when they only touch, in one point. Exact when K's signs of these
/// points are. Either may be degenerate.
///
/// If each crosses the other's plane, both meet the planes' common line in intervals. Two signs of tetrahedra tell
/// whether these overlap (after Guigue and Devillers, Journal of Graphics Tools 8, 2003). p0 and q0 are each alone on
/// the positive side of the other plane. Then edges p0 p1 and q0 q1 bound the intervals at one end each, p0 p2 and q0
/// q2 at the other. Triangles in one plane are parted by an edge, if at all; those without a plane are decided edge by
/// edge.
///
/// `sides_of(triangle, points)` returns the same as `sides<K>(triangle, points)`.
template <class K, class Sides_of>
bool triangles_meet(const Corners<K>& whole_p, const Corners<K>& whole_q, const Sides_of& sides_of)
{
  const auto side_q = sides_of(whole_p, whole_q);
  if (all_strictly_beside(side_q)) return false;
  const auto side_p = sides_of(whole_q, whole_p);
  if (all_strictly_beside(side_p)) return false;
  Corners<K> p = whole_p, q = whole_q;
  const Sign alone_p = detail::turn_alone_first<K>(p, side_p), alone_q = detail::turn_alone_first<K>(q, side_q);
  if (alone_p == ZERO || alone_q == ZERO) {
    if (alone_p == ZERO && alone_q == ZERO)
      if (const std::optional<bool> meet = detail::coplanar_triangles_meet<K>(p, q)) return *meet;
    const auto edges_meet = [](const Corners<K>& e, const std::array<Sign, 3>& side, const Corners<K>& t) {
      for (int k = 0; k < 3; ++k) {
        const int l = k == 2 ? 0 : k + 1;
        if (segment_triangle<K>(*e[k], *e[l], *t[0], *t[1], *t[2], side[k], side[l]) != Contact::none) return true;
      }
      return false;
    };
    return edges_meet(whole_p, side_p, whole_q) || edges_meet(whole_q, side_q, whole_p);
  }
  if (alone_p == NEGATIVE) std::swap(q[1], q[2]);
  if (alone_q == NEGATIVE) std::swap(p[1], p[2]);
  return volume_sign<K>(*p[0], *p[1], *q[0], *q[1]) != POSITIVE &&
         volume_sign<K>(*p[0], *p[2], *q[0], *q[2]) != NEGATIVE;
}

/// Decides the sides by `sides<K>`.
template <class K>
bool triangles_meet(const Corners<K>& p, const Corners<K>& q)
{
  return triangles_meet<K>(p, q, sides<K>);
}

}  // namespace tetracone::kernel

#endif
