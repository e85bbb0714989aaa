#include "tetracone/tetratree/scene/world_box.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

BOOST_AUTO_TEST_SUITE(test_world_box)

using namespace tetracone::tetratree;
constexpr double infinity = std::numeric_limits<double>::infinity();

BOOST_AUTO_TEST_CASE(numbers_are_rounded_outward_and_what_is_undefined_is_everything)
{
  for (const double x : {0.0, 1.0, 0.1, -0.1, 1e-300, -1e-300, 0x1p-149, 3e38, -3e38, 1.0 + 0x1p-40}) {
    BOOST_TEST(double(rounded_above(x)) >= x);
    BOOST_TEST(double(rounded_below(x)) <= x);
    BOOST_TEST(double(std::nextafter(rounded_above(x), -World_box::infinity)) < x);
  }
  for (const double x : {1e39, infinity, std::nan("")}) {
    BOOST_TEST(rounded_above(x) == World_box::infinity);
    BOOST_TEST(rounded_below(-x) == -World_box::infinity);
  }
  BOOST_TEST(rounded_below(1e39) == std::numeric_limits<float>::max());
}

BOOST_AUTO_TEST_CASE(boxes_that_touch_meet_and_larger_ones_are_larger)
{
  const World_box a{{0, 0, 0}, {1, 1, 1}}, touching{{1, 1, 1}, {2, 2, 2}}, apart{{1.5f, 0, 0}, {2, 1, 1}}, all;
  BOOST_TEST(a.meets(touching));
  BOOST_TEST(touching.meets(a));
  BOOST_TEST(!a.meets(apart));
  BOOST_TEST(a.farthest(apart) >= std::sqrt(6.0));
  BOOST_TEST(all.meets(apart));
  BOOST_TEST(!all.is_bounded());
  BOOST_TEST(a.is_bounded());
  BOOST_TEST((a.grown(0.25) == World_box{{-0.25f, -0.25f, -0.25f}, {1.25f, 1.25f, 1.25f}}));
  for (int k = 0; k < 3; ++k) BOOST_TEST((a.grown(0x1p-140).low[k] < 0 && a.grown(0x1p-50).high[k] > 1));
}

BOOST_AUTO_TEST_SUITE_END()
