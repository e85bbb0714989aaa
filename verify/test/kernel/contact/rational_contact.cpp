#include "tetracone/kernel/contact/rational_contact.h"

#include "tetracone/kernel/contact/corner_point.h"
#include "tetracone/kernel/predicate/adaptive.h"
#include "tetracone/kernel/predicate/triangle_contact.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_rational_contact)

using namespace tetracone::kernel;

using Triangle_vertices = std::array<Vertex, 3>;
using Points = std::vector<Rational_point>;

Rational_point exactly(const Vertex& v) { return {Rational(v[0]), Rational(v[1]), Rational(v[2])}; }

Rational_face face_of(const std::vector<std::vector<Vertex>>& loops)
{
  std::vector<Rational_face::Edge> edges;
  for (const auto& loop : loops)
    for (std::size_t k = 0; k < loop.size(); ++k)
      edges.push_back({exactly(loop[k]), exactly(loop[(k + 1) % loop.size()])});
  return Rational_face(edges);
}

/// The signs' answer about two triangles: the corners of their intersection, in order of their coordinates.
struct By_signs {
  Points points;
  Feature in_p, in_q;
};

By_signs by_signs(const Triangle_vertices& p, const Triangle_vertices& q)
{
  std::array<Adaptive::Point_3, 3> a, b;
  std::array<Number_point<Rational>, 3> exact_p, exact_q;
  for (int k = 0; k < 3; ++k) {
    a[k] = Adaptive::unmoved(p[k]);
    b[k] = Adaptive::unmoved(q[k]);
    exact_p[k] = exactly(p[k]);
    exact_q[k] = exactly(q[k]);
  }
  const auto contact = triangle_contact<Adaptive>({&a[0], &a[1], &a[2]}, {&b[0], &b[1], &b[2]});
  By_signs result;
  Edge_set on_p = 7, on_q = 7;
  for (int k = 0; k < contact.count; ++k) {
    on_p &= contact.corners[k].on_p;
    on_q &= contact.corners[k].on_q;
    result.points.push_back(corner_point(exact_p, exact_q, contact.corners[k]));
  }
  const auto held = [&](Edge_set edges) {
    return contact.count == 1 && std::popcount(edges) == 2 ? Feature::vertex
           : edges != 0 && contact.count < 3               ? Feature::edge
                                                           : Feature::interior;
  };
  result.in_p = held(on_p);
  result.in_q = held(on_q);
  return result;
}

/// Neighbours in the loop, each pair once, in order.
std::vector<Points> sides_of(const Points& loop)
{
  std::vector<Points> sides;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    sides.push_back({loop[k], loop[(k + 1) % loop.size()]});
    std::sort(sides.back().begin(), sides.back().end());
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

// Triangles of a grid of 4 x 4 x 4 points, so that most meetings are degenerate: those by signs against those by
// rational constructions, which share nothing.
BOOST_AUTO_TEST_CASE(triangles_meet_by_signs_where_they_do_in_rationals)
{
  std::mt19937 random(1);
  std::map<std::size_t, int> seen;
  for (int tried = 0; tried < 6000; ++tried) {
    const int depth = tried % 3 == 0 ? 1 : 4;  // a third in one plane
    std::array<Triangle_vertices, 2> t;
    for (Triangle_vertices& corners : t)
      for (Vertex& v : corners) v = {double(random() % 4), double(random() % 4), double(random() % depth)};
    const Rational_face p = face_of({{t[0][0], t[0][1], t[0][2]}}), q = face_of({{t[1][0], t[1][1], t[1][2]}});
    if (!p.has_plane() || !q.has_plane()) continue;
    const By_signs found = by_signs(t[0], t[1]);
    const auto truth = face_contact(p, q);
    ++seen[found.points.size()];
    BOOST_TEST_REQUIRE(truth.size() == (found.points.empty() ? 0u : 1u), "triangles " << tried);
    if (truth.empty()) continue;
    BOOST_TEST((truth[0].in_p == found.in_p), "triangles " << tried);
    BOOST_TEST((truth[0].in_q == found.in_q), "triangles " << tried);
    BOOST_TEST((sides_of(truth[0].loops[0]) == sides_of(found.points)), "triangles " << tried);
  }
  for (std::size_t corners = 0; corners <= 6; ++corners) BOOST_TEST(seen[corners] > 0, corners << " corners");
}

BOOST_AUTO_TEST_CASE(faces_with_holes_share_several_pieces)
{
  const Rational_face frame =
      face_of({{{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}}, {{-2, 2, 0}, {2, 2, 0}, {2, -2, 0}, {-2, -2, 0}}});
  const Rational_face blade = face_of({{{-9, 0, -1}, {9, 0, -1}, {9, 0, 1}, {-9, 0, 1}}});
  const auto cut = face_contact(frame, blade);
  BOOST_TEST_REQUIRE(cut.size() == 2u);
  for (const auto& piece : cut) BOOST_TEST((piece.kind == Piece::segment && piece.in_p == Feature::interior));

  const Rational_face bar = face_of({{{-9, -1, 0}, {9, -1, 0}, {9, 1, 0}, {-9, 1, 0}}});
  BOOST_TEST(face_contact(frame, bar).size() == 2u);
  const auto itself = face_contact(frame, frame);
  BOOST_TEST_REQUIRE(itself.size() == 1u);
  BOOST_TEST(itself[0].loops.size() == 2u);
}

BOOST_AUTO_TEST_CASE(edges_that_cross_planes_bound_what_points_on_the_line_tell)
{
  // Loops that cross themselves, some with a second loop, in planes that are not parallel.
  std::mt19937 random(2);
  std::map<std::size_t, int> seen;
  int left = 0;
  for (int tried = 0; tried < 4000; ++tried) {
    std::vector<Rational_face> faces;
    for (const auto& [u, v] :
         {std::pair(Vertex{1, 0, 0.25}, Vertex{0, 1, -0.5}), {Vertex{1, 0.5, 0}, Vertex{0.25, 0, 1}}}) {
      std::vector<std::vector<Vertex>> loops(1 + random() % 2);
      for (auto& loop : loops)
        for (std::size_t k = 3 + random() % 4; k > 0; --k) {
          const double s = double(random() % 16) - 7.5, t = double(random() % 16) - 7.5;
          loop.push_back({s * u[0] + t * v[0], s * u[1] + t * v[1], s * u[2] + t * v[2]});
        }
      faces.push_back(face_of(loops));
    }
    const Rational_face &p = faces[0], &q = faces[1];
    const auto of_p = detail::seen_edges(p, q), of_q = detail::seen_edges(q, p);
    const auto pieces = detail::crossing_pieces(of_p, of_q);
    if (!p.has_plane() || !q.has_plane() || !pieces) {
      ++left;
      continue;
    }
    const auto expected = detail::Line_contact(p, q, of_p, of_q, cross(p.normal(), q.normal()))();
    ++seen[expected.size()];
    BOOST_TEST_REQUIRE(pieces->size() == expected.size(), "faces " << tried);
    for (std::size_t k = 0; k < expected.size(); ++k) {
      BOOST_TEST(((*pieces)[k].kind == expected[k].kind), "faces " << tried);
      BOOST_TEST(((*pieces)[k].in_p == expected[k].in_p && (*pieces)[k].in_q == expected[k].in_q), "faces " << tried);
      BOOST_TEST(((*pieces)[k].loops == expected[k].loops), "faces " << tried);
    }
  }
  BOOST_TEST(left < 2000);
  for (std::size_t count = 0; count <= 3; ++count) BOOST_TEST(seen[count] > 20, count << " pieces");
}

BOOST_AUTO_TEST_CASE(faces_without_a_plane_share_points_and_segments)
{
  const Rational_face stick = face_of({{{0, 0, 0}, {2, 2, 2}}}), point = face_of({{{1, 1, 1}}});
  const Rational_face plate = face_of({{{0, 0, 1}, {3, 0, 1}, {3, 3, 1}, {0, 3, 1}}});
  for (const auto& [p, q] : {std::pair(&stick, &plate), {&plate, &stick}, {&point, &plate}, {&point, &stick}}) {
    const auto shared = face_contact(*p, *q);
    BOOST_TEST_REQUIRE(shared.size() == 1u);
    BOOST_TEST((shared[0].kind == Piece::point));
    BOOST_TEST((shared[0].loops[0][0] == Rational_point{1, 1, 1}));
  }
  BOOST_TEST((face_contact(stick, stick)[0].kind == Piece::segment));
}

BOOST_AUTO_TEST_SUITE_END()
