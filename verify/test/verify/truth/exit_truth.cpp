#include "verify/truth/exit_truth.h"

#include "verify/cases/lego.h"
#include "verify/families/families.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <memory>
#include <utility>

BOOST_AUTO_TEST_SUITE(test_exit_truth)

using namespace tetracone::verify;
using tetracone::kernel::Pose;
using tetracone::kernel::Rational;

namespace {

Object_case of(scenes::Polyhedron a, scenes::Polyhedron b, const Pose& pose_a = Pose())
{
  return {std::make_shared<const scenes::Polyhedron>(std::move(a)),
          std::make_shared<const scenes::Polyhedron>(std::move(b)),
          pose_a,
          Pose(),
          {},
          {},
          {}};
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

BOOST_AUTO_TEST_CASE(normals_of_convex_bodies_say_what_events_do)
{
  scenes::Random random(4);
  const scenes::Polyhedron a = scenes::unit_cube(), b = scenes::tetrahedron({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2});
  for (int round = 0; round < 6; ++round) {
    const Object_case c = of(a, b, scenes::random_rotation(random, 3));
    const std::array<Rational, 3> d = {round - 2, 1, Rational(1, 3)};
    const Rational exit = convex_exit(c, d);
    BOOST_TEST((exits_by_events(c, d) == Solid_exits{exit, exit}));
  }
  BOOST_TEST(convex_exit(of(a, a), {2, 0, 0}) == Rational(1, 2));
  BOOST_TEST(convex_exit(of(a, a, Pose::translation(0, 1, 0)), {2, 0, 0}) == 0);
}

BOOST_AUTO_TEST_CASE(bricks_are_counted_as_events_say)
{
  int counted = 0, overlapping = 0;
  for (std::uint64_t k = 0; k < 40 && counted < 8; ++k) {
    const Object_case c = find_family("lego")->object_case(5, k);
    BOOST_TEST_REQUIRE(c.exits.has_value());
    if (c.a->face_count() + c.b->face_count() > 20) continue;
    ++counted;
    overlapping += c.exits->exits.first > 0;
    BOOST_TEST((exits_by_events(c, c.exits->direction) == c.exits->exits), k);
  }
  BOOST_TEST(counted >= 5);
  BOOST_TEST(overlapping >= 2);
  using lego::block;
  const lego::Bricks low = {{block({0, 0, 0}, {2, 1, 1})}},
                     high = {{block({0, 0, 0}, {1, 1, 1})}, {block({3, 0, 0}, {4, 1, 1})}};
  BOOST_TEST((lego::exits(low, high, {0, 0, 0}, 0, 1) == Solid_exits{1, 4}));
  BOOST_TEST((lego::exits(low, high, {1, 0, 0}, 0, -1) == Solid_exits{Rational(3, 2), Rational(3, 2)}));
  BOOST_TEST((lego::exits(low, high, {-2, 0, 0}, 0, 1) == Solid_exits{0, 0}));
}

BOOST_AUTO_TEST_SUITE_END()
