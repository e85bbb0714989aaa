#include "tetracone/covering/face_cover.h"

#include "tetracone/covering/repair/repair.h"
#include "tetracone/covering/star_faces.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_face_cover)

using namespace tetracone::covering;
using namespace tetracone::verify::scenes;
using Triangles = std::vector<Face_cover::Triangle>;

std::string flaw(const Polyhedron& p, const Triangles& triangles)
{
  return Face_cover(p).flaw(0, triangles).value_or("");
}

const std::vector<std::array<double, 2>> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};

BOOST_AUTO_TEST_CASE(what_covers_a_face_has_no_flaw)
{
  const Polyhedron p = slanted_face(square, {{0, 1, 2, 3}});
  BOOST_TEST(flaw(p, {{0, 1, 2}, {0, 2, 3}}) == "");
  BOOST_TEST(flaw(p, {{1, 2, 3}, {3, 0, 1}}) == "");
  const Polyhedron turned = slanted_face(square, {{3, 2, 1, 0}});
  BOOST_TEST(flaw(turned, {{2, 1, 0}, {3, 2, 0}}) == "");
  // Twice round: each triangle twice.
  const Polyhedron twice = slanted_face(square, {{0, 1, 2, 3, 0, 1, 2, 3}});
  BOOST_TEST(flaw(twice, {{0, 1, 2}, {0, 2, 3}, {1, 2, 3}, {1, 3, 0}}) == "");
  BOOST_TEST(flaw(twice, {{0, 1, 2}, {0, 2, 3}}) != "");
  // All that is made here.
  for (const auto& [name, body] : closed_bodies()) BOOST_TEST_CONTEXT(name)
    {
      BOOST_TEST(!cover_flaw(body, star_faces(body)).has_value());
      BOOST_TEST(!cover_flaw(body, triangulate_faces(body)).has_value());
    }
}

BOOST_AUTO_TEST_CASE(each_flaw_is_named)
{
  auto corners = square;
  corners.push_back({1, 1});  // no corner of the face
  corners.push_back({5, 5});
  const Polyhedron p = slanted_face(corners, {{0, 1, 2, 3}});
  const std::string ends = "its triangles do not end where its loops do, at the edge of vertices ";
  BOOST_TEST(flaw(p, {{0, 1, 2}}) == ends + "0 and 2");                        // half
  BOOST_TEST(flaw(p, {{0, 1, 2}, {0, 2, 3}, {0, 1, 2}}) == ends + "0 and 1");  // a triangle twice
  BOOST_TEST(flaw(p, {{0, 1, 2}, {0, 2, 3}, {1, 2, 3}}) == ends + "1 and 2");  // one that overlaps
  BOOST_TEST(flaw(p, {{0, 1, 2}, {0, 3, 2}}) == ends + "0 and 2");             // one turned over
  BOOST_TEST(flaw(p, {{2, 1, 0}, {3, 2, 0}}) == ends + "0 and 1");             // all turned over
  BOOST_TEST(flaw(p, {{0, 1, 2}, {0, 2, 4}}) == "its triangle 0 2 4 has corner 4, which is not the face's");
  BOOST_TEST(flaw(p, {{0, 1, 2}, {0, 2, 5}}) == "its triangle 0 2 5 has corner 5, which is not the face's");
  BOOST_TEST(flaw(p, {{0, 1, 2}, {0, 2, 3}, {0, 0, 1}}) == "its triangle 0 0 1 has no area");
  BOOST_TEST(flaw(p, {{0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {2, 1, 0}}) == "triangles of opposite directions overlap");
  // A fan that fills a notch, and its opposite.
  const Polyhedron notched = slanted_face({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}, {{0, 1, 2, 3, 4}});
  BOOST_TEST(flaw(notched, {{3, 0, 1}, {3, 1, 2}, {3, 4, 0}}) == "");
  BOOST_TEST(flaw(notched, {{0, 1, 2}, {0, 2, 4}, {2, 4, 3}}) == ends + "2 and 3");
  BOOST_TEST(flaw(notched, {{0, 1, 2}, {0, 2, 4}, {4, 2, 3}}) == "triangles of opposite directions overlap");
}

BOOST_AUTO_TEST_CASE(corners_on_one_line_have_no_area)
{
  const Polyhedron p = slanted_face({{0, 0}, {1, 0}, {2, 0}, {0, 2}}, {{0, 1, 2, 3}});
  BOOST_TEST(flaw(p, {{0, 1, 3}, {1, 2, 3}}) == "");
  BOOST_TEST(flaw(p, {{0, 1, 2}, {0, 2, 3}}) == "its triangle 0 1 2 has no area");
  BOOST_TEST(flaw(slanted_face({{0, 0}, {1, 0}, {2, 0}, {3, 0}}, {{0, 1, 2, 3}}), {{0, 1, 2}, {0, 2, 3}}) ==
             "its triangle 0 1 2 has no area");
}

BOOST_AUTO_TEST_CASE(holes_and_lobes_of_either_direction_are_covered)
{
  // A square with a square hole, whose loop runs the other way round.
  const Polyhedron frame =
      slanted_face({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {3, 1}, {3, 3}, {1, 3}}, {{0, 1, 2, 3}, {7, 6, 5, 4}});
  const Triangles around{{0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  BOOST_TEST(flaw(frame, around) == "");
  BOOST_TEST(flaw(frame, {{0, 1, 2}, {0, 2, 3}}) != "");
  // Filled, and emptied again: the edges add up, and the hole is covered.
  BOOST_TEST(flaw(frame, {{0, 1, 2}, {0, 2, 3}, {7, 6, 5}, {7, 5, 4}}) == "triangles of opposite directions overlap");
  // Two lobes that share a corner, of winding numbers 1 and -1.
  const Polyhedron lobes = slanted_face({{0, 0}, {1, -1}, {1, 1}, {-1, -1}, {-1, 1}}, {{0, 1, 2, 0, 3, 4}});
  BOOST_TEST(flaw(lobes, {{0, 1, 2}, {0, 3, 4}}) == "");
  BOOST_TEST(flaw(lobes, {{0, 1, 2}, {0, 4, 3}}) != "");
}

BOOST_AUTO_TEST_CASE(an_edge_that_bounds_nothing_is_a_side)
{
  // From the square's corner to a point within, and back.
  const Polyhedron slit = slanted_face({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 2}}, {{0, 1, 2, 3, 0, 4}});
  BOOST_TEST(flaw(slit, {{0, 1, 2}, {0, 2, 3}}) ==
             "its triangles do not end where its loops do, at the edge of vertices 0 and 4");
  BOOST_TEST(flaw(slit, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}) == "");
}

BOOST_AUTO_TEST_CASE(a_loop_of_one_point_is_covered_by_a_corner)
{
  const std::vector<std::array<double, 2>> points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {9, 9}};
  const Triangles halves{{0, 1, 2}, {0, 2, 3}};
  BOOST_TEST(flaw(slanted_face(points, {{0, 1, 2, 3}, {4, 4, 4}}), halves) == "no triangle has its corner 4");
  BOOST_TEST(flaw(slanted_face(points, {{0, 1, 2, 3}, {2, 2, 2}}), halves) == "");
  BOOST_TEST(flaw(slanted_face(points, {{0, 0, 1, 2, 3}}), halves) == "");
}

BOOST_AUTO_TEST_CASE(a_corner_of_the_face_before_is_not_this_ones)
{
  // A roof over the square, by the apex of a face that stands on it.
  Polyhedron wall;
  wall.vertices = slanted_face(square, {{0, 1, 2, 3}}).vertices;
  wall.vertices.push_back({1, 1, 9});
  wall.add_polygon({0, 2, 4});
  wall.add_polygon({0, 1, 2, 3});
  const Triangles roof{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  Face_cover cover(wall);
  BOOST_TEST(cover.flaw(0, Triangles{{0, 2, 4}}).value_or("") == "");
  BOOST_TEST(cover.flaw(1, roof).value_or("") == "its triangle 0 1 4 has corner 4, which is not the face's");
}

BOOST_AUTO_TEST_CASE(the_face_is_named)
{
  const Polyhedron cube = unit_cube();
  auto triangles = star_faces(cube);
  BOOST_TEST(!cover_flaw(cube, triangles).has_value());
  std::reverse(triangles.begin(), triangles.end());
  BOOST_TEST(!cover_flaw(cube, triangles).has_value());
  const auto of_third = std::ranges::find(triangles, 3u, &Face_triangle::face);
  of_third->face = 4;  // one of another face
  const auto found = cover_flaw(cube, triangles);
  BOOST_REQUIRE(found.has_value());
  BOOST_TEST(found->face == 3u);
}

BOOST_AUTO_TEST_SUITE_END()
