#include "tetracone/kernel/simd/short_vectors.h"

#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_short_vectors)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

constexpr double infinity = std::numeric_limits<double>::infinity(),
                 undefined = std::numeric_limits<double>::quiet_NaN();

/// Numbers of every size, and those at the ends of the ranges of both types.
std::vector<double> numbers(Random& random)
{
  std::vector<double> all = {0.0,
                             -0.0,
                             1.0,
                             -1.0,
                             infinity,
                             -infinity,
                             undefined,
                             -undefined,
                             5e-324,
                             -5e-324,
                             0x1p-149,
                             -0x1p-150,
                             0x1.8p-150,
                             0x1p-126,
                             0x1.fffffep127,
                             -0x1.ffffffp127,
                             0x1.fffffefp127,
                             1 + 0x1p-24,
                             1 + 0x1p-24 + 0x1p-50,
                             1 + 0x1.8p-23,
                             std::numeric_limits<double>::max()};
  while (all.size() < 1000) all.push_back(std::ldexp(real(random, -1, 1), integer(random, -160, 135)));
  return all;
}

bool same(double x, double y) { return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y); }
bool same(float x, float y) { return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y); }

BOOST_AUTO_TEST_CASE(what_is_loaded_is_rounded_to_nearest_and_magnitudes_lose_the_sign_alone)
{
  Random random(1);
  const auto all = numbers(random);
  int wrong = 0;
  for (std::size_t k = 0; k + 4 <= all.size(); ++k) {  // from any place in memory
    const Two_doubles two = two_from(&all[k]), of_two = magnitudes(two);
    const Four_floats four = rounded(two, two_from(&all[k + 2])), of_four = magnitudes(four), three = first_three(four);
    for (int i = 0; i < 4; ++i) {
      const float nearest = float(all[k + i]);
      wrong += std::isnan(nearest) ? !std::isnan(four[i]) : !same(four[i], nearest);
      wrong += std::signbit(of_four[i]) || (!std::isnan(nearest) && !same(of_four[i], std::abs(nearest)));
      wrong += !same(three[i], i == 3 ? 0 : four[i]);
    }
    wrong += !same(repeated<1>(four)[3], four[1]) || !same(repeated<2>(four)[0], four[2]);
    for (int i = 0; i < 2; ++i)
      wrong += !same(two[i], all[k + i]) || std::signbit(of_two[i]) || !same(std::abs(of_two[i]), std::abs(all[k + i]));
  }
  BOOST_TEST(wrong == 0);
}

BOOST_AUTO_TEST_CASE(every_lane_has_the_sum_of_pairs)
{
  Random random(2);
  int wrong = 0;
  for (int k = 0; k < 1000; ++k) {
    std::array<float, 4> v;
    for (float& x : v) x = std::ldexp(float(real(random, -1, 1)), integer(random, -30, 30));
    const float sum = (v[0] + v[1]) + (v[2] + v[3]);
    const Four_floats found = sum_of_lanes(Four_floats{v[0], v[1], v[2], v[3]});
    for (int i = 0; i < 4; ++i) wrong += !same(found[i], sum);
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(sum_of_lanes(Four_floats{1, 2, 4, 8})[3] == 15);
  for (int i = 0; i < 4; ++i) BOOST_TEST(sum_of_lanes(Four_ints{1, -2, 40000, 80000})[i] == 119999);
  BOOST_TEST(std::isnan(sum_of_lanes(
      Four_floats{1, std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(), 0})[0]));
}

BOOST_AUTO_TEST_SUITE_END()
