#ifndef TETRACONE_KERNEL_PREDICATE_SEGMENT_H
#define TETRACONE_KERNEL_PREDICATE_SEGMENT_H

#include "tetracone/kernel/predicate/contact.h"
#include "tetracone/kernel/predicate/signs.h"

namespace tetracone::kernel {

/// The place of a point of a line relative to a closed segment of the same line.
enum class On_segment { outside, inside, first_end, second_end };

/// Returns the place of p relative to the closed segment ab. Requires p collinear with a and b. A segment of two equal
/// ends is their point.
template <class K>
On_segment locate_on_segment(const Point<K>& p, const Point<K>& a, const Point<K>& b)
{
  for (int axis = 0; axis < 3; ++axis) {
    if (difference_sign<K>(a, b, axis) == ZERO) continue;
    const Sign from_a = difference_sign<K>(p, a, axis), from_b = difference_sign<K>(p, b, axis);
    if (from_a == ZERO) return On_segment::first_end;
    if (from_b == ZERO) return On_segment::second_end;
    return from_a == from_b ? On_segment::outside : On_segment::inside;
  }
  return coincide<K>(p, a) ? On_segment::first_end : On_segment::outside;
}

/// Returns how the closed segments pq and ab meet. Either may be a point. It uses signs alone:
/// - coplanarity by `volume_sign`;
/// - crossing by `normal_sign` along an axis that keeps the common plane a plane;
/// - overlap of collinear segments by `difference_sign`.
/// One common point gives vertex_vertex, vertex_edge (in either order) or edge_edge. More of them give
/// coplanar_overlap.
template <class K>
Contact segment_segment(const Point<K>& p, const Point<K>& q, const Point<K>& a, const Point<K>& b)
{
  if (volume_sign<K>(p, q, a, b) != ZERO) return Contact::none;

  // All four points are in one plane. A projection keeps it a plane if it keeps a triangle of three of them.
  int axis = projection_axis<K>(p, q, a);
  if (axis < 0) axis = projection_axis<K>(p, q, b);
  if (axis < 0) axis = projection_axis<K>(a, b, p);
  if (axis < 0) axis = projection_axis<K>(a, b, q);

  if (axis < 0) {  // all on one line
    const On_segment p_at = locate_on_segment<K>(p, a, b), q_at = locate_on_segment<K>(q, a, b);
    const On_segment a_at = locate_on_segment<K>(a, p, q), b_at = locate_on_segment<K>(b, p, q);
    const auto meets = [](On_segment at) { return at != On_segment::outside; };
    if (!meets(p_at) && !meets(q_at) && !meets(a_at) && !meets(b_at)) return Contact::none;
    const bool pq_is_point = coincide<K>(p, q), ab_is_point = coincide<K>(a, b);
    const auto point_on = [](On_segment at) {
      return at == On_segment::inside ? Contact::vertex_edge : Contact::vertex_vertex;
    };
    if (pq_is_point) return point_on(p_at);
    if (ab_is_point) return point_on(a_at);
    // Two proper segments of one line share one point exactly when an end of each is that point and nothing is inside.
    const auto inside = [](On_segment at) { return at == On_segment::inside; };
    if (inside(p_at) || inside(q_at) || inside(a_at) || inside(b_at)) return Contact::coplanar_overlap;
    return meets(p_at) && meets(q_at) ? Contact::coplanar_overlap : Contact::vertex_vertex;
  }

  const Sign pa = normal_sign<K>(a, b, p, axis), qa = normal_sign<K>(a, b, q, axis);
  const Sign ap = normal_sign<K>(p, q, a, axis), bp = normal_sign<K>(p, q, b, axis);
  if (pa * qa == POSITIVE || ap * bp == POSITIVE) return Contact::none;
  const bool end_of_pq = pa == ZERO || qa == ZERO, end_of_ab = ap == ZERO || bp == ZERO;
  if (end_of_pq && end_of_ab) return Contact::vertex_vertex;
  return end_of_pq || end_of_ab ? Contact::vertex_edge : Contact::edge_edge;
}

}  // namespace tetracone::kernel

#endif
