#ifndef TETRACONE_VERIFY_SUBJECTS_SEGMENT_TRIANGLE_FORMULATIONS_H
#define TETRACONE_VERIFY_SUBJECTS_SEGMENT_TRIANGLE_FORMULATIONS_H

#include "tetracone/kernel/number/products.h"

#include <CGAL/Intersections_3/Segment_3_Segment_3.h>
#include <CGAL/Intersections_3/Segment_3_Triangle_3.h>

#include <array>

/// Segment against triangle as others formulate it. Each is written anew from its published mathematics, over any
/// number type. All answer whether the closed segment pq and the closed triangle abc share a point, except for the
/// limits stated at each one. Numbers with expression templates may be used: no intermediate is `auto`.
namespace tetracone::verify::formulations {

template <class Number>
using Vector = std::array<Number, 3>;

using kernel::cross;
using kernel::difference;
using kernel::dot;

/// Moeller & Trumbore, Fast, minimum storage ray-triangle intersection, JGT 2(1), 1997, for both sides, with the ray
/// cut to a segment. It solves p + t (q-p) = a + u (b-a) + v (c-a) for (t, u, v) by Cramer's rule, after one division.
/// The determinant counts as zero, and the segment as parallel, within the absolute `eps`. Limits: a parallel segment
/// is never hit, and so no coplanar segment and no degenerate triangle is. Two triangles with a common edge compute its
/// u and v differently.
template <class Number>
bool moeller_trumbore(const Vector<Number>& p, const Vector<Number>& q, const Vector<Number>& a,
                      const Vector<Number>& b, const Vector<Number>& c, const Number& eps)
{
  const Vector<Number> along = difference(q, p), ab = difference(b, a), ac = difference(c, a),
                       from_a = difference(p, a);
  const Vector<Number> normal_u = cross(along, ac);
  const Number determinant = dot(ab, normal_u);
  if (-eps <= determinant && determinant <= eps) return false;
  const Number inverse = 1 / determinant;
  const Number u = dot(from_a, normal_u) * inverse;
  if (u < 0 || u > 1) return false;
  const Vector<Number> normal_v = cross(from_a, ab);
  const Number v = dot(along, normal_v) * inverse;
  if (v < 0 || u + v > 1) return false;
  const Number t = dot(ac, normal_v) * inverse;
  return t >= 0 && t <= 1;
}

/// Segura & Feito, Algorithms to test ray-triangle intersection: comparative study, WSCG 2001. It takes the signs of
/// five tetrahedra. [a b c p] and [a b c q] tell the sides of the plane. [p q a b], [p q b c] and [p q c a] tell
/// whether the line meets the triangle. Limits: it answers no when both ends are on the plane.
template <class Number>
bool segura_feito(const Vector<Number>& p, const Vector<Number>& q, const Vector<Number>& a, const Vector<Number>& b,
                  const Vector<Number>& c)
{
  const auto volume = [](const Vector<Number>& w, const Vector<Number>& x, const Vector<Number>& y,
                         const Vector<Number>& z) {
    const Number det = dot(cross(difference(x, w), difference(y, w)), difference(z, w));
    return (det > 0) - (det < 0);
  };
  const int side_p = volume(a, b, c, p), side_q = volume(a, b, c, q);
  if (side_p == side_q) return false;
  const int ab = volume(p, q, a, b), bc = volume(p, q, b, c), ca = volume(p, q, c, a);
  return ab * bc >= 0 && bc * ca >= 0 && ab * ca >= 0;
}

/// How a transcription of `jimenez_segura_feito` treats a first end on the plane.
enum class First_end_on_plane {
  right,
  sign_error  ///< -s in place of s against t + u, as in several public ports: no segment that starts on the triangle's
              ///< plane ever hits
};

/// Jimenez, Segura & Feito, A robust segment/triangle intersection algorithm for interference tests, CGTA 43 (2010)
/// 474-492. With c as origin, the quotients of the signed volumes w, s, t, u are q's barycentric coordinates in the
/// tetrahedron p a b c. Each rejection is a comparison without a division. A volume counts as zero within the absolute
/// `eps`; the last comparison, with the sum of three volumes, has no tolerance. Limits: it answers no when both ends
/// are on the plane.
template <First_end_on_plane Transcription = First_end_on_plane::right, class Number>
bool jimenez_segura_feito(const Vector<Number>& p, const Vector<Number>& q, const Vector<Number>& a,
                          const Vector<Number>& b, const Vector<Number>& c, const Number& eps)
{
  const Vector<Number> first = difference(p, c), ca = difference(a, c), cb = difference(b, c),
                       second = difference(q, c);
  const Vector<Number> normal = cross(ca, cb);
  Number w = dot(first, normal), s = dot(second, normal);
  if (w > eps || w < -eps) {
    // Seen from the side of p: with w < 0 all four volumes have the other sign.
    const Vector<Number> turn = cross(first, second);
    Number t = dot(turn, cb), u = -dot(turn, ca);
    if (w < 0) {
      w = -w;
      s = -s;
      t = -t;
      u = -u;
    }
    return s <= eps && t >= -eps && u >= -eps && w >= s + t + u;
  }
  if (s > eps || s < -eps) {
    const Vector<Number> turn = cross(second, first);
    Number t = dot(turn, cb), u = -dot(turn, ca);
    if (s < 0) {
      s = -s;
      t = -t;
      u = -u;
    }
    if (t < -eps || u < -eps) return false;
    if constexpr (Transcription == First_end_on_plane::sign_error) s = -s;
    return s >= t + u;
  }
  return false;
}

/// CGAL's do_intersect in kernel K, which requires a proper segment and a proper triangle. If K sees one of them as
/// degenerate, it is passed as the segment or point that it is.
template <class K>
bool cgal_do_intersect(const typename K::Point_3& p, const typename K::Point_3& q, const typename K::Point_3& a,
                       const typename K::Point_3& b, const typename K::Point_3& c)
{
  using Segment = typename K::Segment_3;
  using Triangle = typename K::Triangle_3;
  const auto meet = [](const Segment& s, const Segment& t) {
    if (t.is_degenerate()) return s.has_on(t.source());
    return s.is_degenerate() ? t.has_on(s.source()) : CGAL::do_intersect(s, t);
  };
  const Segment segment(p, q);
  const Triangle triangle(a, b, c);
  if (triangle.is_degenerate())
    return meet(segment, Segment(a, b)) || meet(segment, Segment(b, c)) || meet(segment, Segment(c, a));
  return segment.is_degenerate() ? triangle.has_on(p) : CGAL::do_intersect(segment, triangle);
}

}  // namespace tetracone::verify::formulations

#endif
