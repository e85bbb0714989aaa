#ifndef TETRACONE_VERIFY_INTEGER_TRUTH_INTEGER_CONTACT_H
#define TETRACONE_VERIFY_INTEGER_TRUTH_INTEGER_CONTACT_H

#include "verify/integer_truth/integer_boxes.h"

#include <gmpxx.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

/// The intersections of segments, faces and solids of integers, by which the second truth and the judge of rounded
/// images decide.
namespace tetracone::verify::integer_truth {

/// The intersection of two closed segments, by parameters from 0 to 1 on the first one.
struct Shared {
  mpq_class first, last;  ///< equal for one point
};

/// Returns the intersection of the closed segments ab and cd; nothing if they share no point. Either may be a point.
inline std::optional<Shared> shared(const Integer_vector& a, const Integer_vector& b, const Integer_vector& c,
                                    const Integer_vector& d)
{
  const auto fraction = [](const Integer& x, const Integer& of) {
    mpq_class q(x, of);
    q.canonicalize();
    return q;
  };
  const Integer_vector u = difference(b, a), v = difference(d, c), w = difference(c, a), n = cross(u, v);
  const Integer whole = dot(n, n);
  if (sgn(whole) > 0) {
    // a + s u = c + t v, s and t over `whole`.
    if (sgn(dot(w, n)) != 0) return std::nullopt;
    const Integer s = dot(cross(w, v), n), t = dot(cross(w, u), n);
    if (sgn(s) < 0 || s > whole || sgn(t) < 0 || t > whole) return std::nullopt;
    return Shared{fraction(s, whole), fraction(s, whole)};
  }
  const Integer_vector& along = is_zero(u) ? v : u;
  if (!is_zero(cross(w, along))) return std::nullopt;
  if (is_zero(along)) return is_zero(w) ? std::optional(Shared{0, 0}) : std::nullopt;
  // The segments are on one line: they are intervals of it, measured from a.
  const Integer end_u = dot(u, along), start_v = dot(w, along), end_v = start_v + dot(v, along);
  const auto [low_v, high_v] = std::minmax(start_v, end_v);
  const Integer low = std::max(low_v, Integer(0)), high = std::min(high_v, end_u);
  if (low > high) return std::nullopt;
  if (sgn(end_u) == 0) return Shared{0, 0};
  return Shared{fraction(low, end_u), fraction(high, end_u)};
}

/// Returns an axis along which the plane with this normal projects to a plane: that of the largest component.
inline int projection_axis(const Integer_vector& n)
{
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (abs(n[i]) > abs(n[axis])) axis = i;
  return axis;
}

/// True when the point x / w of the face's plane, w > 0, is on the face.
inline bool is_on_face(const Integer_body& body, Index f, const Integer_vector& n, const Integer_vector& x,
                       const Integer& w)
{
  const Turns turns = body.turns(f, projection_axis(n), x, w);
  return turns.on_loop || turns.winding != 0;
}

/// True when the closed segment ab and a loop of the face share a point.
inline bool meets_loops(const Integer_vector& a, const Integer_vector& b, const Integer_body& body, Index f)
{
  bool meets = false;
  body.for_edges(f, [&](Index from, Index to) { meets = meets || shared(a, b, body.point(from), body.point(to)); });
  return meets;
}

/// Returns the winding number about a point off the surface. It sums over the faces above the point the winding numbers
/// of their loops about it, seen from above. The point is moved by (e, e^2, 0), so that the ray along +z meets no loop.
/// Such a small move changes no winding number off the surface, nor the side of a plane that does not contain the
/// point. A face whose plane contains the point does not hold it. So its loops wind neither about it nor about any
/// point near it. It does not matter on which side they are counted. Vertical faces are seen as lines and have winding
/// number 0.
inline int winding(const Integer_body& body, const std::vector<Rank_box>& face_boxes, const Integer_vector& p,
                   const Rank_box& at)
{
  int sum = 0;
  for (Index f = 0; f < body.face_count(); ++f) {
    Rank_box above = at;
    above.high[2] = std::max(at.high[2], face_boxes[f].high[2]);
    if (!face_boxes[f].meets(above)) continue;
    const int turns = body.turns(f, 2, p, 1).winding;
    if (turns == 0) continue;
    // Loops that wind about something seen along z span a plane that is not vertical.
    const std::optional<Integer_vector> n = body.normal(f);
    const int height = sgn(dot(*n, difference(p, body.corner(f)))) * sgn((*n)[2]);
    if (height < 0) sum += turns;
  }
  return sum;
}

/// True when some part of one surface is in the other's solid. Requires surfaces that share no point: then the winding
/// number is constant on each part.
inline bool contains(const Integer_body& outer, const std::vector<Rank_box>& face_boxes, const Integer_body& inner,
                     const std::vector<Rank_box>& vertex_boxes)
{
  for (const Index v : inner.part_vertices())
    if (winding(outer, face_boxes, inner.point(v), vertex_boxes[v]) != 0) return true;
  return false;
}

}  // namespace tetracone::verify::integer_truth

#endif
