#include "tetracone/kernel/predicate/frame.h"

#include "verify/test/support/kernel_test_case.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_frame)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

using Kernels = std::tuple<Float, Double, Tolerant, Epick, Epeck, Rational_kernel, Adaptive>;
using Wide_kernels = std::tuple<Double, Tolerant, Epick, Epeck, Rational_kernel, Adaptive>;
using Rounded_motions = std::tuple<Float, Double, Tolerant, Epick>;

template <class K>
std::array<Rational, 3> exactly(const Point<K>& p)
{
  const auto number = [](const auto& x) {
    if constexpr (std::is_same_v<K, Epeck>)
      return Rational(CGAL::exact(x));
    else
      return Rational(x);
  };
  return {number(p.x()), number(p.y()), number(p.z())};
}

rationals::Vector exact_image(const Pose& pose, const Vertex& v)
{
  return rationals::image(pose, rationals::exactly(v));
}

/// Any entries, of which some make no similarity.
Pose any_doubles(Random& random)
{
  std::array<double, 12> entries;
  for (double& e : entries) e = real(random, -10, 10);
  return Pose(entries);
}
Pose fractions(Random& random)
{
  return random_rotation(random, 4, {Rational(integer(random, -4, 4)) / 7, 1, Rational(0.1)});
}

KERNEL_TEST_CASE(a_vertex_is_taken_exactly, K, Wide_kernels)
{
  for (const Vertex& v : {Vertex{0.1, -1.0 / 3, 0x1p-1074}, Vertex{1e300, -0.0, 0x1p-1022}}) {
    const auto image = exactly<K>(point<K>(v));
    for (int i = 0; i < 3; ++i) BOOST_TEST((image[i] == Rational(v[i])));
  }
}

BOOST_AUTO_TEST_CASE(float_takes_the_nearest_float_of_a_vertex)
{
  const auto p = point<Float>({0.1, 1 + 0x1p-30, -1.0 / 3});
  BOOST_TEST(p.x() == 0.1f);
  BOOST_TEST(p.y() == 1.0f);
  BOOST_TEST(p.z() == -1.0f / 3);
}

KERNEL_TEST_CASE(the_identity_returns_every_point_unchanged, K, Kernels)
{
  const Pose pose;
  const Frame<K> frame(pose);
  BOOST_TEST(frame.is_identity());
  const auto p = point<K>({0.1, 1e30, -1.0 / 3}), image = frame(p);
  BOOST_TEST((exactly<K>(image) == exactly<K>(p)));
  BOOST_TEST(coincide<K>(image, p));
  BOOST_TEST(!Frame<K>(Pose(std::array<double, 12>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1})).is_identity());
}

KERNEL_TEST_CASE(rounded_motion_is_the_expression_in_its_own_numbers, K, Rounded_motions)
{
  Random random(3);
  int inexact = 0;
  for (int n = 0; n < 1'000; ++n) {
    const Pose pose = n % 2 == 0 ? any_doubles(random) : fractions(random);
    const Vertex v = real_vertex(random, 10);
    const auto placed = Frame<K>(pose)(point<K>(v));
    using Number = std::remove_cvref_t<decltype(placed[0])>;
    for (int i = 0; i < 3; ++i) {
      const auto m = [&](int k) { return Number(pose[4 * i + k]); };
      const Number expected = ((m(0) * Number(v[0]) + m(1) * Number(v[1])) + m(2) * Number(v[2])) + m(3);
      BOOST_TEST(placed[i] == expected);
      inexact += Rational(expected) != exact_image(pose, v)[i];
    }
  }
  BOOST_TEST(inexact > 1'000);
}

BOOST_AUTO_TEST_SUITE_END()
