#include "tetracone/kernel/bound/obb8_gap.h"

#include "tetracone/kernel/bound/relative_motion.h"
#include "verify/test/support/placed_boxes.h"
#include "verify/test/support/simd_versions.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_obb8_gap)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

inline auto certifying() { return TETRACONE_VERSIONS_HERE(certified_gaps_simd); }
inline auto carrying() { return TETRACONE_VERSIONS_HERE(carry_now_simd); }
inline auto least_after() { return TETRACONE_VERSIONS_HERE(least_gap_after_simd); }

/// An edge of a box along n, after it is turned.
template <class Direction>
double along(const Obb8& boxes, int lane, int i, const Vector& n, const Direction& direction)
{
  return n.dot(vector_of(direction(axis(boxes, lane, i))));
}

/// The shares of the corner of a box that reaches least along n, its axes turned by `direction`.
template <class Direction>
std::array<double, 3> lowest(const Obb8& boxes, int lane, const Vector& n, const Direction& direction)
{
  std::array<double, 3> share;
  for (int i = 0; i < 3; ++i) share[i] = along(boxes, lane, i, n, direction) > 0 ? -1 : 1;
  return share;
}

/// The box itself, or of one that holds a triangle the corner of that which reaches least.
template <class Direction>
std::array<double, 3> lowest_point(const Obb8& boxes, int lane, float apex, const Vector& n, const Direction& direction)
{
  if (apex == no_apex) return lowest(boxes, lane, n, direction);
  const std::array<std::array<double, 3>, 3> corners = {{{0, -1, -1}, {0, 1, -1}, {0, apex, 1}}};
  return *std::ranges::min_element(corners, {}, [&](const std::array<double, 3>& share) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += share[i] * boxes.extent[i][lane] * along(boxes, lane, i, n, direction);
    return sum;
  });
}

/// Directions after a map turns them, and after `steps` further steps of a course.
auto turned_by(const Box_map& map, const Course& course = {}, double steps = 0)
{
  return [&map, course, steps](const std::array<double, 3>& v) {
    std::array<double, 3> turned = map.frame().direction(v);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) turned[i] += steps * double(course.column[j][i]) * v[j];
    return turned;
  };
}

/// A point after `steps` steps of a course.
rationals::Vector on_course(rationals::Vector image, const rationals::Vector& q, const Course& course, double steps)
{
  for (int i = 0; i < 3; ++i) {
    Rational on = course.column[3][i];
    for (int j = 0; j < 3; ++j) on += Rational(course.column[j][i]) * q[j];
    image[i] += Rational(steps) * on;
  }
  return image;
}

struct Scene {
  Placing before, after;
  Obb8 boxes{}, from{};
  int lane;
  float apex = no_apex;
};

/// Boxes near one another; the single one moves: by next to nothing, along, away, round, or with the node's body.
Scene scene(Random& random, int kind)
{
  Scene s;
  Placing& p = s.before;
  p = random_placing(random);
  if (kind % 4 == 1) p.b = scaled(p.b, 1.7);
  if (kind % 5 == 2) move_far(p, 0x1p33);
  if (kind % 3 == 1) p.b = rounded(p.b);
  s.lane = integer(random, 0, 7);
  const double small = kind % 7 < 2 ? 1e-3 : 0.3;
  set_single(s.from, s.lane, random, small, kind % 2 == 0 ? &s.apex : nullptr);
  rationals::Vector middle = p.image(point(s.from, s.lane, {0, 0, 0}));
  const double near = small * nearest_double(Rational(p.in_b.unit / p.in_a.unit)) * (kind % 4 == 1 ? 1.7 : 1);
  for (int i = 0; i < 3; ++i)
    s.boxes.origin[i] = float(nearest_double(middle[i]) + near * real(random, -1, 1) * (kind % 6 == 0 ? 300 : 2));
  set_near(s.boxes, random, near);
  if (kind % 9 == 4) {  // little more than points: a gap is the centres' distance, and so are its errors
    for (auto& of_axis : s.boxes.extent)
      for (float& x : of_axis) x *= 0x1p-24F;
    for (auto& of_axis : s.from.extent) of_axis[s.lane] *= 0x1p-24F;
  }

  s.after = p;
  const double step = std::ldexp(near * p.in_a.unit, -integer(random, 0, 30));
  auto m = s.after.b.entries();
  const double c = std::cos(kind % 3 * step), sine = std::sin(kind % 3 * step);
  for (int j = 0; j < (kind % 5 == 2 ? 3 : 4); ++j) {
    const double x = m[j], y = m[4 + j];
    m[j] = c * x - sine * y;
    m[4 + j] = sine * x + c * y;
  }
  for (int i = 0; i < 3; ++i) m[4 * i + 3] += step * real(random, -1, 1);
  if (kind % 8 != 7) s.after.b = Pose(m);
  return s;
}

bool is_less(const rationals::Vector& n, const rationals::Vector& from, const rationals::Vector& to, double gap)
{
  return rationals::inner(n, rationals::minus(to, from)) < Rational(gap);
}

BOOST_AUTO_TEST_CASE(boxes_are_as_far_apart_along_its_axis_as_a_gap_says_and_after_a_step_and_on_a_course_too)
{
  Random random(1);
  int gaps = 0, wrong = 0, wrong_near = 0, short_axes = 0, after = 0, wrong_after = 0, kept = 0, on_courses = 0,
      wrong_on_course = 0;
  double tightest = std::numeric_limits<double>::infinity(), tightest_rate = tightest;
  for (int k = 0; k < 900; ++k) {
    const Scene s = scene(random, k);
    const Box_map map = s.before.map(), moved = s.after.map();
    BOOST_TEST_REQUIRE(map.is_similarity());
    Certified_gaps found;
    certifying()[std::size_t(k) % certifying().size()](s.boxes, map, s.from, s.lane, s.apex, found);
    const Placement before(map), after_step(moved);
    Carried_box carried;
    carrying()[std::size_t(k) % carrying().size()](Carrier(map, before, {}), s.from, s.lane, carried);
    // It goes on by the same step; or elsewhere.
    Placement elsewhere = after_step;
    for (auto& column : elsewhere.column)
      for (int i = 0; i < 3; ++i) column[i] += std::ldexp(real(random, -1, 1), -integer(random, 4, 40));
    const Course course = k % 2 == 0 ? Course(before, after_step) : Course(after_step, elsewhere);
    const Carrier carrier(moved, after_step, course);
    for (int lane = 0; lane < int(lanes); ++lane) {
      if (!(found.gap[lane] > 0)) continue;
      ++gaps;
      const Vector n(found.axis[0][lane], found.axis[1][lane], found.axis[2][lane]);
      const rationals::Vector exact_n = {Rational(n[0]), Rational(n[1]), Rational(n[2])};
      short_axes += n.norm() > 1 + 1e-5 || n.norm() < 1e-4;
      const rationals::Vector p = point(s.boxes, lane, lowest(s.boxes, lane, -n, [](const auto& v) { return v; }));
      const auto q = point(s.from, s.lane, lowest_point(s.from, s.lane, s.apex, n, turned_by(map))),
                 at = s.before.image(q);
      wrong += is_less(exact_n, p, at, found.gap[lane]);
      const double exact = nearest_double(rationals::inner(exact_n, rationals::minus(at, p)));
      tightest = std::min(tightest, (exact - found.gap[lane]) / exact);
      // Where the boxes touch along the axis, up to a rounding of the origin, the slack decides.
      Scene touching = s;
      for (int i = 0; i < 3; ++i) touching.boxes.origin[i] += float(exact * n[i]);
      Certified_gaps near;
      certifying()[std::size_t(lane) % certifying().size()](touching.boxes, map, s.from, s.lane, s.apex, near);
      const Vector m(near.axis[0][lane], near.axis[1][lane], near.axis[2][lane]);
      if (near.gap[lane] > 0) {
        const auto q_near = point(s.from, s.lane, lowest_point(s.from, s.lane, s.apex, m, turned_by(map)));
        wrong_near +=
            is_less({Rational(m[0]), Rational(m[1]), Rational(m[2])},
                    point(touching.boxes, lane, lowest(touching.boxes, lane, -m, [](const auto& v) { return v; })),
                    s.before.image(q_near), near.gap[lane]);
      }
      // The step.
      const auto left_after = least_after()[std::size_t(lane) % least_after().size()];
      const Gap_and_rate left = left_after(found, 1u << lane, carried, Going_box(s.from, s.lane), carrier);
      const auto q_after = point(s.from, s.lane, lowest_point(s.from, s.lane, s.apex, n, turned_by(moved)));
      ++after;
      wrong_after += is_less(exact_n, p, s.after.image(q_after), left.gap);
      kept += left.gap > 0;
      // As long as something is left.
      if (left.gap > 0)
        for (const double share : {0.0, 0.4, 0.99}) {
          const double steps = left.rate > 0 ? share * left.gap / left.rate : share * 1000;
          const auto q_then =
              point(s.from, s.lane, lowest_point(s.from, s.lane, s.apex, n, turned_by(moved, course, steps)));
          const rationals::Vector then = on_course(s.after.image(q_then), q_then, course, steps);
          ++on_courses;
          wrong_on_course += is_less(exact_n, p, then, left.gap - steps * left.rate);
          if (share > 0.9 && left.rate > 0)
            tightest_rate = std::min(tightest_rate,
                                     nearest_double(rationals::inner(exact_n, rationals::minus(then, p))) / left.gap);
        }
      // The lane moves instead, in the opposite direction.
      const Gap_and_rate of_lane = left_after(found, 1u << lane, carried, Going_box(s.boxes, lane), carrier);
      wrong_after += of_lane.gap != left.gap;
      if (!(left.gap > 0 && of_lane.rate > 0)) continue;
      const double steps = 0.99 * left.gap / of_lane.rate;
      const auto against = lowest(s.boxes, lane, -n, [&](const std::array<double, 3>& v) {
        std::array<double, 3> turned = v;
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) turned[i] -= steps * double(course.column[j][i]) * v[j];
        return turned;
      });
      const rationals::Vector p_start = point(s.boxes, lane, against),
                              p_then = on_course(p_start, p_start, course, -steps);
      wrong_on_course += is_less(exact_n, p_then, s.after.image(q_after), left.gap - steps * of_lane.rate);
    }
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(wrong_near == 0);
  BOOST_TEST(wrong_after == 0);
  BOOST_TEST(wrong_on_course == 0);
  BOOST_TEST(on_courses > after);
  BOOST_TEST(tightest_rate < 0.011);  // of the 0.01 that is left at least
  BOOST_TEST(short_axes == 0);
  BOOST_TEST(gaps > 2000);
  BOOST_TEST(kept > after / 2);
  BOOST_TEST(tightest < 1e-4);
}

BOOST_AUTO_TEST_CASE(what_is_infinite_undefined_or_no_similarity_has_no_gap)
{
  Random random(2);
  Scene s = scene(random, 3);
  auto sheared = s.before.b.entries();
  sheared[1] += 0.5;
  Placing no_similarity = s.before;
  no_similarity.b = Pose(sheared);
  for (const auto certify : certifying())
    for (const Box_map& map : {no_similarity.map(), Box_map()}) {
      Certified_gaps found;
      certify(s.boxes, map, s.from, s.lane, no_apex, found);
      for (const float gap : found.gap) BOOST_TEST(!(gap > 0));
    }
  // A far box is apart whatever the slack, and its gap is told with the slack of its distance.
  Certified_gaps found;
  certified_gaps(s.boxes, s.before.map(), s.from, s.lane, no_apex, found);
  const Box_map map = s.before.map(), of_nothing;
  const Placement placement(map), nowhere(of_nothing);
  const Going_box going(s.from, s.lane);
  for (const auto carry : carrying())
    for (const auto after : least_after()) {
      Carried_box carried, carried_wrong;
      carry(Carrier(map, placement, {}), s.from, s.lane, carried);
      unsigned apart = 0;
      for (int lane = 0; lane < int(lanes); ++lane) apart |= unsigned(found.gap[lane] > 1e-3f) << lane;
      BOOST_TEST_REQUIRE(apart != 0u);
      BOOST_TEST((after(found, apart, carried, going, Carrier(map, placement, {})).gap > 0));
      BOOST_TEST(!(after(found, apart, carried, going, Carrier(of_nothing, nowhere, {})).gap > 0));
      for (const float bad : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
        Course undefined;
        undefined.column[1][2] = undefined.size = bad;
        BOOST_TEST(!(after(found, apart, carried, going, Carrier(map, placement, undefined)).gap > 0));
        for (double Placement::*const number : {&Placement::error, &Placement::scale}) {
          Placement wrong = placement;
          wrong.*number = double(bad);
          BOOST_TEST(!(after(found, apart, carried, going, Carrier(map, wrong, {})).gap > 0));
          carry(Carrier(map, wrong, {}), s.from, s.lane, carried_wrong);
        }
        BOOST_TEST(!(after(found, apart, carried_wrong, going, Carrier(map, placement, {})).gap > 0));
      }
    }
}

BOOST_AUTO_TEST_CASE(of_several_lanes_that_which_is_used_up_first_tells_how_long)
{
  // The least gap and its rate hold for each of them, on the same course.
  Random random(4);
  int several = 0, wrong = 0, longest = 0;
  for (int k = 0; k < 400; ++k) {
    const Scene s = scene(random, k);
    const Box_map map = s.before.map(), moved = s.after.map();
    Certified_gaps found;
    certified_gaps(s.boxes, map, s.from, s.lane, s.apex, found);
    const Placement before(map), after(moved);
    const Carrier carrier(moved, after, Course(before, after));
    Carried_box carried;
    carry_now(Carrier(map, before, {}), s.from, s.lane, carried);
    const Going_box going(s.from, s.lane);
    for (const auto version : least_after()) {
      unsigned kept = 0;
      double least = std::numeric_limits<double>::infinity(), soonest = least;
      std::array<Gap_and_rate, lanes> alone;
      for (int lane = 0; lane < int(lanes); ++lane) {
        alone[lane] = version(found, 1u << lane, carried, going, carrier);
        if (!(found.gap[lane] > 0 && alone[lane].gap > 0)) continue;
        kept |= 1u << lane;
        least = std::min(least, alone[lane].gap);
        soonest = std::min(soonest, alone[lane].gap / alone[lane].rate);
      }
      if ((kept & (kept - 1)) == 0) continue;
      ++several;
      const Gap_and_rate all = version(found, kept, carried, going, carrier);
      wrong += all.gap != least;
      for (int lane = 0; lane < int(lanes); ++lane)
        if (kept >> lane & 1)
          for (const double steps : {0.0, 0.5 * all.gap / all.rate, all.gap / all.rate})
            wrong += steps <= 1e30 && alone[lane].gap - steps * alone[lane].rate <
                                          (all.gap - steps * all.rate) * (1 - 1e-5) - 1e-6 * all.gap;
      longest += std::abs(all.gap / all.rate - soonest) <= 1e-5 * soonest || !(soonest < 1e30);
    }
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(longest == several);
  BOOST_TEST(several > 300);
}

BOOST_AUTO_TEST_SUITE_END()
