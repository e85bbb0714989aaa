#include "tetracone/covering/polyhedron.h"

#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_polyhedron)

using namespace tetracone::covering;
namespace scenes = tetracone::verify::scenes;

namespace {

std::vector<Index> indices(Loop loop) { return {loop.begin(), loop.end()}; }

}  // namespace

BOOST_AUTO_TEST_CASE(an_empty_polyhedron_has_no_faces)
{
  const Polyhedron empty;
  BOOST_TEST(empty.face_count() == 0u);
  BOOST_TEST(empty.vertices.empty());
}

BOOST_AUTO_TEST_CASE(faces_keep_their_loops_and_corners_in_the_order_given)
{
  Polyhedron body;
  body.add_polygon({3, 1, 2});
  body.add_face({{0, 1, 2, 3}, {4, 5, 6}, {7}});
  body.add_polygon(std::vector<Index>{9, 8});
  body.add_face(std::vector<std::vector<Index>>{{5, 5}, {6, 7, 8, 9}});

  BOOST_TEST(body.face_count() == 4u);
  BOOST_TEST(body.loop_count(0) == 1u);
  BOOST_TEST(body.loop_count(1) == 3u);
  BOOST_TEST(body.loop_count(2) == 1u);
  BOOST_TEST(body.loop_count(3) == 2u);
  BOOST_TEST(indices(body.loop(0, 0)) == (std::vector<Index>{3, 1, 2}));
  BOOST_TEST(indices(body.loop(1, 0)) == (std::vector<Index>{0, 1, 2, 3}));
  BOOST_TEST(indices(body.loop(1, 1)) == (std::vector<Index>{4, 5, 6}));
  BOOST_TEST(indices(body.loop(1, 2)) == (std::vector<Index>{7}));
  BOOST_TEST(indices(body.loop(2, 0)) == (std::vector<Index>{9, 8}));
  BOOST_TEST(indices(body.loop(3, 0)) == (std::vector<Index>{5, 5}));
  BOOST_TEST(indices(body.loop(3, 1)) == (std::vector<Index>{6, 7, 8, 9}));
}

BOOST_AUTO_TEST_CASE(a_triangle_is_one_loop_of_three_corners)
{
  Polyhedron body;
  body.add_polygon({0, 1, 2});
  body.add_polygon({0, 1, 2, 3});
  body.add_polygon({0, 1});
  body.add_face({{0, 1, 2}, {3, 4, 5}});
  body.add_polygon({2, 2, 2});
  const std::array<bool, 5> expected = {true, false, false, false, true};
  for (Index f = 0; f < body.face_count(); ++f) BOOST_TEST(body.is_triangle(f) == expected[f]);
}

BOOST_AUTO_TEST_CASE(a_face_may_be_built_from_the_loops_of_another_polyhedron)
{
  const Polyhedron tunnel = scenes::cube_with_tunnel();
  Polyhedron copy;
  for (Index f = 0; f < tunnel.face_count(); ++f) {
    std::vector<Loop> loops;
    for (std::size_t l = 0; l < tunnel.loop_count(f); ++l) loops.push_back(tunnel.loop(f, l));
    copy.add_face(loops);
  }
  BOOST_REQUIRE(copy.face_count() == tunnel.face_count());
  for (Index f = 0; f < copy.face_count(); ++f) {
    BOOST_REQUIRE(copy.loop_count(f) == tunnel.loop_count(f));
    for (std::size_t l = 0; l < copy.loop_count(f); ++l)
      BOOST_TEST(indices(copy.loop(f, l)) == indices(tunnel.loop(f, l)));
  }
}

BOOST_AUTO_TEST_CASE(append_keeps_what_is_there_and_numbers_the_new_vertices_after_it)
{
  Polyhedron body;
  body.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  body.add_polygon({0, 1, 2});
  Polyhedron more;
  more.vertices = {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {7, 7, 7}};
  more.add_face({{0, 1, 2, 3}, {2, 1, 0}});
  more.add_polygon({3});

  append(body, more);
  BOOST_TEST(body.vertices.size() == 7u);
  BOOST_TEST((body.vertices[2] == Vertex{0, 1, 0}));
  BOOST_TEST((body.vertices[3] == Vertex{5, 0, 0}));
  BOOST_REQUIRE(body.face_count() == 3u);
  BOOST_TEST(indices(body.loop(0, 0)) == (std::vector<Index>{0, 1, 2}));
  BOOST_REQUIRE(body.loop_count(1) == 2u);
  BOOST_TEST(indices(body.loop(1, 0)) == (std::vector<Index>{3, 4, 5, 6}));
  BOOST_TEST(indices(body.loop(1, 1)) == (std::vector<Index>{5, 4, 3}));
  BOOST_TEST(indices(body.loop(2, 0)) == (std::vector<Index>{6}));

  append(body, Polyhedron());
  BOOST_TEST(body.vertices.size() == 7u);
  BOOST_TEST(body.face_count() == 3u);
}

BOOST_AUTO_TEST_CASE(append_turned_runs_every_loop_the_other_way_round_and_twice_gives_it_back)
{
  const Polyhedron tunnel = scenes::cube_with_tunnel();
  Polyhedron once, twice;
  append(once, tunnel, true);
  append(twice, once, true);
  BOOST_TEST((once.vertices == tunnel.vertices));
  BOOST_REQUIRE(once.face_count() == tunnel.face_count());
  for (Index f = 0; f < tunnel.face_count(); ++f) {
    BOOST_REQUIRE(once.loop_count(f) == tunnel.loop_count(f));
    for (std::size_t l = 0; l < tunnel.loop_count(f); ++l) {
      const Loop loop = tunnel.loop(f, l);
      BOOST_TEST(indices(once.loop(f, l)) == (std::vector<Index>{loop.rbegin(), loop.rend()}));
      BOOST_TEST(indices(twice.loop(f, l)) == indices(loop));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
