#include "verify/integer_truth/integer_truth.h"

#include "verify/test/support/object_cases.h"
#include "verify/truth/cgal_truth.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_integer_truth)

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

Meet brute_meet(const Brute_body& a, const Pose& pose_a, const Brute_body& b, const Pose& pose_b)
{
  const Placed_body placed_a(a, pose_a), placed_b(b, pose_b);
  return meet(collide(placed_a, placed_b, Question::solid), collide(placed_a, placed_b, Question::surface));
}

Polyhedron dot(const Vertex& at) { return polygon({at}); }

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
