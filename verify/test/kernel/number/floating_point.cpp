#include "tetracone/kernel/number/floating_point.h"

#include "verify/test/support/keep_environment.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_floating_point)

using namespace tetracone::kernel;
using namespace tetracone::verify;

bool is_sound_in_a_new_thread()
{
  bool sound = false;
  std::thread([&sound] { sound = floating_point_is_sound(); }).join();
  return sound;
}

BOOST_AUTO_TEST_CASE(an_environment_that_is_not_sound_is_noticed_and_inherited_by_threads)
{
  int missed = 0;
  in_unsound_environments([&] { missed += int(floating_point_is_sound()) + int(is_sound_in_a_new_thread()); });
  BOOST_TEST(missed == 0);
  BOOST_TEST(floating_point_is_sound());
  BOOST_TEST(is_sound_in_a_new_thread());
}

BOOST_AUTO_TEST_CASE(a_change_in_one_thread_is_no_change_in_another)
{
  std::thread([] { std::fesetround(FE_UPWARD); }).join();
  BOOST_TEST(floating_point_is_sound());
}

BOOST_AUTO_TEST_CASE(what_decides_exactly_refuses_an_environment_that_is_not_sound)
{
  BOOST_CHECK_NO_THROW(require_exact_arithmetic());
  BOOST_TEST(not_refused<Unsound_floating_point>([] { require_sound_floating_point(); }) == 0);
  BOOST_TEST(not_refused<Unsound_floating_point>([] { require_exact_arithmetic(); }) == 0);
}

BOOST_AUTO_TEST_CASE(the_largest_and_the_least_keep_nan_in_any_place_and_order)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (int place = 0; place < 3; ++place) {
    std::array<double, 3> x = {1, infinity, -2};
    x[place] = nan;
    BOOST_TEST(std::isnan(maximum(x[0], x[1], x[2])));
    BOOST_TEST(std::isnan(minimum(x[0], x[1], x[2])));
  }
  for (const auto& [a, b, c] : {std::array{1.0, 2.0, 3.0}, {3.0, 1.0, 2.0}, {2.0, 3.0, 1.0}, {3.0, 2.0, 1.0}}) {
    BOOST_TEST(maximum(a, b, c) == 3);
    BOOST_TEST(minimum(a, b, c) == 1);
  }
  BOOST_TEST(maximum(-infinity, infinity) == infinity);
  BOOST_TEST(minimum(-infinity, infinity) == -infinity);
  BOOST_TEST(maximum(3, -7) == 3);
  BOOST_TEST(minimum(3u, 7u) == 3u);
  BOOST_TEST(maximum(2.5f) == 2.5f);
}

BOOST_AUTO_TEST_CASE(unit_roundoff_is_half_the_step_after_one)
{
  volatile double one = 1;
  BOOST_TEST(one + unit_roundoff<double> == 1);  // a tie, to even
  BOOST_TEST(one + unit_roundoff<double> * (1 + 0x1p-52) > 1);
  BOOST_TEST(unit_roundoff<double> == 0x1p-53);
  BOOST_TEST(unit_roundoff<float> == 0x1p-24f);
}

BOOST_AUTO_TEST_SUITE_END()
