#include "tetracone/covering/check.h"

#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_check)

using namespace tetracone::covering;
using tetracone::kernel::Rational;
using namespace tetracone::verify::scenes;

/// The definition, by the letter.
bool closed_by_brute_force(const Polyhedron& polyhedron)
{
  std::map<std::pair<Index, Index>, int> uses;
  for (Index f = 0; f < polyhedron.face_count(); ++f)
    for (std::size_t k = 0; k < polyhedron.loop_count(f); ++k) {
      const Loop loop = polyhedron.loop(f, k);
      for (std::size_t j = 0; j < loop.size(); ++j) ++uses[{loop[j], loop[(j + 1) % loop.size()]}];
    }
  return std::ranges::all_of(uses, [&](const auto& entry) {
    const auto reverse = uses.find({entry.first.second, entry.first.first});
    return reverse != uses.end() && reverse->second == entry.second;
  });
}

BOOST_AUTO_TEST_CASE(a_cube_is_a_cube)
{
  const Check c = check(unit_cube());
  BOOST_TEST(c.vertices == 8u);
  BOOST_TEST(c.used_vertices == 8u);
  BOOST_TEST(c.faces == 6u);
  BOOST_TEST(c.triangles == 0u);
  BOOST_TEST(c.edges == 12u);
  BOOST_TEST(c.corners == 24u);
  BOOST_TEST(c.closed);
  BOOST_TEST(c.open_edges.empty());
  BOOST_TEST(c.border_edges == 0u);
  BOOST_TEST(c.non_manifold_edges == 0u);
  BOOST_REQUIRE(c.shells.size() == 1u);
  BOOST_TEST(c.shells[0].euler == 2);
  BOOST_TEST(c.shells[0].genus.value() == 0u);
  BOOST_TEST((c.volume.value() == 1));
  BOOST_TEST((c.orientation == Orientation::outward));
  BOOST_TEST(c.off_plane.empty());
  BOOST_TEST(c.degenerate_faces.empty());
  BOOST_TEST(c.degenerate_edges.empty());
  BOOST_TEST(c.repeated_vertices.empty());
  BOOST_TEST(c.isolated_vertices.empty());
}

BOOST_AUTO_TEST_CASE(holed_faces_count_for_the_genus)
{
  const Check c = check(square_frame());
  BOOST_TEST(c.closed);
  BOOST_TEST((c.volume.value() == 8));
  BOOST_TEST(c.hole_loops == 2u);
  BOOST_TEST((c.holed_faces == std::vector<Index>{0, 1}));
  BOOST_REQUIRE(c.shells.size() == 1u);
  BOOST_TEST(c.shells[0].euler == 0);
  BOOST_TEST(c.shells[0].genus.value() == 1u);
}

BOOST_AUTO_TEST_CASE(shells_have_their_own_volume_and_orientation)
{
  Check c = check(with_cavity(box({0, 0, 0}, {4, 4, 4}), box({1, 1, 1}, {2, 2, 2})));
  BOOST_TEST(c.closed);
  BOOST_REQUIRE(c.shells.size() == 2u);
  BOOST_TEST((c.shells[0].volume.value() == 64));
  BOOST_TEST((c.shells[1].volume.value() == -1));
  BOOST_TEST((c.volume.value() == 63));
  BOOST_TEST((c.orientation == Orientation::mixed));
  c = check(turned(both(box({0, 0, 0}, {2, 2, 2}), box({5, 5, 5}, {6, 6, 6}))));
  BOOST_TEST((c.volume.value() == -9));
  BOOST_TEST((c.orientation == Orientation::inward));
}

BOOST_AUTO_TEST_CASE(an_open_surface_names_its_open_edges)
{
  const Check c = check(without(unit_cube(), [](Index f) { return f == 4; }));
  BOOST_TEST(!c.closed);
  BOOST_TEST(!c.volume.has_value());
  BOOST_TEST((c.orientation == Orientation::open));
  BOOST_TEST(c.border_edges == 4u);
  BOOST_REQUIRE(c.open_edges.size() == 4u);
  // The missing face is 0 2 3 1: what is left runs 0 1 3 2.
  BOOST_TEST(c.open_edges[0].from == 0u);
  BOOST_TEST(c.open_edges[0].to == 1u);
  BOOST_TEST(c.open_edges[0].uses == 1u);
  BOOST_TEST(c.open_edges[0].reverse_uses == 0u);
  BOOST_TEST(c.open_edges[3].from == 3u);
  BOOST_TEST(!c.shells.at(0).genus.has_value());
}

BOOST_AUTO_TEST_CASE(a_turned_face_opens_each_of_its_edges_by_two)
{
  const Check c = check(turn_some(unit_cube(), 1 << 2));
  BOOST_TEST(!c.closed);
  BOOST_TEST(c.border_edges == 0u);
  BOOST_REQUIRE(c.open_edges.size() == 4u);
  for (const auto& edge : c.open_edges) BOOST_TEST((edge.uses == 2u && edge.reverse_uses == 0u));
}

BOOST_AUTO_TEST_CASE(closed_agrees_with_the_definition_on_random_faces)
{
  std::mt19937 random(5);
  int closed = 0;
  for (int round = 0; round < 4000; ++round) {
    Polyhedron p;
    p.vertices.resize(4);
    const auto corner = [&random] { return static_cast<Index>(random() % 4); };
    // Faces and sometimes their reverses, with repeated corners and loops of one and two corners.
    for (int f = 0; f < 3; ++f) {
      std::vector<std::vector<Index>> loops(1 + random() % 2);
      for (auto& loop : loops) {
        loop.resize(1 + random() % 4);
        std::ranges::generate(loop, corner);
      }
      p.add_face(loops);
      if (random() % 2 == 0) continue;
      for (auto& loop : loops) std::ranges::reverse(loop);
      p.add_face(loops);
    }
    const bool expected = closed_by_brute_force(p);
    closed += expected;
    BOOST_TEST(is_closed(p) == expected);
    BOOST_TEST(check(p).closed == expected);
  }
  BOOST_TEST(closed > 100);
}

BOOST_AUTO_TEST_CASE(two_cubes_that_share_an_edge_are_closed_and_no_manifold)
{
  Polyhedron p = unit_cube();
  append(p, box({1, 1, 1}, {2, 2, 2}));
  // Vertex 7 = (1,1,1) of the first is vertex 8 of the second: they touch in a point.
  Polyhedron touching;
  touching.vertices = p.vertices;
  for (Index f = 0; f < p.face_count(); ++f) {
    std::vector<Index> loop(p.loop(f, 0).begin(), p.loop(f, 0).end());
    std::ranges::replace(loop, Index{8}, Index{7});
    touching.add_polygon(loop);
  }
  const Check c = check(touching);
  BOOST_TEST(c.closed);
  BOOST_TEST(c.shells.size() == 1u);
  BOOST_TEST(c.non_manifold_edges == 0u);
  BOOST_TEST(!c.shells[0].genus.has_value());
  BOOST_TEST((c.isolated_vertices == std::vector<Index>{8}));
  BOOST_TEST((c.repeated_vertices == std::vector<Index>{8}));
  BOOST_TEST((c.volume.value() == 2));
}

BOOST_AUTO_TEST_CASE(degenerate_elements_are_named)
{
  Polyhedron p = unit_cube();
  p.vertices.push_back({0.5, 0, 0});  // 8: on the edge 0-1
  p.vertices.push_back({1, 0, 0});    // 9: repeats 1
  p.vertices.push_back({7, 7, 7});    // 10: of no face
  p.add_polygon({0, 8, 1});           // on one line
  p.add_polygon({1, 8, 0});
  p.add_polygon({1, 9, 2});  // an edge of length 0
  p.add_polygon({2, 9, 1});
  p.add_polygon({3, 3, 4});  // a corner twice
  p.add_polygon({4, 3, 3});
  const Check c = check(p);
  BOOST_TEST(c.closed);
  BOOST_TEST((c.volume.value() == 1));
  BOOST_TEST((c.degenerate_faces == std::vector<Index>{6, 7, 8, 9, 10, 11}));
  BOOST_TEST((c.degenerate_edges == std::vector<std::array<Index, 2>>{{1, 9}, {3, 3}}));
  BOOST_TEST((c.repeated_vertices == std::vector<Index>{9}));
  BOOST_TEST((c.isolated_vertices == std::vector<Index>{10}));
  BOOST_TEST(c.used_vertices == 10u);
}

BOOST_AUTO_TEST_CASE(a_flat_closed_shell_is_flat)
{
  Polyhedron p;
  p.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  p.add_polygon({0, 1, 2});
  p.add_polygon({2, 1, 0});
  const Check c = check(p);
  BOOST_TEST(c.closed);
  BOOST_TEST((c.orientation == Orientation::flat));
  BOOST_TEST(c.shells.at(0).genus.value() == 0u);
}

BOOST_AUTO_TEST_CASE(the_deviation_of_a_corner_is_exact_and_of_equally_distant_ones_the_first_is_named)
{
  // The unit square with its third corner lifted by h. Here p = 0, q = the lifted corner (the farthest), r = 1. The
  // plane through them is y h - z = 0 in (x, y, z), or x h - z = 0. So the corner left over is h / sqrt(1 + h^2) off.
  for (const double h : {0.25, 0x1p-30, 1.0, 0x1p-600}) {
    const Polyhedron p = one_face({{0, 0, 0}, {1, 0, 0}, {1, 1, h}, {0, 1, 0}}, {{0, 1, 2, 3}});
    BOOST_TEST((planarity(p, 0) == Planarity::off_plane));
    const Off_plane off = deviation(p, 0);
    BOOST_TEST((off.squared_distance == Rational(h) * Rational(h) / (1 + Rational(h) * Rational(h))));
    BOOST_TEST(off.vertex == 3u);
    BOOST_TEST(std::abs(off.distance - h / std::hypot(1.0, h)) <= 4e-16 * h);
  }
  const Polyhedron p = one_face({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {1, 3, 1}, {1, 2, -1}}, {{0, 1, 2, 4, 3}});
  BOOST_TEST(deviation(p, 0).vertex == 4u);
  BOOST_TEST((deviation(p, 0).squared_distance == 1));
}

BOOST_AUTO_TEST_CASE(planarity_is_the_same_for_every_order_of_corners)
{
  std::vector<Index> order = {0, 1, 2, 3, 4};
  for (const double h : {0.0, 0x1p-1074, 1e-17}) {
    do {
      // The first three corners are on one line.
      const Polyhedron p = one_face({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, h}, {1, 1, 0}}, {order});
      BOOST_TEST((planarity(p, 0) == (h == 0 ? Planarity::planar : Planarity::off_plane)));
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

BOOST_AUTO_TEST_CASE(a_hole_off_the_plane_of_its_face_counts)
{
  Polyhedron p = square_frame();
  p.vertices[4][2] = -0.5;
  const Check c = check(p);
  BOOST_REQUIRE(!c.off_plane.empty());
  BOOST_TEST(c.off_plane[0].face == 0u);
  BOOST_TEST(c.off_plane[0].vertex == 4u);
  BOOST_TEST((c.off_plane[0].squared_distance == Rational(1) / 4));
}

BOOST_AUTO_TEST_SUITE_END()
