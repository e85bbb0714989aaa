#include "tetracone/covering/repair/repair.h"

#include "tetracone/covering/check.h"
#include "tetracone/covering/edge_uses.h"
#include "tetracone/covering/planarity.h"
#include "tetracone/covering/projection.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_repair)

using namespace tetracone::covering;
using tetracone::kernel::Rational;
using namespace tetracone::verify::scenes;

repair::Boundary boundary(const Polyhedron& polyhedron)
{
  repair::Boundary result;
  for (Index f = 0; f < polyhedron.face_count(); ++f)
    for_each_directed_edge(polyhedron, f, [&](Index a, Index b) { repair::add_edge(result, a, b); });
  return result;
}

BOOST_AUTO_TEST_CASE(planar_faces_stay_as_they_are)
{
  const Polyhedron p = square_frame();
  const Triangulated t = triangulate_non_planar(p);
  BOOST_TEST(t.replaced.empty());
  BOOST_TEST(t.polyhedron.face_count() == p.face_count());
  BOOST_TEST(t.polyhedron.loop_count(0) == 2u);
  BOOST_TEST(t.source.back() == p.face_count() - 1);
}

BOOST_AUTO_TEST_CASE(only_the_faces_off_plane_are_replaced_and_the_solid_stays_closed)
{
  const Polyhedron p = square_frame(0.25);
  const Triangulated t = triangulate_non_planar(p);
  // The top, with its hole; the walls at the lifted corner are still planar.
  BOOST_TEST((t.replaced == std::vector<Index>{1}));
  BOOST_TEST(t.fanned.empty());
  BOOST_TEST(t.polyhedron.face_count() == p.face_count() - 1 + 8);
  BOOST_TEST(t.source.size() == t.polyhedron.face_count());
  BOOST_TEST(std::ranges::count(t.source, Index{1}) == 8);
  const Check c = check(t.polyhedron);
  BOOST_TEST(c.closed);
  BOOST_TEST(c.off_plane.empty());
  BOOST_TEST(c.shells.at(0).genus.value() == 1u);
}

BOOST_AUTO_TEST_CASE(triangles_keep_the_direction_of_the_loop_in_every_projection)
{
  for (int axis = 0; axis < 3; ++axis)
    for (const bool turned : {false, true}) {
      std::vector<Vertex> vertices;
      // A non-convex polygon, one corner off the plane.
      for (const auto& [u, v, w] :
           {std::array{0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, {4.0, 4.0, 0.1}, {2.0, 1.0, 0.0}, {0.0, 4.0, 0.0}}) {
        Vertex p{};
        p[axis] = w;
        p[(axis + 1) % 3] = u;
        p[(axis + 2) % 3] = v;
        vertices.push_back(p);
      }
      std::vector<Index> loop = {0, 1, 2, 3, 4};
      if (turned) std::ranges::reverse(loop);
      const Polyhedron p = one_face(vertices, {loop});
      const Triangulated t = triangulate_non_planar(p);
      BOOST_TEST(t.polyhedron.face_count() == 3u);
      BOOST_TEST(t.fanned.empty());
      BOOST_TEST((boundary(t.polyhedron) == boundary(p)));
      Rational area = 0, expected = projected_area(p, p.loop(0, 0), axis);
      for (Index f = 0; f < 3; ++f) area += projected_area(t.polyhedron, t.polyhedron.loop(f, 0), axis);
      BOOST_TEST((area == expected));
    }
}

BOOST_AUTO_TEST_CASE(loops_that_run_twice_round_or_touch_in_a_vertex_are_triangulated)
{
  const Polyhedron twice = one_face({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}}, {{0, 1, 2, 3, 0, 1, 2, 3}}),
                   touching = one_face({{0, 0, 0}, {4, 0, 0}, {4, 4, 1}, {0, 4, 0}, {2, 1, 0}, {1, 2, 0}},
                                       {{0, 1, 2, 3}, {0, 5, 4}});
  for (const Polyhedron& p : {twice, touching}) {
    const Triangulated t = triangulate_non_planar(p);
    BOOST_TEST(t.fanned.empty());
    BOOST_TEST((boundary(t.polyhedron) == boundary(p)));
  }
  BOOST_TEST(triangulate_non_planar(twice).polyhedron.face_count() == 4u);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_triangulated_becomes_fans_with_the_same_boundary)
{
  const std::vector<Polyhedron> faces = {
      // Edges that cross in the projection.
      one_face({{0, 0, 0}, {3, 3, 0}, {3, 0, 0}, {0, 2, 1}, {-1, 5, 0}}, {{0, 1, 2, 3, 4}}),
      // Two corners in one point of the projection.
      one_face({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 2, 0}, {2, 2, 1}, {0, 4, 0}}, {{0, 1, 2, 3, 4, 5}}),
      // An edge through another corner of the projection.
      one_face({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 0, 1}}, {{0, 1, 2, 4, 3}}),
      // No area at all in any projection: a closed path and back.
      one_face({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3, 2, 1}}),
  };
  for (const Polyhedron& p : faces) {
    const Triangulated t = triangulate_non_planar(p);
    BOOST_TEST((t.replaced == std::vector<Index>{0}));
    BOOST_TEST((boundary(t.polyhedron) == boundary(p)));
    BOOST_TEST(check(t.polyhedron).off_plane.empty());
  }
  BOOST_TEST(triangulate_non_planar(faces[0]).fanned.size() == 1u);
  BOOST_TEST(triangulate_non_planar(faces[1]).fanned.size() == 1u);
  BOOST_TEST(triangulate_non_planar(faces[2]).fanned.size() == 1u);
}

BOOST_AUTO_TEST_CASE(random_loops_keep_their_boundary)
{
  std::mt19937 random(11);
  int by_triangulation = 0;
  for (int round = 0; round < 2000; ++round) {
    Polyhedron p;
    for (int v = 0; v < 6; ++v)
      p.vertices.push_back({double(random() % 5), double(random() % 5), double(random() % 3)});
    std::vector<std::vector<Index>> loops(1 + random() % 2);
    for (auto& loop : loops) {
      loop.resize(3 + random() % 3);
      for (Index& v : loop) v = random() % 6;
    }
    p.add_face(loops);
    const Triangulated t = triangulate_non_planar(p);
    BOOST_TEST((boundary(t.polyhedron) == boundary(p)));
    if (!t.replaced.empty()) {
      BOOST_TEST(check(t.polyhedron).off_plane.empty());
      by_triangulation += t.fanned.empty();
    }
  }
  BOOST_TEST(by_triangulation > 50);
}

BOOST_AUTO_TEST_CASE(orientation_restores_any_turned_faces_and_cgal_agrees_with_the_walk)
{
  std::mt19937_64 random(7);
  const Polyhedron p = torus(6, 5);
  for (int round = 0; round < 50; ++round) {
    const unsigned long pattern = random() & 0x3fffffff;
    const Polyhedron turned = turn_some(p, pattern);
    const Oriented oriented = orient(turned);
    BOOST_TEST(is_closed(oriented.polyhedron));
    BOOST_TEST(closes_if_oriented(turned));
    BOOST_TEST((boundary(oriented.polyhedron) == boundary(p)));
    BOOST_TEST((CGAL::sign(volume(oriented.polyhedron)) == CGAL::POSITIVE));
    BOOST_TEST((oriented.turned == orient_across_edges(turned).turned));
    BOOST_TEST(oriented.turned.size() == static_cast<std::size_t>(std::popcount(pattern)));
  }
}

BOOST_AUTO_TEST_CASE(an_open_surface_and_a_moebius_band_are_not_closed_by_orientation)
{
  BOOST_TEST(!closes_if_oriented(without_last_face(torus(6, 5))));
  Polyhedron p;
  for (int i = 0; i < 5; ++i) p.vertices.push_back({std::cos(i * 1.2566), std::sin(i * 1.2566), i * 0.1});
  for (Index i = 0; i < 5; ++i) p.add_polygon({i, (i + 1) % 5, (i + 2) % 5});
  BOOST_TEST(!closes_if_oriented(p));
  BOOST_TEST(orient(p).polyhedron.face_count() == 5u);
}

BOOST_AUTO_TEST_CASE(two_solids_that_share_an_edge_are_oriented_each_for_itself)
{
  // Two tetrahedra on the edge 0-1.
  Polyhedron p;
  p.vertices = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  for (const auto& t : {std::array<Index, 4>{0, 1, 2, 3}, {0, 1, 4, 5}}) {
    p.add_polygon({t[0], t[1], t[2]});
    p.add_polygon({t[0], t[1], t[3]});
    p.add_polygon({t[0], t[2], t[3]});
    p.add_polygon({t[1], t[2], t[3]});
  }
  const Oriented oriented = orient(p);
  BOOST_TEST(is_closed(oriented.polyhedron));
  BOOST_TEST((volume(oriented.polyhedron) == Rational(1) / 3));
  BOOST_TEST(check(oriented.polyhedron).non_manifold_edges == 1u);
}

BOOST_AUTO_TEST_SUITE_END()
