#include "tetracone/tetratree/scene/turned_box.h"

#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <span>

BOOST_AUTO_TEST_SUITE(test_turned_box)

using namespace tetracone;
using kernel::Pose;
using kernel::Rational;
using kernel::Vertex;
using tetratree::Body_extent;
using tetratree::Turned_box;
namespace scenes = verify::scenes;
namespace rationals = verify::rationals;

namespace {

Body_extent any_extent(scenes::Random& random)
{
  Body_extent extent;
  for (int k = 0; k < 3; ++k) {
    extent.centre[k] = scenes::real(random, -2, 2);
    extent.half[k] = std::exp2(scenes::real(random, -6, 3));
  }
  return extent;
}

/// Rotations of fractions or of doubles, stretched or not, mirrored or not; some of them sheared.
Pose any_pose(scenes::Random& random, bool is_sheared)
{
  const Pose turned = scenes::random_rotation(random, 9);
  const double stretch = scenes::integer(random, 0, 1) * 3.25 + 1, side = scenes::integer(random, 0, 1) ? -1 : 1;
  std::array<Rational, 12> m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j)
      m[4 * i + j] = turned.exact(4 * i + j) * Rational(j == 3 ? 1 : stretch * (j == 0 ? side : 1));
  for (int i = 0; i < 3; ++i)
    if (is_sheared) m[4 * i + 1] += m[4 * i] * Rational(0.25);
  const Pose exact(m);
  return scenes::integer(random, 0, 1) ? exact : scenes::rounded(exact);
}

/// The image of the corner that is farthest along n.
rationals::Vector farthest(const Body_extent& extent, const Pose& pose, const Vertex& n)
{
  rationals::Vector corner;
  for (int j = 0; j < 3; ++j) {
    double along = 0;
    for (int i = 0; i < 3; ++i) along += n[i] * pose[4 * i + j];
    corner[j] = Rational(extent.centre[j]) + Rational(along > 0 ? extent.half[j] : -extent.half[j]);
  }
  return rationals::image(pose, corner);
}

Pose shifted(const Pose& pose, const rationals::Vector& by)
{
  return scenes::composed(Pose(std::array<Rational, 12>{1, 0, 0, by[0], 0, 1, 0, by[1], 0, 0, 1, by[2]}), pose);
}

}  // namespace

BOOST_AUTO_TEST_CASE(gaps_are_at_most_what_is_between_corners)
{
  scenes::Random random(3);
  int positive = 0, near_to_right = 0;
  for (int round = 0; round < 400; ++round) {
    const bool is_sheared = round % 10 == 9;
    const Body_extent one = any_extent(random);
    const Pose at = any_pose(random, false);
    const double away = round % 4 == 0 ? 0 : std::exp2(scenes::real(random, -20, 2));
    std::array<Turned_box, kernel::lanes> others;
    const std::size_t count = std::size_t(scenes::integer(random, 1, 8));
    for (std::size_t k = 0; k < count; ++k) {
      const Body_extent extent = any_extent(random);
      const Pose pose = any_pose(random, is_sheared);
      Vertex n = scenes::real_vertex(random, 1);
      // Along an edge or a normal, a gap can be found whole.
      if (round % 3 == 0) n = {at[0], at[4], at[8]};
      const double length = std::sqrt(kernel::dot(n, n));
      for (double& x : n) x /= length;
      const Vertex back = {-n[0], -n[1], -n[2]};
      const auto between = rationals::minus(farthest(one, at, n), farthest(extent, pose, back));
      const auto by = rationals::plus(between, rationals::times(Rational(away), rationals::exactly(n)));
      others[k] = tetratree::turned_box(extent, shifted(pose, by));
      BOOST_TEST(others[k].is_known == !is_sheared);
    }
    const auto gaps = tetratree::turned_gaps(tetratree::turned_box(one, at), std::span(others).first(count));
    for (std::size_t k = 0; k < count; ++k) {
      BOOST_TEST(gaps[k] <= away * (1 + 0x1p-40));
      positive += gaps[k] > 0;
      near_to_right += gaps[k] > 0.9 * away;
    }
  }
  BOOST_TEST(positive > 200);
  BOOST_TEST(near_to_right > 100);
}

BOOST_AUTO_TEST_CASE(near_the_ends_of_the_range_nothing_is_known)
{
  const Body_extent unit = [] {
    Body_extent extent;
    extent.half = {1, 1, 1};
    return extent;
  }();
  const auto scaled = [](double s) { return Pose(std::array<double, 12>{s, 0, 0, 0, 0, s, 0, 0, 0, 0, s, 0}); };
  BOOST_TEST(tetratree::turned_box(unit, Pose()).is_known);
  for (const double s : {1e-300, 1e-160, 1e160, 1e300}) BOOST_TEST(!tetratree::turned_box(unit, scaled(s)).is_known);
  BOOST_TEST(!tetratree::turned_box(unit, Pose::translation(1e200, 0, 0)).is_known);

  // Unknown boxes and boxes too far away to be compared are not found apart.
  const Turned_box near = tetratree::turned_box(unit, Pose()),
                   far = tetratree::turned_box(unit, Pose::translation(1e9, 0, 0)),
                   beside = tetratree::turned_box(unit, Pose::translation(2.5, 0, 0));
  const std::array others = {Turned_box(), far, beside};
  for (const double gap : tetratree::turned_gaps(near, others)) BOOST_TEST(gap <= 0);
  for (const double gap : tetratree::turned_gaps(Turned_box(), std::span(others).last(1))) BOOST_TEST(gap <= 0);
  BOOST_TEST(tetratree::turned_gaps(near, std::span(others).last(1))[0] > 0.499);
}

BOOST_AUTO_TEST_SUITE_END()
