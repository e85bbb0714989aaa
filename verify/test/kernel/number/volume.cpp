#include "tetracone/kernel/number/volume.h"

#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_volume)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

Rational exact_determinant(const Vertex& o, const Vertex& a, const Vertex& b, const Vertex& c)
{
  using rationals::exactly;
  return rationals::six_volume(exactly(o), exactly(a), exactly(b), exactly(c));
}

BOOST_AUTO_TEST_CASE(sums_are_exact_at_every_scale_and_mixture_of_scales)
{
  Random random(1);
  Volume_sum sum;
  Rational truth = 0;
  int wrong = 0;
  for (int n = 0; n < 300; ++n) {
    std::array<Vertex, 4> v;
    for (Vertex& p : v) {
      p = real_vertex(random, 1);
      for (double& x : p) x = std::ldexp(x, n < 100 ? 0 : integer(random, -1074, 1023));
    }
    if (n % 7 == 0) v[3] = v[2];
    sum.add(v[0], v[1], v[2], v[3]);
    truth += exact_determinant(v[0], v[1], v[2], v[3]);
    wrong += sum.value() != truth;
  }
  BOOST_TEST(wrong == 0);
}

BOOST_AUTO_TEST_CASE(the_ends_of_the_range_of_double_are_exact)
{
  for (const double scale : {0x1p-1074, 0x1.8p-1023, 0x1.fffffffffffffp1023}) {
    Volume_sum sum;
    sum.add({0, 0, 0}, {scale, 0, 0}, {0, scale, 0}, {0, 0, scale});
    BOOST_TEST((sum.value() == Rational(scale) * Rational(scale) * Rational(scale)));
    sum.add({-scale, -scale, -scale}, {scale, 0, 0}, {0, scale, 0}, {0, 0, scale});
    BOOST_TEST((sum.value() == 5 * Rational(scale) * Rational(scale) * Rational(scale)));
  }
}

BOOST_AUTO_TEST_SUITE_END()
