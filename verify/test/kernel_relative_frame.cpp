#include "kernel/relative_frame.h"

#include "verify/test/scenes.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>

using namespace tetracone::kernel;
namespace scenes = tetracone::verify::scenes;
using scenes::Random;

namespace {

using Row = std::array<Rational, 3>;

Row solve(const Pose& a, const Row& right)
{
  const auto m = [&](int i, int j) { return a.exact(4 * i + j); };
  const auto determinant = [](const std::array<Row, 3>& c) -> Rational {
    return c[0][0] * (c[1][1] * c[2][2] - c[1][2] * c[2][1]) - c[1][0] * (c[0][1] * c[2][2] - c[0][2] * c[2][1]) + c[2][0] * (c[0][1] * c[1][2] - c[0][2] * c[1][1]);
  };
  std::array<Row, 3> columns;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) columns[j][i] = m(i, j);
  const Rational whole = determinant(columns);
  Row x;
  for (int j = 0; j < 3; ++j) {
    auto replaced = columns;
    replaced[j] = right;
    x[j] = determinant(replaced) / whole;
  }
  return x;
}

/// The exact image of a local point, by Cramer's rule.
Row exact(const Pose& a, const Local_units& in_a, const Pose& b, const Local_units& in_b, const Vertex& p)
{
  Row world;
  for (int i = 0; i < 3; ++i) {
    world[i] = b.exact(4 * i + 3) - a.exact(4 * i + 3);
    for (int j = 0; j < 3; ++j) world[i] += b.exact(4 * i + j) * (Rational(in_b.origin[j]) + Rational(in_b.unit) * Rational(p[j]));
  }
  Row local = solve(a, world);
  for (int i = 0; i < 3; ++i) local[i] = (local[i] - Rational(in_a.origin[i])) / Rational(in_a.unit);
  return local;
}

Pose any_pose(Random& random, int kind)
{
  switch (kind % 6) {
    case 0: return Pose();
    case 1: return scenes::random_rotation(random);
    case 2: return scenes::rounded(scenes::random_rotation(random));
    case 3: return scenes::random_affine(random);
    case 4: {  // far away
      Pose pose = scenes::rounded(scenes::random_rotation(random));
      auto entries = pose.entries();
      for (int i = 0; i < 3; ++i) entries[4 * i + 3] = std::ldexp(1.0, 40) * (1 + i);
      return Pose(entries);
    }
    default: {  // nearly flat
      auto entries = Pose().entries();
      for (int j = 0; j < 3; ++j) entries[8 + j] = entries[j] + std::ldexp(double(int(random() % 5) - 2), -20);
      entries[10] += 0x1p-12;
      return Pose(entries);
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(no_image_is_farther_off_than_the_error_says)
{
  Random random(4);
  double worst = 0;
  int known = 0;
  for (int k = 0; k < 3600; ++k) {
    const Pose a = any_pose(random, k), b = any_pose(random, k / 6);
    if (a.determinant_sign() == CGAL::ZERO) continue;
    const Local_units in_a{scenes::real_vertex(random, k % 5 == 0 ? 1e9 : 2), std::ldexp(1.0, int(random() % 9) - 4)};
    const Local_units in_b{scenes::real_vertex(random, 3), std::ldexp(1.0, int(random() % 9) - 4)};
    const Relative_frame frame(a, in_a, b, in_b);
    const Vertex p = scenes::real_vertex(random, 1);
    const auto image = frame(p);
    const Row right = exact(a, in_a, b, in_b, p);
    if (!(frame.error() < HUGE_VAL)) continue;
    ++known;
    for (int i = 0; i < 3; ++i) worst = std::max(worst, std::abs(nearest_double(Rational(Rational(image[i]) - right[i]))) / frame.error());
  }
  BOOST_TEST_MESSAGE("largest error / bound: " << worst << " over " << known);
  BOOST_TEST(known > 3000);
  BOOST_TEST(worst <= 1);
  BOOST_TEST(worst > 0.001);
}

BOOST_AUTO_TEST_CASE(rotations_are_similarities_and_shears_are_not)
{
  Random random(5);
  for (int k = 0; k < 200; ++k) {
    const Pose a = scenes::random_rotation(random), b = scenes::rounded(scenes::random_rotation(random));
    BOOST_TEST(Relative_frame(a, {}, b, {}).is_similarity());
    BOOST_TEST(Relative_frame(b, {}, a, {}).is_similarity());
  }
  BOOST_TEST(Relative_frame(Pose(std::array<double, 12>{2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0}), {}, Pose(), {}).is_similarity());
  BOOST_TEST(!Relative_frame(Pose(std::array<double, 12>{1, 0.5, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}), {}, Pose(), {}).is_similarity());
  BOOST_TEST(!Relative_frame(Pose(), {}, Pose(std::array<double, 12>{1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1, 0}), {}).is_similarity());
}

BOOST_AUTO_TEST_CASE(what_cannot_be_bounded_is_said_to_be_unknown)
{
  const double tiny = 0x1p-300, huge = 0x1p300;
  for (const Pose& pose : {Pose(std::array<double, 12>{tiny, 0, 0, 0, 0, tiny, 0, 0, 0, 0, tiny, 0}), Pose(std::array<double, 12>{huge, 0, 0, 0, 0, huge, 0, 0, 0, 0, huge, 0}),
                           Pose(std::array<double, 12>{1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0x1p-60, 0})})
    BOOST_TEST(std::isinf(Relative_frame(pose, {}, Pose(), {}).error()));
  BOOST_TEST(std::isinf(Relative_frame().error()));
}
