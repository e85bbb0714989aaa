#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "verify/test/support/scenes.h"
#include "verify/truth/brute_body.h"
#include "verify/truth/distance_truth.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>

BOOST_AUTO_TEST_SUITE(test_distances)

using namespace tetracone;
namespace scenes = tetracone::verify::scenes;

BOOST_AUTO_TEST_CASE(the_distance_is_that_of_the_nearest_of_all_pairs)
{
  scenes::Random random(5);
  for (int round = 0; round < 12; ++round) {
    const auto a = scenes::blob(random, 4, 0.5, 1), b = scenes::blob(random, 3, 0.25, 1);
    const kernel::Pose in_a = scenes::random_rotation(random),
                       in_b = scenes::random_rotation(random, 5, {kernel::Rational(7, 3), 0, kernel::Rational(1, 7)});
    const verify::Brute_body of_a(a), of_b(b);
    const kernel::Rational square =
        verify::squared_distance(verify::Placed_body(of_a, in_a), verify::Placed_body(of_b, in_b));
    const Body body_a(a), body_b(b);
    Query query(body_a, body_b, Question::surface);
    const Nearest nearest = query.nearest(in_a, in_b);
    BOOST_TEST(nearest.squared == kernel::exact_text(square));
    BOOST_TEST(query.distance(in_a, in_b) == nearest.distance);
  }
}

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
