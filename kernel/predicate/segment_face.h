#ifndef TETRACONE_KERNEL_PREDICATE_SEGMENT_FACE_H
#define TETRACONE_KERNEL_PREDICATE_SEGMENT_FACE_H

#include "tetracone/kernel/predicate/contact.h"
#include "tetracone/kernel/predicate/segment.h"
#include "tetracone/kernel/predicate/signs.h"

#include <concepts>
#include <cstddef>

/// Closed segment against closed face, by signs alone.
///
/// There are four known formulations of segment against triangle. This is the paper family's own: five signs of
/// tetrahedra (Segura & Feito, WSCG 2001). They are the signs of the barycentric coordinates of one end with regard to
/// the tetrahedron of the other end and the triangle. (Jimenez, Segura & Feito, CGTA 2010, cited as the detailed test
/// in JS08 section 3.) Touching counts: `Contact` names the features that meet. It was chosen for three reasons.
/// - The sign [p, q, A, B] of an edge serves both triangles at that edge, so no crack opens between them in any kernel.
/// - It extends to any planar face through its covering. A face is a signed sum of triangles W A B (JS08 Definition 1).
///   The signs [p, q, W, A], [p, q, W, B], [p, q, A, B] tell in which of them the crossing lies.
/// - It needs no division and no point of intersection.
///
/// Pluecker coordinates give the same five determinants; CGAL's formulation decides the same signs in another order.
/// There are two departures from the published tests. Coplanar and degenerate positions are decided, not rejected. The
/// comparison of the three volumes with the fourth, published in ports with a wrong sign, is the exact sign of q
/// against the plane.
namespace tetracone::kernel {

/// A planar face as its covering sees it. It has the directed edges (from, to) of all its loops, and the origin W of
/// its covering, which is one of its corners. A triangle of its corners spans its plane.
template <class Face, class K>
concept Covered_face = requires(const Face& face, std::size_t k)
{
  {
    face.edge_count()
    } -> std::convertible_to<std::size_t>;
  {
    face.from(k)
    } -> std::convertible_to<const Point<K>&>;
  {
    face.to(k)
    } -> std::convertible_to<const Point<K>&>;
  {
    face.origin()
    } -> std::convertible_to<const Point<K>&>;
  {
    face.is_degenerate()
    } -> std::convertible_to<bool>;  // all corners on one line
  {
    face.plane_basis(int())
    } -> std::convertible_to<const Point<K>&>;  // 0, 1, 2; requires a face that is not degenerate
};

/// A triangle is its own covering.
template <class K>
struct Triangle {
  const Point<K>&a, &b, &c;

  std::size_t edge_count() const { return 3; }
  const Point<K>& from(std::size_t k) const { return corner(k); }
  const Point<K>& to(std::size_t k) const { return corner(k == 2 ? 0 : k + 1); }
  const Point<K>& origin() const { return a; }
  bool is_degenerate() const { return projection_axis<K>(a, b, c) < 0; }
  const Point<K>& plane_basis(int k) const { return corner(k); }

 private:
  const Point<K>& corner(std::size_t k) const { return k == 0 ? a : k == 1 ? b : c; }
};

namespace detail {

/// Returns the winding number of the face's loops about a point y of its plane that lies on no loop. It is the signed
/// count of the covering triangles W A B that hold y. `turn(A, B)` is the sign of the turn from A to B about y, and
/// `side(A)` of the turn from W to A. Both are seen from one side of the plane. A point on an inner edge W A of the
/// covering is moved off it. A side of ZERO counts as POSITIVE for every triangle at that edge. That is the effect of
/// turning the ray from W through y by an infinitesimal.
template <class K, Covered_face<K> Face, class Side, class Turn>
int winding_in_plane(const Face& face, const Side& side, const Turn& turn)
{
  int winding = 0;
  for (std::size_t k = 0; k < face.edge_count(); ++k) {
    const bool from_left = side(face.from(k)) != NEGATIVE, to_left = side(face.to(k)) != NEGATIVE;
    if (from_left == to_left) continue;
    const Sign s = turn(face.from(k), face.to(k));
    if (from_left && s == POSITIVE) ++winding;
    if (!from_left && s == NEGATIVE) --winding;
  }
  return winding;
}

/// True when p, a point of the face's plane, is in the face's interior. The projection along `axis` keeps the plane a
/// plane.
template <class K, Covered_face<K> Face>
bool is_in_interior(const Point<K>& p, const Face& face, int axis)
{
  const auto side = [&](const Point<K>& a) { return normal_sign<K>(p, face.origin(), a, axis); };
  const auto turn = [&](const Point<K>& a, const Point<K>& b) { return normal_sign<K>(p, a, b, axis); };
  return winding_in_plane<K>(face, side, turn) != 0;
}

/// Returns the contact where the segment pq lies on the face's plane, or the face on a line. It is the union of the
/// sets that pq shares with the loops and with the interior. One shared point is told from several by its kind: an end
/// of pq, a corner, or a crossing of an edge.
template <class K, Covered_face<K> Face>
Contact coplanar_contact(const Point<K>& p, const Point<K>& q, const Face& face)
{
  const bool segment_is_point = coincide<K>(p, q);
  Contact kind = Contact::none;
  const Point<K>* corner = nullptr;  // the shared point, when it is a corner
  const Point<K>* end = nullptr;     // the shared point, when it is an end of pq
  std::size_t crossed = 0;           // the edge, when it is a crossing inside both
  bool p_on_loop = false, q_on_loop = false;

  const auto on = [](const Point<K>& x, const Point<K>& s, const Point<K>& t) {
    return projection_axis<K>(x, s, t) < 0 && locate_on_segment<K>(x, s, t) != On_segment::outside;
  };
  const auto on_line = [&face](const Point<K>& x, std::size_t k) {
    return projection_axis<K>(x, face.from(k), face.to(k)) < 0;
  };

  for (std::size_t k = 0; k < face.edge_count(); ++k) {
    const Point<K>&a = face.from(k), &b = face.to(k);
    const Contact at = segment_segment<K>(p, q, a, b);
    if (at == Contact::none) continue;
    if (at == Contact::coplanar_overlap) return at;
    const Point<K>* this_end = nullptr;
    const Point<K>* this_corner = nullptr;
    if (at != Contact::edge_edge) {
      if (on(p, a, b)) {
        this_end = &p;
        p_on_loop = true;
      } else if (on(q, a, b)) {
        this_end = &q;
        q_on_loop = true;
      }
      if (on(a, p, q))
        this_corner = &a;
      else if (on(b, p, q))
        this_corner = &b;
    }
    if (kind != Contact::none) {
      const bool same =
          (end && this_end == end) || (corner && this_corner && coincide<K>(*corner, *this_corner)) ||
          (corner && !this_corner && on(*corner, a, b)) ||
          (!corner && this_corner && on(*this_corner, face.from(crossed), face.to(crossed))) ||
          (at == Contact::edge_edge && kind == Contact::edge_edge && on_line(a, crossed) && on_line(b, crossed));
      if (!same) return Contact::coplanar_overlap;
    }
    // A shared corner is a vertex of the face even where this edge meets it in its inside (a loop that touches itself).
    if (kind == Contact::none || at < kind) kind = at;
    if (this_end) end = this_end;
    if (this_corner) corner = this_corner;
    crossed = k;
  }
  if (face.is_degenerate()) return kind;

  const int axis = projection_axis<K>(face.plane_basis(0), face.plane_basis(1), face.plane_basis(2));
  const bool p_inside = !p_on_loop && is_in_interior<K>(p, face, axis);
  if (segment_is_point) return p_inside ? Contact::vertex_face : kind;
  if (p_inside || (!q_on_loop && is_in_interior<K>(q, face, axis))) return Contact::coplanar_overlap;
  // A remaining segment touches the face in `kind` only: had pq gone in through that point, it would end inside or come
  // out elsewhere.
  return kind;
}

}  // namespace detail

/// Returns how the closed segment pq and a closed planar face meet. The face's points are those of its plane with
/// non-zero winding number about its loops, and the loops themselves. The segment may be a point, the face a segment or
/// a point. The answer is exact when K's signs of these points are exact. In kernels that round, a planar face need not
/// look planar.
///
/// `side_p` and `side_q` are the sides of p and q against the plane of the face's spanning triangle; for a degenerate
/// face they are arbitrary. A caller with many segments decides them once a vertex.
template <class K, Covered_face<K> Face>
Contact segment_face(const Point<K>& p, const Point<K>& q, const Face& face, Sign side_p, Sign side_q)
{
  if (face.is_degenerate()) return detail::coplanar_contact<K>(p, q, face);
  if (side_p == side_q) return side_p == ZERO ? detail::coplanar_contact<K>(p, q, face) : Contact::none;

  // pq meets the plane in one point y. Seen along pq, [p, q, A, B] is the turn A, B about y.
  const auto turn = [&](const Point<K>& from, const Point<K>& to) { return volume_sign<K>(p, q, from, to); };
  const bool end_of_segment = side_p == ZERO || side_q == ZERO;
  bool on_edge = false;
  for (std::size_t k = 0; k < face.edge_count(); ++k) {
    const Point<K>&from = face.from(k), &to = face.to(k);
    if (turn(from, to) != ZERO) continue;
    // y is on the line of this edge, or the edge is a point. The normals of (p, q, from) and (p, q, to) are parallel.
    bool from_at_y = true, to_at_y = true, opposite = false;
    for (int axis = 0; axis < 3; ++axis) {
      const Sign at_from = normal_sign<K>(p, q, from, axis), at_to = normal_sign<K>(p, q, to, axis);
      from_at_y = from_at_y && at_from == ZERO;
      to_at_y = to_at_y && at_to == ZERO;
      opposite = opposite || at_from * at_to == NEGATIVE;
    }
    if (from_at_y || to_at_y) return end_of_segment ? Contact::vertex_vertex : Contact::vertex_edge;
    on_edge = on_edge || opposite;
  }
  if (on_edge) return end_of_segment ? Contact::vertex_edge : Contact::edge_edge;

  const auto side = [&](const Point<K>& corner) { return turn(face.origin(), corner); };
  if (detail::winding_in_plane<K>(face, side, turn) == 0) return Contact::none;
  return end_of_segment ? Contact::vertex_face : Contact::edge_face;
}

/// Decides the sides itself.
template <class K, Covered_face<K> Face>
Contact segment_face(const Point<K>& p, const Point<K>& q, const Face& face)
{
  if (face.is_degenerate()) return segment_face<K>(p, q, face, ZERO, ZERO);
  const auto side = [&](const Point<K>& x) {
    return volume_sign<K>(face.plane_basis(0), face.plane_basis(1), face.plane_basis(2), x);
  };
  return segment_face<K>(p, q, face, side(p), side(q));
}

/// Returns how the closed segment pq and the closed triangle abc meet. It is `segment_face` of the face that is its own
/// covering, in at most five signs where nothing degenerate is met. They are the signs of the barycentric coordinates
/// of q in the tetrahedron p a b c. The triangle is between p and q when q's coordinate at p is not positive while
/// those at a, b, c are not negative. `side_p` and `side_q` are the sides of p and q against the plane a b c.
template <class K>
Contact segment_triangle(const Point<K>& p, const Point<K>& q, const Point<K>& a, const Point<K>& b, const Point<K>& c,
                         Sign side_p, Sign side_q)
{
  if (side_p == side_q) {
    return side_p == ZERO ? detail::coplanar_contact<K>(p, q, Triangle<K>{a, b, c}) : Contact::none;
  }
  const Sign ab = volume_sign<K>(p, q, a, b), bc = volume_sign<K>(p, q, b, c);
  if (ab * bc == NEGATIVE) return Contact::none;
  const Sign ca = volume_sign<K>(p, q, c, a);
  if (bc * ca == NEGATIVE || ab * ca == NEGATIVE) return Contact::none;
  const int zeros = (ab == ZERO) + (bc == ZERO) + (ca == ZERO);
  if (side_p == ZERO || side_q == ZERO)
    return zeros == 0 ? Contact::vertex_face : zeros == 1 ? Contact::vertex_edge : Contact::vertex_vertex;
  return zeros == 0 ? Contact::edge_face : zeros == 1 ? Contact::edge_edge : Contact::vertex_edge;
}

/// Decides the sides itself.
template <class K>
Contact segment_triangle(const Point<K>& p, const Point<K>& q, const Point<K>& a, const Point<K>& b, const Point<K>& c)
{
  return segment_triangle<K>(p, q, a, b, c, volume_sign<K>(a, b, c, p), volume_sign<K>(a, b, c, q));
}

}  // namespace tetracone::kernel

#endif
