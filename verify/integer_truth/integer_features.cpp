#include "verify/integer_truth/integer_features.h"

#include "verify/integer_truth/integer_contact.h"
#include "verify/integer_truth/integer_pair.h"

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

namespace tetracone::verify::integer_truth {
namespace {

using kernel::Contact;
using kernel::Feature_pair;

/// The kind of the one common point of an edge, of which it is an end or not, and an element of a face.
Contact kind_of(bool end, bool corner)
{
  return end && corner ? Contact::vertex_vertex : end || corner ? Contact::vertex_edge : Contact::edge_edge;
}

/// The point x / w, w > 0, is a corner of the face.
bool is_corner(const Integer_body& body, Index f, const Integer_vector& x, const Integer& w)
{
  bool found = false;
  body.for_edges(f, [&](Index v, Index) {
    const Integer_vector& p = body.point(v);
    found = found || (x[0] == w * p[0] && x[1] == w * p[1] && x[2] == w * p[2]);
  });
  return found;
}

/// An edge and a face that can share but one point, x / w of the face's plane.
Contact in_one_point(const Integer_body& body, Index f, const Integer_vector& n, const Integer_vector& x,
                     const Integer& w, bool end)
{
  if (is_corner(body, f, x, w)) return kind_of(end, true);
  const Turns turns = body.turns(f, projection_axis(n), x, w);
  if (turns.on_loop) return kind_of(end, false);
  return turns.winding == 0 ? Contact::none : end ? Contact::vertex_face : Contact::edge_face;
}

/// An edge ab in the plane of the face, or of any place where the face is on a line. Points on the edge are given by
/// their shares of it from a. An edge with two different points on the loops overlaps. One with a single such point, or
/// none, does where an end off the loops is inside.
Contact in_one_plane(const Integer_vector& a, const Integer_vector& b, const Integer_body& body, Index f,
                     const std::optional<Integer_vector>& n)
{
  std::set<mpq_class> on_loops;
  bool corner = false;
  body.for_edges(f, [&](Index from, Index to) {
    const auto share = shared(a, b, body.point(from), body.point(to));
    if (!share) return;
    on_loops.insert({share->first, share->last});
    for (const Index v : {from, to}) corner = corner || shared(a, b, body.point(v), body.point(v));
  });
  if (on_loops.size() > 1) return Contact::coplanar_overlap;
  const bool starts = on_loops.contains(0), ends = on_loops.contains(1);
  if (n && ((!starts && is_on_face(body, f, *n, a, 1)) || (!ends && is_on_face(body, f, *n, b, 1))))
    return Contact::coplanar_overlap;
  return on_loops.empty() ? Contact::none : kind_of(starts || ends, corner);
}

Contact contact(const Integer_vector& a, const Integer_vector& b, const Integer_body& body, Index f,
                const std::optional<Integer_vector>& n)
{
  if (!n) return in_one_plane(a, b, body, f, n);
  const Integer height_a = dot(*n, difference(a, body.corner(f))), height_b = dot(*n, difference(b, body.corner(f)));
  if (sgn(height_a) * sgn(height_b) > 0) return Contact::none;
  if (sgn(height_a) == 0 && sgn(height_b) == 0)
    return a == b ? in_one_point(body, f, *n, a, 1, true) : in_one_plane(a, b, body, f, n);
  const Integer of_a = abs(height_b), of_b = abs(height_a);
  Integer_vector x;
  for (int i = 0; i < 3; ++i) x[i] = of_a * a[i] + of_b * b[i];
  return in_one_point(body, f, *n, x, of_a + of_b, sgn(of_a) == 0 || sgn(of_b) == 0);
}

void add_features(const Integer_body& with_edges, const std::vector<Rank_box>& edge_boxes,
                  const Integer_body& with_faces, const std::vector<Rank_box>& face_boxes, int body,
                  std::vector<Feature_pair>& features)
{
  Index last = with_faces.face_count();
  std::optional<Integer_vector> normal;
  for (const auto& [f, e] : meeting_boxes(face_boxes, edge_boxes)) {
    if (f != last) normal = with_faces.normal(f);
    last = f;
    const auto& [from, to] = with_edges.edges()[e];
    const Contact kind = contact(with_edges.point(from), with_edges.point(to), with_faces, f, normal);
    if (kind != Contact::none) features.push_back({body, from, to, f, kind});
  }
}

}  // namespace

std::vector<Feature_pair> features(const Object_case& c)
{
  const auto [denominator, a, b] = integer_pair(c);
  const auto [of_a, of_b] = element_boxes(a, b);
  std::vector<Feature_pair> features;
  add_features(a, of_a.edges, b, of_b.faces, 0, features);
  add_features(b, of_b.edges, a, of_a.faces, 1, features);
  std::sort(features.begin(), features.end());
  return features;
}

}  // namespace tetracone::verify::integer_truth
