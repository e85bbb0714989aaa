#include "tetracone/tetratree/scene/body_extent.h"

#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/world_boxes.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_body_extent)

using namespace tetracone;
using kernel::Pose;
using kernel::Rational;
using tetratree::Body_extent;
using tetratree::World_box;
namespace scenes = verify::scenes;
namespace rationals = verify::rationals;
using verify::holds;

namespace {

/// The translation after which the rows' map leaves the point near 0: what cancels is rounded.
void cancel(std::array<double, 12>& m, const std::array<double, 3>& point)
{
  for (int i = 0; i < 3; ++i) m[4 * i + 3] = -(m[4 * i] * point[0] + m[4 * i + 1] * point[1] + m[4 * i + 2] * point[2]);
}

/// Rotations of doubles, true rotations of fractions, stretches and flat ones, near and far, tiny and huge.
Pose random_pose(scenes::Random& random, const std::array<double, 3>& centre)
{
  const double size = std::ldexp(1.0, scenes::integer(random, -3, 3) * scenes::integer(random, 0, 60));
  const double far = std::ldexp(size, scenes::integer(random, -2, 40));
  std::array<double, 12> m;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) m[4 * i + j] = size * scenes::real(random, -1, 1);
    m[4 * i + 3] = far * scenes::real(random, -1, 1);
  }
  if (scenes::integer(random, 0, 2) == 0)
    return Pose::from_quaternion(scenes::integer(random, 1, 9), scenes::integer(random, -9, 9),
                                 scenes::integer(random, -9, 9), scenes::integer(random, -9, 9),
                                 {Rational(1) / 3, Rational(m[7]) / 7, Rational(m[11])});
  if (scenes::integer(random, 0, 3) == 0)
    for (int j = 0; j < 3; ++j) m[j] *= 0x1p-70;
  if (scenes::integer(random, 0, 1) == 0) cancel(m, centre);
  return Pose(m);
}

/// The pose a little or very little later.
Pose later(scenes::Random& random, const Pose& pose, const std::array<double, 3>& centre)
{
  std::array<Rational, 12> m;
  const double step = std::ldexp(1.0, -scenes::integer(random, 1, 70));
  for (int k = 0; k < 12; ++k)
    m[k] = pose.exact(k) * (1 + Rational(scenes::integer(random, 0, 1) * step * scenes::real(random, -1, 1)));
  if (pose.is_rational()) return Pose(m);
  std::array<double, 12> nearest;
  for (int k = 0; k < 12; ++k) nearest[k] = kernel::nearest_double(m[k]);
  if (scenes::integer(random, 0, 1) == 0) cancel(nearest, centre);
  return Pose(nearest);
}

/// x -> (numerator / denominator) 2^exponent x, with entries of its own in each place, that brings `centre` to `to`.
Pose tiny_pose(scenes::Random& random, int exponent, bool is_double, const std::array<double, 3>& centre,
               const Rational& to)
{
  std::array<Rational, 12> m;
  for (int i = 0; i < 3; ++i) {
    m[4 * i + 3] = to;
    for (int j = 0; j < 3; ++j) {
      const Rational third = Rational(scenes::integer(random, -9, 9)) / (is_double ? 1 : 3);
      m[4 * i + j] = third * (exponent < 0 ? 1 / rationals::power(-exponent) : rationals::power(exponent));
      m[4 * i + 3] -= m[4 * i + j] * Rational(centre[j]);
    }
  }
  return Pose(m);
}

/// The boxes of a body at a pose, and by how much at most a step turns it; and by how much it does.
struct Bounds {
  World_box box, tight;
  std::array<double, 3> before;
  double resting, turned;
  Rational most = 0;

  Bounds(const covering::Polyhedron& body, const Body_extent& extent, tetratree::Support_table& table,
         const tetratree::Bvh8& tree, const Pose& pose, const Pose& next)
      : box(world_box(extent, pose)), tight(world_box(table, tree.scale(), pose))
  {
    const auto rest = body_step(extent, pose, pose), step = body_step(extent, pose, next);
    before = rest.at;
    resting = rest.turned;
    turned = step.turned;
    for (const auto& v : body.vertices) {
      const auto p = rationals::image(pose, rationals::exactly(v)), q = rationals::image(next, rationals::exactly(v));
      BOOST_REQUIRE(holds(box, p));
      BOOST_REQUIRE(holds(tight, p));
      if (!std::isfinite(turned)) continue;
      const auto about = rationals::minus(p, rationals::exactly(before)),
                 turned_by = rationals::minus(rationals::minus(q, rationals::exactly(step.at)), about);
      most = std::max(most, Rational(rationals::inner(turned_by, turned_by)));
    }
    if (std::isfinite(turned)) BOOST_REQUIRE(most <= Rational(turned) * Rational(turned));
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(boxes_and_steps_hold_what_rounds_to_denormals_or_to_0)
{
  scenes::Random random(12);
  std::size_t bounded = 0, lost = 0, turned_by_squares_that_underflow = 0;
  for (int n = 0; n < 400; ++n) {
    // A cube, far from the origin along some axes, as large as the doubles allow or about 1.
    covering::Polyhedron body = scenes::cube(1);
    const int size = std::array{0, 180, 500, 1000, 1019}[std::size_t(n % 5)];
    for (int k = 0; k < 3; ++k) {
      const int place = scenes::integer(random, 0, 2);
      for (auto& v : body.vertices) v[k] = std::ldexp(v[k] + (place == 0 ? 3 : 0), place == 2 ? 0 : size);
    }
    const Body_extent extent(body.vertices);
    const tetratree::Bvh8 tree(scenes::triangulated(body));
    tetratree::Support_table table(tree);
    for (int m = 0; m < 8; ++m) {
      const int exponent = m == 0 ? -540 : m == 1 ? -1060 : -scenes::integer(random, size, 1130);
      const bool is_double = m < 2;
      const Rational to = scenes::integer(random, -1, 1) * Rational(0x1p-40);
      const Pose pose = tiny_pose(random, exponent, is_double, extent.centre, is_double ? Rational(0) : to),
                 next = tiny_pose(random, exponent, is_double, extent.centre, is_double ? Rational(0) : to);
      const Bounds bounds(body, extent, table, tree, pose, next);
      bounded += bounds.box.is_bounded();
      lost += pose.is_rational() && pose[0] == 0 && pose.exact(0) != 0;
      turned_by_squares_that_underflow += m == 0 && size == 0 && bounds.most > 0;
    }
  }
  BOOST_TEST(bounded > 2000u);
  BOOST_TEST(lost > 100u);
  BOOST_TEST(turned_by_squares_that_underflow > 40u);
}

BOOST_AUTO_TEST_CASE(boxes_of_tiny_images_are_tiny)
{
  // 2^1010 times a third of 2^-1040.
  const Body_extent extent(scenes::cube(0x1p1010).vertices);
  std::array<Rational, 12> m;
  for (int k = 0; k < 3; ++k) m[5 * k] = 1 / rationals::power(1040) / 3;
  const World_box box = world_box(extent, Pose(m));
  for (int k = 0; k < 3; ++k) {
    BOOST_TEST(box.high[k] >= 0x1p-30 / 3);
    BOOST_TEST(box.high[k] <= 0x1p-29);
    BOOST_TEST(box.low[k] == -box.high[k]);
  }
}

BOOST_AUTO_TEST_CASE(nothing_is_known_of_reach_where_local_units_end)
{
  // A row of 1 and a tiny fraction, which moves what is far along the second axis: no double tells by how much.
  covering::Polyhedron body = scenes::cube(0x1p-150);
  for (auto& v : body.vertices) v[1] = 0x1p1000;
  const tetratree::Bvh8 tree(scenes::triangulated(body));
  tetratree::Support_table table(tree);
  std::array<Rational, 12> m = {1, 1 / rationals::power(1080) / 3, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  const Pose pose(m);
  const World_box tight = world_box(table, tree.scale(), pose);
  for (const auto& v : body.vertices) BOOST_TEST(holds(tight, rationals::image(pose, rationals::exactly(v))));
  BOOST_TEST(!tight.is_bounded());
}

BOOST_AUTO_TEST_CASE(boxes_hold_every_image_and_steps_bound_how_far_each_point_turns)
{
  scenes::Random random(11);
  std::size_t bounded = 0, tighter = 0, near = 0;
  for (int n = 0; n < 60; ++n) {
    // The corners of a cube are those of its box, where bounds are at their tightest.
    covering::Polyhedron body = scenes::triangulated(n % 2 == 0 ? scenes::torus(6, 5) : scenes::cube(1));
    const double at = std::ldexp(scenes::real(random, -1, 1), scenes::integer(random, -4, 46));
    for (auto& v : body.vertices)
      for (int k = 0; k < 3; ++k) v[k] = v[k] + at;
    const Body_extent extent(body.vertices);
    const tetratree::Bvh8 tree(body);
    tetratree::Support_table table(tree);
    for (int m = 0; m < 20; ++m) {
      const Pose pose = random_pose(random, extent.centre), next = later(random, pose, extent.centre);
      const Bounds bounds(body, extent, table, tree, pose, next);
      const World_box &box = bounds.box, &tight = bounds.tight;
      BOOST_TEST((body_step(extent, next, pose).at == bounds.before));
      bounded += tight.is_bounded();
      tighter += tight.is_bounded() && tight.high[0] - tight.low[0] < box.high[0] - box.low[0];
      BOOST_REQUIRE((std::isfinite(bounds.resting) && std::isfinite(bounds.turned)));
      near += Rational(bounds.turned) * Rational(bounds.turned) <= 9 * bounds.most;
    }
  }
  BOOST_TEST(bounded > 900u);
  BOOST_TEST(tighter > 200u);
  BOOST_TEST(near > 200u);
}

BOOST_AUTO_TEST_CASE(a_translation_turns_nothing_and_a_turn_does_so_by_little_more_than_it_is)
{
  const Body_extent extent(scenes::cube(1e9).vertices);
  const auto [at, turned] = body_step(extent, Pose(), Pose::translation(3, 4, 0));
  for (int k = 0; k < 3; ++k) BOOST_TEST(std::abs(at[k] - extent.centre[k] - (k == 0 ? 3 : k == 1 ? 4 : 0)) <= 1e-6);
  BOOST_TEST(turned < 1e-3);

  // Points on a ball, whose box has corners far from them; those that turn most have moved by 0.01.
  std::vector<kernel::Vertex> ball;
  for (int k = 0; k < 3; ++k)
    for (const double x : {-1, 1}) {
      ball.push_back({0, 0, 0});
      ball.back()[k] = x;
    }
  const double s = 0.01, c = std::sqrt(1 - s * s);
  const Pose turn(std::array<double, 12>{c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0});
  BOOST_TEST(body_step(Body_extent(ball), Pose(), turn).turned < 0.01 * 1.42);
  // A long body's ends.
  const Body_extent rod(scenes::box({-100, -1, -1}, {100, 1, 1}).vertices);
  BOOST_TEST(body_step(rod, Pose(), turn).turned < 1.03);
}

BOOST_AUTO_TEST_CASE(what_is_beyond_all_numbers_has_no_bounds)
{
  const double most = std::numeric_limits<double>::max();
  const Body_extent extent(scenes::cube(most).vertices);
  const World_box box = world_box(extent, Pose(std::array<double, 12>{2, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}));
  BOOST_TEST(!box.is_bounded());
  const Pose far(std::array<double, 12>{2, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
  BOOST_TEST(!(body_step(extent, Pose(), far).turned <= most));
}

BOOST_AUTO_TEST_SUITE_END()
