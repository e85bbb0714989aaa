#include "verify/truth/motion_truth.h"

#include "tetracone/kernel/motion/first_contact.h"
#include "verify/families/motion_families.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

BOOST_AUTO_TEST_SUITE(test_motion_truth)

using namespace tetracone::verify;
using tetracone::kernel::first_contact_time;
using tetracone::kernel::meet_in_motion;
using tetracone::kernel::Moving_kind;
using tetracone::kernel::Moving_pair;
using tetracone::kernel::Rational;
using tetracone::kernel::Time_bounds;

namespace {

/// A vertex that falls from z = 1 to z = -2 through a resting face.
Moving_pair falling(double x, double y)
{
  return {Moving_kind::vertex_face,
          {{{{x, y, 1}, {x, y, -2}}, {{0, 0, 0}, {0, 0, 0}}, {{1, 0, 0}, {1, 0, 0}}, {{0, 1, 0}, {0, 1, 0}}}}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_truth_knows_spans_of_time_and_their_ends)
{
  const Rational third = Rational(1) / 3;
  BOOST_TEST(truly_meet_in_motion(falling(0.5, 0.5)));
  BOOST_TEST(!truly_meet_in_motion(falling(0.5, std::nextafter(0.5, 1))));
  BOOST_TEST(truly_meet_at(falling(0, 0), third));
  BOOST_TEST(!truly_meet_at(falling(0, 0), Rational(1) / 2));
  BOOST_TEST(!truly_meet_in_motion(falling(0, 0), {0, third, false}));
  BOOST_TEST(truly_meet_in_motion(falling(0, 0), {0, third, true}));
  BOOST_TEST(truly_meet_in_motion(falling(0, 0), {third, 1, true}));
  BOOST_TEST(!truly_meet_in_motion(falling(0, 0), {Rational(1) / 2, 1, true}));
}

BOOST_AUTO_TEST_CASE(wrong_first_times_are_noticed)
{
  const Moving_pair pair = falling(0.25, 0.25);
  const double below = 1.0 / 3, above = std::nextafter(below, 1);
  BOOST_TEST(truly_first(pair, Time_bounds{below, above}, true));
  BOOST_TEST(!truly_first(pair, Time_bounds{below, below}, true));
  BOOST_TEST(!truly_first(pair, Time_bounds{above, std::nextafter(above, 1)}, true));
  BOOST_TEST(!truly_first(pair, Time_bounds{std::nextafter(below, 0), below}, true));
  BOOST_TEST(!truly_first(pair, Time_bounds{std::nextafter(below, 0), above}, true));
  BOOST_TEST(!truly_first(pair, std::nullopt, true));
  BOOST_TEST(truly_first(falling(2, 2), std::nullopt, false));
  BOOST_TEST(!truly_first(falling(2, 2), Time_bounds{0, 0}, false));
}

BOOST_AUTO_TEST_CASE(answers_and_first_times_of_every_family_are_the_truth)
{
  for (const Motion_family& family : motion_families()) {
    int contacts = 0;
    for (std::uint64_t k = 0; k < 60; ++k) {
      const Moving_pair pair = motion_case(family, 7, k);
      const bool truth = truly_meet_in_motion(pair);
      contacts += truth;
      BOOST_TEST(meet_in_motion(pair) == truth, std::string(family.name) + " " + std::to_string(k));
      BOOST_TEST(truly_first(pair, first_contact_time(pair), truth),
                 std::string(family.name) + " " + std::to_string(k));
    }
    // Both answers are met.
    BOOST_TEST(contacts > 0, std::string(family.name));
    BOOST_TEST(contacts < 60, std::string(family.name));
  }
}

BOOST_AUTO_TEST_SUITE_END()
