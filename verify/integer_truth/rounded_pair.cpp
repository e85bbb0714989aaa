#include "verify/integer_truth/rounded_pair.h"

#include "verify/integer_truth/integer_contact.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>

namespace tetracone::verify {
namespace {

using namespace integer_truth;
using covering::Polyhedron;

bool meets_bent_face(const Integer_vector& a, const Integer_vector& b, const Integer_body& body, Index f,
                     const std::optional<std::array<Index, 3>>& plane)
{
  Integer_vector n;
  if (plane) {
    const Integer_vector& origin = body.point((*plane)[0]);
    n = cross(difference(body.point((*plane)[1]), origin), difference(body.point((*plane)[2]), origin));
  }
  if (is_zero(n)) return meets_loops(a, b, body, f);
  const auto side = [&](const Integer_vector& x) { return sgn(dot(n, difference(x, body.point((*plane)[0])))); };
  const int side_a = side(a), side_b = side(b);
  if (side_a * side_b > 0) return false;
  if (side_a == 0 && side_b == 0)
    return meets_loops(a, b, body, f) || is_on_face(body, f, n, a, 1) || is_on_face(body, f, n, b, 1);
  const Integer_vector along = difference(b, a);
  const int k = projection_axis(along), i = (k + 1) % 3, j = (k + 2) % 3;
  const Turns turns = body.turns(f, [&](Index v) {
    const Integer_vector r = difference(body.point(v), a);
    return std::array{Integer(r[i] * along[k] - r[k] * along[i]), Integer(r[j] * along[k] - r[k] * along[j])};
  });
  return turns.on_loop || turns.winding != 0;
}

/// The triangles that join the first corner of each face to the face's edges. They bound the solid of a closed surface,
/// bent or not, and are planar.
Polyhedron fans(const Polyhedron& surface)
{
  Polyhedron result;
  result.vertices = surface.vertices;
  for (Index f = 0; f < surface.face_count(); ++f) {
    const Index first = surface.loop(f, 0)[0];
    for (std::size_t k = 0; k < surface.loop_count(f); ++k) {
      const covering::Loop loop = surface.loop(f, k);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Index from = loop[i], to = loop[i + 1 == loop.size() ? 0 : i + 1];
        if (from != first && to != first) result.add_polygon({first, from, to});
      }
    }
  }
  return result;
}

/// The boxes of the faces; of those that may be bent all of space, since what they meet may be beyond their corners.
std::vector<Rank_box> face_boxes(const Polyhedron& surface, std::vector<Rank_box> boxes)
{
  constexpr int all = std::numeric_limits<int>::max();
  for (Index f = 0; f < surface.face_count(); ++f)
    if (!surface.is_triangle(f)) boxes[f] = {{-1, -1, -1}, {all, all, all}};
  return boxes;
}

}  // namespace

bool Rounded_body::is_finite() const
{
  return std::ranges::all_of(surface.vertices, [](const auto& v) {
    return std::ranges::all_of(v, [](double x) { return std::isfinite(x); });
  });
}

Rounded_pair::Rounded_pair(const Rounded_body& a, const Rounded_body& b, kernel::Question question)
{
  Integer_points points_a = placed(a.surface.vertices, kernel::Pose()),
                 points_b = placed(b.surface.vertices, kernel::Pose());
  bring_together(points_a, points_b);
  const Integer_body body_a(a.surface, points_a.points), body_b(b.surface, points_b.points);
  const auto [of_a, of_b] = element_boxes(body_a, body_b);
  const auto add = [&](int number, const Integer_body& with_edges, const Element_boxes& edges,
                       const Integer_body& other, const Rounded_body& with_faces, const Element_boxes& faces) {
    for (const auto& [f, e] : meeting_boxes(face_boxes(with_faces.surface, faces.faces), edges.edges)) {
      const auto& [from, to] = with_edges.edges()[e];
      if (meets_bent_face(with_edges.point(from), with_edges.point(to), other, f, with_faces.planes[f]))
        pairs_.insert({number, from, to, f});
    }
  };
  add(0, body_a, of_a, body_b, b, of_b);
  add(1, body_b, of_b, body_a, a, of_a);

  // Which faces these edges are of.
  std::map<std::pair<Index, Index>, std::vector<Index>> faces_at[2];
  for (const auto& [body, from, to, face] : pairs_) faces_at[body][{from, to}];
  for (int k = 0; k < 2 && !pairs_.empty(); ++k) {
    const Integer_body& body = k == 0 ? body_a : body_b;
    for (Index f = 0; f < body.face_count(); ++f)
      body.for_edges(f, [&](Index from, Index to) {
        if (const auto edge = faces_at[k].find(std::minmax(from, to)); edge != faces_at[k].end())
          edge->second.push_back(f);
      });
  }
  for (const auto& [body, from, to, face] : pairs_)
    for (const Index f : faces_at[body].at({from, to}))
      meeting_faces_.insert(body == 0 ? std::pair(f, face) : std::pair(face, f));

  if (question != kernel::Question::solid || !pairs_.empty()) return;
  const Polyhedron fans_a = fans(a.surface), fans_b = fans(b.surface);
  const Integer_body solid_a(fans_a, points_a.points), solid_b(fans_b, points_b.points);
  const auto [boxes_a, boxes_b] = element_boxes(solid_a, solid_b);
  contained_ = contains(solid_a, boxes_a.faces, body_b, boxes_b.vertices) ||
               contains(solid_b, boxes_b.faces, body_a, boxes_a.vertices);
}

bool Rounded_pair::faces_meet(Index of_a, Index of_b) const { return meeting_faces_.contains({of_a, of_b}); }

}  // namespace tetracone::verify
