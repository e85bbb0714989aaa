#include "tetracone/kernel/motion/motion_span.h"

#include "verify/cases/random.h"
#include "verify/test/support/rationals.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_motion_span)

using namespace tetracone::kernel;
using tetracone::verify::Random;

Vertex any_vertex(Random& random) { return {random.symmetric(), random.symmetric(), random.symmetric()}; }

Body_motion any_motion(Random& random, bool is_rigid)
{
  if (!is_rigid) {
    const auto pose = [&] {
      std::array<double, 12> entries;
      for (double& x : entries) x = random.symmetric();
      return Pose(entries);
    };
    const Pose from = pose();
    return Body_motion::linear(from, pose());
  }
  const auto pose = [&] {
    return Rigid_pose{{1.5, random.symmetric(), random.symmetric(), random.symmetric()},
                      {random.symmetric(), random.symmetric(), random.symmetric()}};
  };
  const Rigid_pose from = pose();
  return Body_motion::rigid(from, pose()).value();
}

/// As a query has it: of doubles where all points move on lines.
Motion_span span_of(const Body_motion& a, const Motion_units& in_a, const Body_motion& b, const Motion_units& in_b)
{
  if (!a.ends() || !b.ends()) return Motion_span(Pair_motion(a, b), in_a, in_b);
  const auto span = Motion_span::of_lines(*a.ends(), in_a, *b.ends(), in_b);
  BOOST_TEST(span.has_value());
  return *span;
}

/// A point of local units along an axis at a pose, exactly.
Rational along(const Vertex& axis, const Pose& pose, const Motion_units& units, const Vertex& local)
{
  using namespace tetracone::verify::rationals;
  const auto x = plus(exactly(units.origin), times(Rational(units.unit), exactly(local)));
  return inner(exactly(axis), image(pose, x));
}

std::vector<Vertex> corners(const Moving_box& box)
{
  std::vector<Vertex> all;
  for (int bits = 0; bits < 8; ++bits) {
    Vertex v = box.centre;
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 3; ++i) v[i] += (bits >> k & 1 ? 1 : -1) * box.half_edge[k][i];
    all.push_back(v);
  }
  return all;
}

Moving_box any_box(Random& random, double size)
{
  Moving_box box{any_vertex(random), {}};
  for (Vertex& edge : box.half_edge)
    for (double& x : edge) x = size * random.symmetric();
  return box;
}

BOOST_AUTO_TEST_CASE(what_may_not_meet_in_a_span_is_apart_at_its_times)
{
  Random random(1);
  int found = 0, of_parts = 0, of_halves = 0, of_lines = 0;
  for (int k = 0; k < 600; ++k) {
    const Body_motion a = any_motion(random, k % 3 != 0), b = any_motion(random, k % 2 != 0);
    const Motion_units in_a{any_vertex(random), 0.5}, in_b{any_vertex(random), 2};
    Motion_span span = span_of(a, in_a, b, in_b);
    of_lines += a.ends() && b.ends();
    for (int halves = k % 6; halves > 0; --halves) span = span.half(random.bits() % 2 == 1);
    const Moving_box box_a = any_box(random, 0.25), box_b = any_box(random, 0.25);
    const Vertex axis = any_vertex(random);
    const std::vector<Vertex> of_a = corners(box_a), of_b = corners(box_b);
    const Time_window of_boxes = span.near_along(axis, box_a, box_b),
                      of_points = span.near_along(axis, span.placed(0, std::array{of_a[0], of_a[3], of_a[5]}),
                                                  span.placed(1, std::array{of_b[1], of_b[6]}));
    if (of_boxes.is_empty() && span.size() == 2) BOOST_TEST(of_points.is_empty());
    found += of_boxes.is_empty();
    of_halves += of_boxes.is_empty() && span.k() > 0;
    of_parts += !of_boxes.is_empty() && (of_boxes.from > 0 || of_boxes.until < 1);
    const auto check = [&](const Time_window& near, const std::vector<Vertex>& points_a,
                           const std::vector<Vertex>& points_b) {
      for (int step = 0; step <= 16; ++step) {
        const double share = step / 16.0;
        if (share >= near.from && share <= near.until) continue;
        const Rational time =
            (Rational(16 * long(span.m()) + step)) / (Rational(16) * Rational(std::ldexp(1, int(span.k()))));
        const Pose pose_a = a.at(time), pose_b = b.at(time);
        const auto ends_along = [&](const Pose& pose, const Motion_units& units, const std::vector<Vertex>& points) {
          std::vector<Rational> at;
          for (const Vertex& p : points) at.push_back(along(axis, pose, units, p));
          const auto [least, most] = std::minmax_element(at.begin(), at.end());
          return std::pair<Rational, Rational>(*least, *most);
        };
        const auto [from_a, to_a] = ends_along(pose_a, in_a, points_a);
        const auto [from_b, to_b] = ends_along(pose_b, in_b, points_b);
        const bool before = to_a < from_b, behind = to_b < from_a;
        BOOST_TEST((before || behind));
      }
    };
    check(of_boxes, of_a, of_b);
    check(of_points, {of_a[0], of_a[3], of_a[5]}, {of_b[1], of_b[6]});
  }
  BOOST_TEST(found > 120);
  BOOST_TEST(of_parts > 60);
  BOOST_TEST(of_halves > 80);
  BOOST_TEST(of_lines >= 100);
}

BOOST_AUTO_TEST_CASE(what_coincides_may_meet_at_all_times)
{
  // One point in the local units of two bodies that move alike: all that is computed between them is rounding.
  Random random(2);
  for (int k = 0; k < 400; ++k) {
    const Body_motion motion = any_motion(random, k % 2 == 0);
    const Motion_units in_a{{0, 0, 0}, 1}, in_b{{random.bits() % 64 * 0x1p-6, 0.25, -0.5}, 2};
    Vertex p, q;
    for (int i = 0; i < 3; ++i) {
      p[i] = std::round(random.symmetric() * 0x1p30) * 0x1p-30;
      q[i] = (p[i] - in_b.origin[i]) / 2;
    }
    Motion_span span =
        k % 4 == 1 ? Motion_span(Pair_motion(motion, motion), in_a, in_b) : span_of(motion, in_a, motion, in_b);
    for (int halves = k % 4; halves > 0; --halves) span = span.half(random.bits() % 2 == 1);
    const Time_window near = span.near_along(any_vertex(random), span.placed(0, std::array<Vertex, 1>{p}),
                                             span.placed(1, std::array<Vertex, 1>{q}));
    BOOST_TEST((near.from <= 0 && near.until >= 1));
  }
}

BOOST_AUTO_TEST_CASE(points_that_meet_once_may_do_so_about_then_alone)
{
  const Body_motion rests = Body_motion::linear(Pose(), Pose()),
                    falls = Body_motion::linear(Pose::translation(0, 0, 1), Pose::translation(0, 0, -3));
  const Motion_span span(Pair_motion(rests, falls), {{0, 0, 0}, 1}, {{0, 0, 0}, 1});
  const std::array<Vertex, 1> point = {{{0, 0, 0}}};
  for (const double sense : {1.0, -1.0}) {
    const Time_window near = span.near_along({0, 0, sense}, span.placed(0, point), span.placed(1, point));
    BOOST_TEST((near.from <= 0.25 && near.from > 0.25 - 1e-10));
    BOOST_TEST((near.until >= 0.25 && near.until < 0.25 + 1e-10));
  }
  const Motion_span half = span.half(false);
  BOOST_TEST(half.share_before(0.25) >= 0.5);
  BOOST_TEST(half.share_before(0.25) < 0.5 + 1e-10);
}

BOOST_AUTO_TEST_CASE(an_axis_that_is_no_number_or_none_parts_nothing)
{
  const Body_motion rests = Body_motion::linear(Pose(), Pose()),
                    away = Body_motion::linear(Pose::translation(9, 0, 0), Pose::translation(9, 1, 0));
  const Motion_span span(Pair_motion(rests, away), {{0, 0, 0}, 1}, {{0, 0, 0}, 1});
  const std::array<Vertex, 1> point = {{{0, 0, 0}}};
  const auto apart = [&](const Vertex& axis) {
    const Time_window near = span.near_along(axis, span.placed(0, point), span.placed(1, point));
    return near.is_empty() || near.from > 0 || near.until < 1;
  };
  BOOST_TEST(apart({1, 0, 0}));
  BOOST_TEST(apart({-1, 0, 0}));
  BOOST_TEST(!apart({0, 0, 1}));
  BOOST_TEST(!apart({0, 0, 0}));
  BOOST_TEST(!apart({std::numeric_limits<double>::quiet_NaN(), 0, 0}));
  BOOST_TEST(!apart({1, std::numeric_limits<double>::infinity(), 0}));
  // Nor do points that are too far at one end to be told, and on the other side at the other.
  auto far = span.placed(1, point);
  far[0][0] = {1e300, 0, 0};
  far[1][0] = {-9, 0, 0};
  for (const double sense : {0x1p90, -0x1p90}) {
    const Time_window near = span.near_along({sense, 0, 0}, span.placed(0, point), far);
    BOOST_TEST((near.from <= 0 && near.until >= 1));
  }
}

BOOST_AUTO_TEST_CASE(halves_are_where_the_bodies_are)
{
  Random random(3);
  for (const bool is_rigid : {false, true}) {
    const Body_motion a = any_motion(random, is_rigid), b = any_motion(random, is_rigid);
    const Motion_units units{{0, 0, 0}, 1};
    Motion_span span(Pair_motion(a, b), units, units);
    for (int k = 0; k < 5; ++k) {
      BOOST_TEST(span.middle() == (double(span.m()) + 0.5) / double(1u << span.k()));
      BOOST_TEST(span.start() == double(span.m()) / double(1u << span.k()));
      const Vertex p = any_vertex(random), q = any_vertex(random);
      const Vertex found = Motion_span::between(span.at_middle(), p, q);
      const Pose pose_a = a.at(span.middle()), pose_b = b.at(span.middle());
      // Up to a factor of the whole: directions are compared.
      Vertex exact;
      for (int i = 0; i < 3; ++i) {
        Vertex unit = {0, 0, 0};
        unit[i] = 1;
        exact[i] = nearest_double(Rational(along(unit, pose_b, units, q) - along(unit, pose_a, units, p)));
      }
      const double factor = dot(found, exact) / dot(exact, exact);
      BOOST_TEST(factor > 0);
      for (int i = 0; i < 3; ++i) BOOST_TEST(std::abs(found[i] - factor * exact[i]) < 1e-12);
      span = span.half(k % 2 == 0);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
