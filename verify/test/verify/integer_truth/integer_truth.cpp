#include "verify/integer_truth/integer_truth.h"

#include "verify/integer_truth/integer_body.h"
#include "verify/test/support/object_cases.h"
#include "verify/truth/cgal_truth.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_integer_truth)

// Planted by hand, and caught by these tests: the weights of a crossing exchanged; edges between opposite quadrants
// turned the other way, all or those through y only; a coordinate equal to y's counted as more; on_loop ignored; in one
// plane no test at all, or none against the loops; segments_meet without its one-line branch; faces below the point
// counted instead of those above, or as well; heights that ignore where the normal points; only the first part asked;
// no plane for loops that cancel; edges of one body only.

using namespace tetracone::verify;
using namespace tetracone::verify::scenes;
using Random = tetracone::verify::scenes::Random;
using tetracone::kernel::Question;

namespace {

enum class Meet { apart, nested, surface };

std::ostream& operator<<(std::ostream& out, Meet meet)
{
  return out << (meet == Meet::apart ? "apart" : meet == Meet::nested ? "nested" : "surface");
}

Meet meet(bool solid, bool surface)
{
  BOOST_TEST((solid || !surface));
  return surface ? Meet::surface : solid ? Meet::nested : Meet::apart;
}

/// Both ways round, which must agree.
Meet meet(const Polyhedron& a, const Pose& pose_a, const Polyhedron& b, const Pose& pose_b)
{
  const Object_case c = object_case(a, pose_a, b, pose_b), swapped = object_case(b, pose_b, a, pose_a);
  const Meet result = meet(integer_truth::collide(c, Question::solid), integer_truth::collide(c, Question::surface));
  BOOST_TEST(result == meet(integer_truth::collide(swapped, Question::solid),
                            integer_truth::collide(swapped, Question::surface)));
  return result;
}
Meet meet(const Polyhedron& a, const Polyhedron& b) { return meet(a, Pose(), b, Pose()); }

Meet brute_meet(const Brute_body& a, const Pose& pose_a, const Brute_body& b, const Pose& pose_b)
{
  const Placed_body placed_a(a, pose_a), placed_b(b, pose_b);
  return meet(collide(placed_a, placed_b, Question::solid), collide(placed_a, placed_b, Question::surface));
}

Polyhedron dot(const Vertex& at) { return polygon({at}); }
/// An edge there and back.
Polyhedron stick(const Vertex& from, const Vertex& to) { return polygon({from, to}); }

/// A pose of any kind, its translations on a grid of halves.
Pose any_pose(Random& random, int reach)
{
  const auto half = [&]() -> Rational { return Rational(integer(random, -2 * reach, 2 * reach)) / 2; };
  const auto shift = [&] { return integer(random, -2 * reach, 2 * reach) / 2.0; };
  switch (integer(random, 0, 4)) {
    case 0: return translation(shift(), shift(), shift());
    case 1: return random_rotation(random, 3, {half(), half(), half()});
    case 2: return rounded(random_rotation(random, 3, {half(), half(), half()}));
    case 3: return composed(translation(shift(), shift(), shift()), random_affine(random, 1));
    default: return random_rotation(random, 1, {Rational(half() / 3), Rational(half() / 3), Rational(half() / 3)});
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(touching_counts_and_a_gap_of_an_ulp_does_not)
{
  const Polyhedron cube = unit_cube();
  const double above = std::nextafter(1.0, 2.0);
  for (const auto& [x, y, z] : {Vertex{1, 1, 1}, {1, 1, 0.25}, {1, -0.25, 0.5}, {-1, 0, 0}, {0.5, 0.5, 0.5}, {0, 0, 0}})
    BOOST_TEST(meet(cube, Pose(), cube, translation(x, y, z)) == Meet::surface);
  for (const auto& [x, y, z] : {Vertex{above, 1, 1}, {1, above, 0.25}, {above, -0.25, 0.5}, {-above, 0, 0}})
    BOOST_TEST(meet(cube, Pose(), cube, translation(x, y, z)) == Meet::apart);
}

BOOST_AUTO_TEST_CASE(containment_makes_solids_meet_and_cavities_do_not)
{
  BOOST_TEST(meet(cube(2), cube(1)) == Meet::nested);
  BOOST_TEST(meet(turned(cube(2)), cube(1)) == Meet::nested);
  BOOST_TEST(meet(cube_with_cavity(), cube(1)) == Meet::apart);
  BOOST_TEST(meet(cube_with_cavity(), cube(2)) == Meet::surface);
  BOOST_TEST(meet(with_cavity(cube(3), turned(cube(2))), cube(1)) == Meet::nested);
  BOOST_TEST(meet(cube_with_tunnel(), box({-0.5, -0.5, -9}, {0.5, 0.5, 9})) == Meet::apart);
  BOOST_TEST(meet(cube_with_tunnel(), box({-1, -0.5, -9}, {0.5, 0.5, 9})) == Meet::surface);
  BOOST_TEST(meet(cube_with_tunnel(), box({1.5, -0.5, -1}, {2, 0.5, 1})) == Meet::nested);
  // One part of many is enough.
  Polyhedron many = moved(cube(1), 1, {9, 0, 0});
  append(many, moved(cube(1), 1, {0, 9, 0}));
  append(many, moved(cube(0.5), 1, {0, 0, 0}));
  BOOST_TEST(meet(cube(2), many) == Meet::nested);
}

BOOST_AUTO_TEST_CASE(a_hole_is_a_part_of_its_own)
{
  // A face with a hole whose loop alone is over a vertex of the other body; both loops doubled, so that nothing is
  // enclosed.
  Polyhedron sheet = holed_square(4, 1);
  sheet.add_face({{3, 2, 1, 0}, {4, 5, 6, 7}});
  BOOST_TEST(meet(sheet, stick({0, 0, -1}, {0, 0, 1})) == Meet::apart);
  BOOST_TEST(meet(sheet, stick({1, 0, -1}, {1, 0, 1})) == Meet::surface);
  BOOST_TEST(meet(sheet, stick({2, 2, -1}, {3, 1, 1})) == Meet::surface);
  BOOST_TEST(meet(sheet, stick({0, 0, 0}, {0.5, 0.5, 0})) == Meet::apart);
  BOOST_TEST(meet(sheet, stick({0, 0, 0}, {1, 0.5, 0})) == Meet::surface);
  BOOST_TEST(meet(sheet, stick({2, 2, 0}, {3, 2, 0})) == Meet::surface);
  BOOST_TEST(meet(sheet, stick({-9, 2, 0}, {9, 2, 0})) == Meet::surface);
}

BOOST_AUTO_TEST_CASE(points_and_sticks_are_polyhedra)
{
  BOOST_TEST(meet(dot({1, 2, 3}), dot({1, 2, 3})) == Meet::surface);
  BOOST_TEST(meet(dot({1, 2, 3}), dot({1, 2, 4})) == Meet::apart);
  BOOST_TEST(meet(dot({0, 0, 0}), cube(1)) == Meet::nested);
  BOOST_TEST(meet(dot({1, 1, 1}), cube(1)) == Meet::surface);
  BOOST_TEST(meet(dot({1, 0.5, 0.25}), cube(1)) == Meet::surface);
  BOOST_TEST(meet(dot({1, 0.5, 1.25}), cube(1)) == Meet::apart);
  BOOST_TEST(meet(dot({1, 1, 1}), stick({0, 0, 0}, {3, 3, 3})) == Meet::surface);
  BOOST_TEST(meet(dot({1, 1, 2}), stick({0, 0, 0}, {3, 3, 3})) == Meet::apart);
  BOOST_TEST(meet(dot({4, 4, 4}), stick({0, 0, 0}, {3, 3, 3})) == Meet::apart);
  BOOST_TEST(meet(stick({0, 0, 0}, {3, 3, 3}), stick({3, 0, 0}, {0, 3, 3})) == Meet::surface);
  BOOST_TEST(meet(stick({0, 0, 0}, {3, 3, 3}), stick({3, 0, 0}, {0, 3, 2})) == Meet::apart);
  BOOST_TEST(meet(stick({0, 0, 0}, {1, 1, 1}), stick({1, 1, 1}, {2, 2, 2})) == Meet::surface);
  BOOST_TEST(meet(stick({0, 0, 0}, {1, 1, 1}), stick({5, 5, 5}, {2, 2, 2})) == Meet::apart);
  BOOST_TEST(meet(stick({0, 0, 0}, {1, 1, 1}), stick({5, 5, 5}, {-2, -2, -2})) == Meet::surface);
  BOOST_TEST(meet(stick({-0.5, 0, 0}, {0.5, 0.25, 0}), cube(1)) == Meet::nested);
  BOOST_TEST(meet(stick({2, 0, 0}, {0.5, 0.25, 0}), cube(1)) == Meet::surface);
}

BOOST_AUTO_TEST_CASE(no_magnitude_is_too_large_or_too_small)
{
  const double largest = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  const Polyhedron tiny = box({0, 0, 0}, {least, least, least}), huge = box({0, 0, 0}, {largest, largest, largest});
  BOOST_TEST(meet(tiny, Pose(), tiny, translation(least, 0, 0)) == Meet::surface);
  BOOST_TEST(meet(tiny, Pose(), tiny, translation(2 * least, 0, 0)) == Meet::apart);
  BOOST_TEST(meet(huge, tiny) == Meet::surface);
  BOOST_TEST(meet(huge, Pose(), tiny, translation(1, 1, 1)) == Meet::nested);
  BOOST_TEST(meet(huge, Pose(), tiny, translation(-2 * least, 0, 0)) == Meet::apart);
  BOOST_TEST(meet(huge, Pose(), huge, translation(largest, 0, 0)) == Meet::surface);
}

BOOST_AUTO_TEST_CASE(turns_are_winding_numbers_and_know_their_loops)
{
  // The square twice around, and a point moved by (e, e^2) on its border.
  Polyhedron square;
  square.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  square.add_polygon({0, 1, 2, 3, 0, 1, 2, 3});
  square.add_polygon({3, 2, 1, 0});
  const Integer_body body(square, placed(square.vertices, Pose()).points);
  const auto at = [&](Index f, int x, int y) {
    const Turns turns = body.turns(f, 2, {x, y, 0}, 2);
    return std::pair(turns.on_loop, turns.winding);
  };
  BOOST_TEST((at(0, 3, 5) == std::pair(false, 2)));
  BOOST_TEST((at(1, 3, 5) == std::pair(false, -1)));
  BOOST_TEST((at(0, 9, 5) == std::pair(false, 0)));
  BOOST_TEST((at(0, 0, 0) == std::pair(true, 2)));
  BOOST_TEST((at(0, 8, 0) == std::pair(true, 0)));
  BOOST_TEST((at(0, 0, 8) == std::pair(true, 0)));
  BOOST_TEST((at(0, 8, 8) == std::pair(true, 0)));
  BOOST_TEST((at(0, 0, 5) == std::pair(true, 2)));
  BOOST_TEST((at(0, 8, 5) == std::pair(true, 0)));
  BOOST_TEST((at(1, 3, 0) == std::pair(true, -1)));
  BOOST_TEST((at(1, 3, 8) == std::pair(true, 0)));
  BOOST_TEST((at(0, -1, 0) == std::pair(false, 0)));
  BOOST_TEST((at(0, 9, 8) == std::pair(false, 0)));
}

BOOST_AUTO_TEST_CASE(closed_bodies_of_every_kind_meet_as_in_cgals_rationals)
{
  Random random(1);
  const std::vector<Named> bodies = closed_bodies();
  std::vector<Brute_body> brute;
  for (const Named& named : bodies) brute.emplace_back(named.body);
  std::array<int, 3> seen{};
  for (int k = 0; k < 1500; ++k) {
    const std::size_t i = integer(random, 0, int(bodies.size()) - 1), j = integer(random, 0, int(bodies.size()) - 1);
    const Pose pose_a = any_pose(random, 1);
    Pose pose_b = any_pose(random, k % 2 == 0 ? 1 : 4);
    if (k % 2 == 0) {  // smaller, so that it fits into the other or its cavity
      const double s = 0.125;
      pose_b = composed(pose_b, Pose(std::array<double, 12>{s, 0, 0, 0, 0, s, 0, 0, 0, 0, s, 0}));
    }
    const Meet truth = brute_meet(brute[i], pose_a, brute[j], pose_b);
    BOOST_TEST_CONTEXT(k << ": " << bodies[i].name << ", " << bodies[j].name)
    BOOST_TEST(meet(bodies[i].body, pose_a, bodies[j].body, pose_b) == truth);
    ++seen[int(truth)];
  }
  for (const int count : seen) BOOST_TEST(count > 100);
}

BOOST_AUTO_TEST_CASE(small_tetrahedra_meet_as_in_cgals_rationals)
{
  // On a grid so small that most contacts are degenerate; some of the tetrahedra are flat, some are lines.
  Random random(2);
  std::array<int, 3> seen{};
  for (int k = 0; k < 2500; ++k) {
    const Polyhedron a = random_tetrahedra(random, 1 + k % 2, 2), b = random_tetrahedra(random, 1, 1 + k % 3);
    const Pose pose = k % 4 == 0 ? any_pose(random, 1) : Pose();
    const Meet truth = brute_meet(Brute_body(a), Pose(), Brute_body(b), pose);
    BOOST_TEST_CONTEXT(k)
    BOOST_TEST(meet(a, Pose(), b, pose) == truth);
    ++seen[int(truth)];
  }
  BOOST_TEST(seen[int(Meet::apart)] > 500);
  BOOST_TEST(seen[int(Meet::surface)] > 500);
}

BOOST_AUTO_TEST_CASE(faces_of_any_loops_meet_as_in_cgals_rationals)
{
  Random random(3);
  int meeting = 0, apart = 0;
  for (int k = 0; k < 2500; ++k) {
    const Polyhedron a = any_loops(random, 2), b = any_loops(random, 2);
    const Pose pose_a = k % 3 == 0 ? random_rotation(random, 2) : Pose();
    const Pose pose_b = k % 2 == 0 ? composed(pose_a, translation(integer(random, -1, 1), 0, 0)) : any_pose(random, 1);
    const bool truth = collide(Brute_body(a), pose_a, Brute_body(b), pose_b, Question::surface);
    BOOST_TEST_CONTEXT(k)
    BOOST_TEST(integer_truth::collide(object_case(a, pose_a, b, pose_b), Question::surface) == truth);
    ++(truth ? meeting : apart);
  }
  BOOST_TEST(meeting > 500);
  BOOST_TEST(apart > 500);
}

BOOST_AUTO_TEST_CASE(points_are_in_voxel_solids_where_their_cells_are_full)
{
  // Points of the grid of halves: the vertical ray runs through vertices, along edges and in faces.
  Random random(4);
  for (int k = 0; k < 3; ++k) {
    const Voxels voxels(random, 3);
    const Polyhedron solid = voxels.solid();
    for (int x = -1; x <= 7; ++x)
      for (int y = -1; y <= 7; ++y)
        for (int z = -1; z <= 7; ++z) {
          const Object_case c = object_case(solid, Pose(), dot({x / 2.0, y / 2.0, z / 2.0}), Pose());
          const int where = voxels.where(x, y, z);
          BOOST_TEST(integer_truth::collide(c, Question::surface) == (where == 0));
          BOOST_TEST(integer_truth::collide(c, Question::solid) == (where >= 0));
        }
  }
}

BOOST_AUTO_TEST_SUITE_END()
