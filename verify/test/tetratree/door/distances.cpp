#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>

BOOST_AUTO_TEST_SUITE(test_distances)

using namespace tetracone;
namespace scenes = tetracone::verify::scenes;

BOOST_AUTO_TEST_CASE(a_body_of_no_size_beside_the_other_has_leaves_still)
{
  const Body fine(scenes::triangulated(scenes::torus(24, 24)));
  Query query(fine, fine, Question::surface);
  const double speck = std::ldexp(1.0, -148);
  const Pose flat(std::array<double, 12>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0x1p-142, 0}),
      small(std::array<double, 12>{speck, 0, 0, 0, 0, speck, 0, 0, 0, 0, speck, 0}),
      away = Pose::translation(100, 0, 0);
  for (const Pose& pose : {small, flat}) {
    const Nearest nearest = query.nearest(pose, away);
    BOOST_TEST(nearest.distance > 50);
    BOOST_TEST(query.distance(pose, away) == nearest.distance);
    BOOST_TEST(query.within(pose, away, nearest.distance * (1 + 0x1p-40)));
    BOOST_TEST(!query.within(pose, away, nearest.distance * (1 - 0x1p-40)));
  }
}

BOOST_AUTO_TEST_CASE(no_limit_holds_that_only_overflow_would_grant)
{
  const double s = 0x1p-151;
  const Body body(scenes::tetrahedron({0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, s}));
  const Pose away = Pose::translation(0x1p1000, 0, 0);
  Query query(body, body, Question::surface);
  BOOST_TEST(!query.within(Pose(), away, 0x1p900));
  BOOST_TEST(query.within(Pose(), away, 0x1p1001));
  BOOST_TEST(query.distance(Pose(), away) == 0x1p1000);
}

BOOST_AUTO_TEST_CASE(no_limit_holds_that_only_underflow_would_grant)
{
  const double s = 0x1p-100, h = 0x1p-540;
  const Body below(scenes::tetrahedron({0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, -s})),
      above(scenes::tetrahedron({0, 0, h}, {s, 0, h}, {0, s, h}, {0, 0, s}));
  for (const Kernel kernel : {Kernel::adaptive, Kernel::rational}) {
    Query query(below, above, Question::surface, {.kernel = kernel});
    BOOST_TEST(!query.within(Pose(), Pose(), 0x1p-560));
    BOOST_TEST(query.within(Pose(), Pose(), h));
    BOOST_TEST(query.distance(Pose(), Pose()) == h);
  }
}

BOOST_AUTO_TEST_CASE(doubles_do_not_take_bodies_that_are_tiny_for_touching)
{
  const Body body(scenes::moved(scenes::unit_cube(), 1e-70));
  Query query(body, body, Question::surface, {.kernel = Kernel::double_});
  BOOST_TEST(std::abs(query.distance(Pose(), Pose::translation(1e-60, 0, 0)) / 1e-60 - 1) < 1e-9);
  BOOST_TEST(!query.within(Pose(), Pose::translation(1e-60, 0, 0), 1e-61));
}

BOOST_AUTO_TEST_SUITE_END()
