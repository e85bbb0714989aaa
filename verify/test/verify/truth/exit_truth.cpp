#include "verify/truth/exit_truth.h"

#include "verify/cases/lego.h"
#include "verify/test/support/object_cases.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_exit_truth)

using namespace tetracone::verify;
using tetracone::kernel::Pose;
using tetracone::kernel::Rational;

namespace {

Object_case of(const scenes::Polyhedron& a, const scenes::Polyhedron& b, const Pose& pose_a = Pose())
{
  return scenes::object_case(a, pose_a, b, Pose());
}

}  // namespace

BOOST_AUTO_TEST_CASE(events_tell_where_boxes_part_and_meet_again)
{
  const scenes::Polyhedron unit = scenes::unit_cube();
  BOOST_TEST((exits_by_events(of(unit, unit), {2, 0, 0}) == Solid_exits{Rational(1, 2), Rational(1, 2)}));
  BOOST_TEST((exits_by_events(of(unit, unit, Pose::translation(1, 0, 0)), {-1, 0, 0}) == Solid_exits{0, 0}));
  scenes::Polyhedron gap = scenes::box({0, 0, 0}, {1, 1, 1});
  append(gap, scenes::box({3, 0, 0}, {4, 1, 1}));
  BOOST_TEST((exits_by_events(of(unit, gap), {1, 0, 0}) == Solid_exits{1, 4}));
  // As wide as the gap: it touches both sides.
  BOOST_TEST((exits_by_events(of(scenes::box({0, 0, 0}, {2, 1, 1}), gap), {1, 0, 0}) == Solid_exits{1, 4}));
}

BOOST_AUTO_TEST_CASE(normals_of_convex_bodies_say_where_they_part)
{
  const scenes::Polyhedron a = scenes::unit_cube();
  BOOST_TEST(convex_exit(of(a, a), {2, 0, 0}) == Rational(1, 2));
  BOOST_TEST(convex_exit(of(a, a, Pose::translation(0, 1, 0)), {2, 0, 0}) == 0);
}

BOOST_AUTO_TEST_CASE(minkowski_sums_know_the_depths_of_convex_bodies_and_of_cells)
{
  const scenes::Polyhedron a = scenes::unit_cube();
  BOOST_TEST(*minkowski_squared_depth(of(a, a, Pose::translation(1, 0, 0))) == 0);

  // A slot two cells wide and two deep, and a peg that fits it and is half a cell below its floor.
  lego::Cells slot = lego::block({-3, 0, 0}, {3, 3, 2});
  for (const lego::Cell& cell : lego::block({-1, 1, 0}, {1, 3, 2})) slot.erase(cell);
  const lego::Bricks solid = {{slot}}, peg = {{lego::block({-1, 1, 0}, {1, 3, 2})}};
  Random division(1);
  const auto body = [&](const lego::Bricks& bricks) { return lego::solid(bricks, {1, 0, true, true}, division); };
  const Object_case fits = of(body(peg), body(solid), Pose::translation(0, -0.5, 0));
  BOOST_TEST(*minkowski_squared_depth(fits) == Rational(1, 4));
  BOOST_TEST(lego::squared_depth(peg, solid, {0, 1, 0}) == Rational(1, 4));

  // Two shells are refused.
  scenes::Polyhedron two = a;
  append(two, scenes::box({3, 0, 0}, {4, 1, 1}));
  BOOST_TEST(!minkowski_squared_depth(of(a, two)));
}

BOOST_AUTO_TEST_SUITE_END()
