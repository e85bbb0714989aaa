#include "verify/truth/integer_truth.h"

#include "verify/truth/integer_boxes.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::verify::integer_truth {
namespace {

/// The closed segments ab and cd, either of which may be a point, share a point.
bool segments_meet(const Integer_vector& a, const Integer_vector& b, const Integer_vector& c, const Integer_vector& d)
{
  const Integer_vector u = difference(b, a), v = difference(d, c), w = difference(c, a), n = cross(u, v);
  const Integer whole = dot(n, n);
  if (sgn(whole) > 0) {
    // a + s u = c + t v, s and t over `whole`.
    if (sgn(dot(w, n)) != 0) return false;
    const Integer s = dot(cross(w, v), n), t = dot(cross(w, u), n);
    return sgn(s) >= 0 && s <= whole && sgn(t) >= 0 && t <= whole;
  }
  const Integer_vector& along = is_zero(u) ? v : u;
  if (!is_zero(cross(w, along))) return false;
  if (is_zero(along)) return is_zero(w);
  // On one line: as intervals of it, counted from a.
  const Integer end_u = dot(u, along), start_v = dot(w, along), end_v = start_v + dot(v, along);
  const auto [low_v, high_v] = std::minmax(start_v, end_v);
  return low_v <= std::max(end_u, Integer(0)) && high_v >= std::min(end_u, Integer(0));
}

/// An axis along which the plane with this normal projects to a plane: that of the largest component.
int projection_axis(const Integer_vector& n)
{
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (abs(n[i]) > abs(n[axis])) axis = i;
  return axis;
}

/// The point x / w of the face's plane, w > 0, is on the face.
bool is_on_face(const Integer_body& body, Index f, const Integer_vector& n, const Integer_vector& x, const Integer& w)
{
  const Turns turns = body.turns(f, projection_axis(n), x, w);
  return turns.on_loop || turns.winding != 0;
}

/// The closed segment ab and the face, whose normal is given where it has one, share a point.
bool meets_face(const Integer_vector& a, const Integer_vector& b, const Integer_body& body, Index f,
                const std::optional<Integer_vector>& n)
{
  if (n) {
    const Integer height_a = dot(*n, difference(a, body.corner(f))), height_b = dot(*n, difference(b, body.corner(f)));
    if (sgn(height_a) * sgn(height_b) > 0) return false;
    if (sgn(height_a) != 0 || sgn(height_b) != 0) {
      // The crossing is a and b weighted by each other's height.
      const Integer of_a = abs(height_b), of_b = abs(height_a);
      Integer_vector x;
      for (int i = 0; i < 3; ++i) x[i] = of_a * a[i] + of_b * b[i];
      return is_on_face(body, f, *n, x, of_a + of_b);
    }
    if (is_on_face(body, f, *n, a, 1)) return true;
  }
  // One plane, and a segment that would have to come in through a loop; or a face that is its loops only.
  bool meets = false;
  body.for_edges(f,
                 [&](Index from, Index to) { meets = meets || segments_meet(a, b, body.point(from), body.point(to)); });
  return meets;
}

/// Some edge of the one meets some face of the other. When this holds neither way, the surfaces share no point: had two
/// faces one in common, then what they share, being closed and bounded, would end on a loop of one of them, at a point
/// of the other.
bool edges_meet_faces(const Integer_body& with_edges, const std::vector<Rank_box>& edge_boxes,
                      const Integer_body& with_faces, const std::vector<Rank_box>& face_boxes)
{
  for (Index f = 0; f < with_faces.face_count(); ++f) {
    std::optional<std::optional<Integer_vector>> normal;  // made once, when an edge comes near
    for (std::size_t e = 0; e < edge_boxes.size(); ++e) {
      if (!face_boxes[f].meets(edge_boxes[e])) continue;
      if (!normal) normal = with_faces.normal(f);
      const auto& [from, to] = with_edges.edges()[e];
      if (meets_face(with_edges.point(from), with_edges.point(to), with_faces, f, *normal)) return true;
    }
  }
  return false;
}

/// The winding number about a point off the surface: the faces above it, each as often as its loops wind about the
/// point, seen from above. The point is moved by (e, e^2, 0), so that the ray along +z meets no loop. So small a move
/// changes no winding number off the surface, nor the side of a plane that does not hold the point; and the loops of a
/// face whose plane holds it wind neither about it, for it is not on the face, nor about any point near it, so that it
/// does not matter on which side they are counted. Vertical faces are seen as lines and wind about nothing.
int winding(const Integer_body& body, const std::vector<Rank_box>& face_boxes, const Integer_vector& p,
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

/// Some part of the one surface is in the other's solid. Requires surfaces that share no point: then the winding number
/// is the same about all points of a part.
bool contains(const Integer_body& outer, const std::vector<Rank_box>& face_boxes, const Integer_body& inner,
              const std::vector<Rank_box>& vertex_boxes)
{
  for (const Index v : inner.part_vertices())
    if (winding(outer, face_boxes, inner.point(v), vertex_boxes[v]) != 0) return true;
  return false;
}

}  // namespace

bool collide(const Object_case& c, kernel::Question question)
{
  Integer_points points_a = placed(c.a->vertices, c.pose_a), points_b = placed(c.b->vertices, c.pose_b);
  bring_together(points_a, points_b);
  const Integer_body a(*c.a, std::move(points_a.points)), b(*c.b, std::move(points_b.points));
  const auto [of_a, of_b] = element_boxes(a, b);
  if (edges_meet_faces(a, of_a.edges, b, of_b.faces) || edges_meet_faces(b, of_b.edges, a, of_a.faces)) return true;
  return question == kernel::Question::solid &&
         (contains(a, of_a.faces, b, of_b.vertices) || contains(b, of_b.faces, a, of_a.vertices));
}

}  // namespace tetracone::verify::integer_truth
