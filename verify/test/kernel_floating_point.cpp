#include "kernel/floating_point.h"

#include <boost/test/unit_test.hpp>

#include <cfenv>
#include <thread>

using tetracone::kernel::floating_point_is_sound;
using tetracone::kernel::unit_roundoff;

namespace {

/// The calling thread's floating point as it was, at the end of the scope.
class Keep_environment {
 public:
  Keep_environment() { std::fegetenv(&environment_); }
  ~Keep_environment() { std::fesetenv(&environment_); }
  Keep_environment(const Keep_environment&) = delete;

 private:
  std::fenv_t environment_;
};

bool is_sound_in_a_new_thread()
{
  bool sound = false;
  std::thread([&sound] { sound = floating_point_is_sound(); }).join();
  return sound;
}

}  // namespace

BOOST_AUTO_TEST_CASE(floating_point_is_sound_by_default)
{
  BOOST_TEST(floating_point_is_sound());
  BOOST_TEST(is_sound_in_a_new_thread());
}

BOOST_AUTO_TEST_CASE(each_directed_rounding_is_noticed_and_inherited_by_threads)
{
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    const Keep_environment keep;
    BOOST_REQUIRE(std::fesetround(mode) == 0);
    const bool here = floating_point_is_sound(), there = is_sound_in_a_new_thread();
    std::fesetround(FE_TONEAREST);  // Boost.Test prints numbers
    BOOST_TEST(!here);
    BOOST_TEST(!there);
  }
  BOOST_TEST(floating_point_is_sound());
}

#if defined(__SSE2__)
BOOST_AUTO_TEST_CASE(flush_to_zero_and_denormals_are_zero_are_noticed_and_inherited_by_threads)
{
  for (const unsigned bits : {0x8000u, 0x0040u, 0x8040u}) {
    const Keep_environment keep;
    _mm_setcsr(_mm_getcsr() | bits);
    const bool here = floating_point_is_sound(), there = is_sound_in_a_new_thread();
    BOOST_TEST(!here);
    BOOST_TEST(!there);
  }
  BOOST_TEST(floating_point_is_sound());
}
#endif

BOOST_AUTO_TEST_CASE(a_change_in_one_thread_is_no_change_in_another)
{
  std::thread([] { std::fesetround(FE_UPWARD); }).join();
  BOOST_TEST(floating_point_is_sound());
}

BOOST_AUTO_TEST_CASE(unit_roundoff_is_half_the_step_after_one)
{
  volatile double one = 1;
  BOOST_TEST(one + unit_roundoff<double> == 1);  // a tie, to even
  BOOST_TEST(one + unit_roundoff<double> * (1 + 0x1p-52) > 1);
  BOOST_TEST(unit_roundoff<double> == 0x1p-53);
  BOOST_TEST(unit_roundoff<float> == 0x1p-24f);
}
