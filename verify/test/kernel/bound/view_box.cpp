#include "tetracone/kernel/bound/view_box.h"

#include "verify/test/support/placed_boxes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_view_box)

using namespace tetracone::kernel;

/// A node of one box, turned about z by the angle of 3, 4, 5.
Obb8 one_box()
{
  Obb8 boxes{};
  boxes.lane_count = 1;
  const float axis[3][3] = {{0.6f, 0.8f, 0}, {-0.8f, 0.6f, 0}, {0, 0, 1}};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) boxes.axis[i][k][0] = axis[i][k];
    boxes.centre[i][0] = 0.125f * float(i);
    boxes.origin[i] = 0.25f;
    boxes.extent[i][0] = 0.0625f * float(i + 1);
  }
  return boxes;
}

/// Returns the bounds of some points.
View_box bounds(std::initializer_list<std::array<double, 3>> points)
{
  View_box box;
  box.low.fill(HUGE_VAL);
  box.high.fill(-HUGE_VAL);
  for (const auto& p : points)
    for (std::size_t k = 0; k < View_box::axes; ++k) {
      box.low[k] = std::min(box.low[k], View_box::along(p)[k]);
      box.high[k] = std::max(box.high[k], View_box::along(p)[k]);
    }
  return box;
}

/// Returns the bounds of an upright block.
View_box block(double x, double y, double z, double length)
{
  return bounds({{x, y, z},
                 {x + length, y, z},
                 {x, y + 1, z},
                 {x + length, y + 1, z},
                 {x, y, z + 1},
                 {x + length, y, z + 1},
                 {x, y + 1, z + 1},
                 {x + length, y + 1, z + 1}});
}

BOOST_AUTO_TEST_CASE(every_corner_of_a_box_is_within_the_bounds)
{
  using namespace tetracone::verify::rationals;
  namespace scenes = tetracone::verify::scenes;
  const Local_scale units{{1, -2, 3}, 4};
  const std::array<Rational, 12> map = {1, Rational(1, 3), 0, 5, 0, 2, Rational(-1, 7), 0, 1, 1, 3, -1};
  const Obb8 boxes = one_box();
  const View_box seen = Box_view(map, units)(boxes)[0];
  std::array<bool, View_box::axes> is_tight{};
  for (int corner = 0; corner < 8; ++corner) {
    std::array<double, 3> share;
    for (int i = 0; i < 3; ++i) share[i] = (corner >> i & 1) ? 1 : -1;
    const auto x = plus(exactly(units.origin), times(units.unit, scenes::point(boxes, 0, share))),
               seen_at = image(Pose(map), x);
    const auto& [x_at, y_at, z_at] = seen_at;
    const std::array<Rational, View_box::axes> at = {x_at,        y_at,        x_at + y_at, x_at - y_at, z_at,
                                                     z_at + x_at, z_at - x_at, z_at + y_at, z_at - y_at};
    for (std::size_t k = 0; k < at.size(); ++k) {
      BOOST_TEST(Rational(seen.low[k]) <= at[k]);
      BOOST_TEST(Rational(seen.high[k]) >= at[k]);
      is_tight[k] = is_tight[k] || at[k] - Rational(seen.low[k]) < Rational(1, 1000000);
    }
  }
  for (const bool tight : is_tight) BOOST_TEST(tight);
}

BOOST_AUTO_TEST_CASE(rises_are_bounded_outward_and_boxes_beside_each_other_never_meet)
{
  const View_box a = block(0, 0, 0, 1);
  View_box b = a;
  BOOST_TEST(a.may_cover(b));
  BOOST_TEST(least_rise(a, b) < -1);
  BOOST_TEST(most_rise(a, b) > 1);
  b.low[3] = 1.5;
  b.high[3] = 2;
  BOOST_TEST(!a.may_cover(b));
}

BOOST_AUTO_TEST_CASE(slanted_parts_have_near_bounds_of_rises)
{
  for (const std::array<double, 3> way : {std::array<double, 3>{1, 0, 1}, {1, 0, -1}, {0, 1, 1}, {0, 1, -1}}) {
    const View_box a = bounds({{0, 0, 0}, way}), b = bounds({{0, 0, 0.5}, {way[0], way[1], way[2] + 0.5}});
    BOOST_TEST(least_rise(a, b) < 0.5);
    BOOST_TEST(least_rise(a, b) > 0.499);
    BOOST_TEST(most_rise(a, b) > 0.5);
    BOOST_TEST(most_rise(a, b) < 0.501);
    BOOST_TEST(a.may_meet(b, {0, 0, 0.5}, {0, 0, 0}));
    BOOST_TEST(!a.may_meet(b, {0, 0, 0.25}, {0, 0, 0.125}));
    BOOST_TEST(!a.may_meet(b, {way[0] / 4, way[1] / 4, way[2] / 4}, {0.125, 0.125, 0.125}));
  }
}

BOOST_AUTO_TEST_CASE(what_is_too_large_is_not_bounded)
{
  const std::array<Rational, 12> map = {1, 0, 0, Rational(0x1p300), 0, 1, 0, 0, 0, 0, 1, 0};
  const View_box seen = Box_view(map, Local_scale())(one_box())[0];
  for (std::size_t k = 0; k < View_box::axes; ++k) {
    BOOST_TEST(seen.low[k] == -HUGE_VAL);
    BOOST_TEST(seen.high[k] == HUGE_VAL);
  }
}

BOOST_AUTO_TEST_CASE(parts_meet_for_a_translation_where_their_bounds_do)
{
  const View_box a = block(0, 0, 0, 1), b = block(4, 0, 0, 1);
  BOOST_TEST(a.may_meet(b, {4, 0, 0}, {0, 0, 0}));
  BOOST_TEST(a.may_meet(b, {3, 0, 0}, {0, 0, 0}));
  BOOST_TEST(!a.may_meet(b, {2.5, 0, 0}, {0, 0, 0}));
  BOOST_TEST(a.may_meet(b, {2.5, 0, 0}, {0.5, 0, 0}));
  BOOST_TEST(!a.may_meet(b, {5.5, 0, 0}, {0.25, 0, 0}));
  BOOST_TEST(!a.may_meet(b, {4, 0, -1.5}, {0, 0, 0.25}));
  BOOST_TEST(a.may_meet(b, {4, 0, -1.5}, {0, 0, 0.5}));
  // The diagonals tell more than the sides.
  const auto long_part = [](double x, double y) {
    return bounds({{x, y + 0.1, 0},
                   {x + 0.1, y, 0},
                   {x + 1, y + 0.9, 1},
                   {x + 0.9, y + 1, 1},
                   {x, y + 0.1, 1},
                   {x + 0.1, y, 1},
                   {x + 1, y + 0.9, 0},
                   {x + 0.9, y + 1, 0}});
  };
  const View_box long_a = long_part(0, 0), long_b = long_part(0.5, -0.5);
  BOOST_TEST(!long_a.may_meet(long_b, {0, 0, 0}, {0.25, 0.25, 0}));
  BOOST_TEST(long_a.may_meet(long_b, {0, 0, 0}, {0.5, 0.5, 0}));
  BOOST_TEST(long_a.may_meet(long_b, {0.5, -0.5, 0}, {0, 0, 0}));
}

BOOST_AUTO_TEST_SUITE_END()
