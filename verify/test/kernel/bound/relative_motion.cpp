#include "tetracone/kernel/bound/relative_motion.h"

#include "verify/test/support/placed_boxes.h"
#include "verify/test/support/simd_versions.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_relative_motion)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

inline auto stray_bounds() { return TETRACONE_VERSIONS_HERE(stray_bound_simd); }
inline auto pace_bounds() { return TETRACONE_VERSIONS_HERE(pace_bound_simd); }
inline auto all_steps_along() { return TETRACONE_VERSIONS_HERE(steps_along_simd); }

Box_corners unit_box() { return Box_corners({0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}); }

Pose turned(const Pose& pose, double angle, const std::array<double, 3>& shift)
{
  const double c = std::cos(angle), s = std::sin(angle);
  auto m = pose.entries();
  for (int j = 0; j < 4; ++j) {
    const double x = m[j], y = m[4 + j];
    m[j] = c * x - s * y;
    m[4 + j] = s * x + c * y;
  }
  for (int i = 0; i < 3; ++i) m[4 * i + 3] += shift[i];
  return Pose(m);
}

/// Both bodies before, and after a step. Steps are small and large ones, of both bodies, none at all, of other sizes,
/// sheared, in fractions, and far from the origin.
std::array<Placing, 2> step(Random& random, int kind)
{
  Placing p = random_placing(random);
  std::swap(p.a, p.b);
  if (kind % 4 == 1) p.b = random_affine(random, 2);
  if (kind % 5 == 1) move_far(p, 0x1p30);
  Placing q = p;
  const double size = std::ldexp(real(random, -1, 1), -integer(random, 0, 60));
  switch (kind % 6) {
    case 0: q.b = turned(p.b, 0, {size * real(random, -1, 1), size * real(random, -1, 1), size}); break;
    case 1: q.b = turned(p.b, size, {0, 0, 0}); break;
    case 2: q.a = turned(p.a, size, {size, -size, 0}); break;
    case 3: q.b = random_rotation(random); break;
    case 4: break;                         // at rest
    default: q.b = scaled(p.b, 1 + size);  // grows
  }
  return {p, q};
}

BOOST_AUTO_TEST_CASE(no_point_of_the_box_strays_farther_from_a_course_than_the_bound)
{
  Random random(1);
  double worst[2] = {0, 0}, worst_pace = 0;
  int known = 0, beyond = 0, beyond_pace = 0;
  for (int k = 0; k < 2400; ++k) {
    const auto [p, q] = step(random, k);
    const Placement before(p.map()), after(q.map());
    // On no course, the way itself; or on one that leads nearby, or elsewhere.
    const bool is_on_course = k % 2 == 1;
    Placing near = p;
    if (is_on_course) {
      auto b = (k % 4 == 1 ? q : p).b.entries();
      for (double& x : b) x += std::ldexp(real(random, -1, 1), -integer(random, 4, 40));
      near.b = Pose(b);
    }
    const Course course = is_on_course ? Course(before, Placement(near.map())) : Course();
    const double steps = is_on_course ? integer(random, 0, 4096) * Course::least_step : 0;
    const std::array<double, 3> centre = real_vertex(random, 0.4);
    std::array<std::array<double, 3>, 3> half_edge;
    for (auto& edge : half_edge) edge = real_vertex(random, k % 7 == 0 ? 0 : 0.2);
    const Box_corners box(centre, half_edge);
    double farthest = 0, farthest_on_course = 0;
    const auto bounds = stray_bounds();
    const double bound = bounds[std::size_t(k) % bounds.size()](course, steps, before, after, box),
                 pace = pace_bounds()[std::size_t(k) % bounds.size()](course, box);
    if (!(bound < std::numeric_limits<double>::infinity())) continue;
    ++known;
    for (int corner = 0; corner < 10; ++corner) {
      std::array<double, 3> at = centre;  // rounded: within the box but for far less than the bound's roundings
      for (int j = 0; j < 3; ++j) {
        const double s = corner < 8 ? (corner >> j & 1 ? 1 : -1) * (1 - 0x1p-45) : real(random, -1, 1);
        for (int i = 0; i < 3; ++i) at[i] += s * half_edge[j][i];
      }
      if (std::abs(at[0]) > 1 || std::abs(at[1]) > 1 || std::abs(at[2]) > 1) continue;
      const rationals::Vector gone = rationals::minus(q.image(rationals::exactly(at)), p.image(rationals::exactly(at)));
      Rational square = 0, square_on_course = 0;
      for (int i = 0; i < 3; ++i) {
        Rational on = course.column[3][i];
        for (int j = 0; j < 3; ++j) on += Rational(course.column[j][i]) * Rational(at[j]);
        const Rational strayed = gone[i] - Rational(steps) * on;
        square += strayed * strayed;
        square_on_course += on * on;
      }
      beyond += square > Rational(bound) * Rational(bound);
      beyond_pace += square_on_course > Rational(pace) * Rational(pace);
      farthest = std::max(farthest, std::sqrt(nearest_double(square)));
      farthest_on_course = std::max(farthest_on_course, std::sqrt(nearest_double(square_on_course)));
    }
    worst[is_on_course] = std::max(worst[is_on_course], farthest / bound);
    worst_pace = std::max(worst_pace, farthest_on_course / pace);
  }
  BOOST_TEST(beyond == 0);
  BOOST_TEST(beyond_pace == 0);
  BOOST_TEST(known > 2200);
  for (const double share : {worst[0], worst[1], worst_pace}) BOOST_TEST(share > 0.99);  // attained at corners
}

BOOST_AUTO_TEST_CASE(the_errors_of_the_maps_are_in_the_bound)
{
  // Far from the origin, where images are known to no more than 2^-22: at rest they may have moved by twice as much.
  auto far = Pose().entries();
  far[3] = 0x1p30;
  far[7] = 0.1;
  const Placing p{Pose(far), Pose(far), {{0.1, 0.2, 0.3}, 1}, {{0.3, 0.2, 0.1}, 1}};
  const Relative_frame frame(p.a, p.in_a, p.b, p.in_b);
  for (const auto bound : stray_bounds())
    BOOST_TEST(bound({}, 0, Placement(p.map()), Placement(p.map()), unit_box()) >= 2 * std::sqrt(3.0) * frame.error());
}

BOOST_AUTO_TEST_CASE(a_course_is_known_by_its_steps)
{
  Random random(3);
  int whole = 0, parts = 0;
  for (int k = 0; k < 300; ++k) {
    const auto [p, q] = step(random, 6 * k + k % 3);  // no rest
    const Placement before(p.map()), after(q.map());
    const Course course(before, after);
    if (!(course.size > 0x1p-40f)) continue;
    for (const auto steps_along : all_steps_along()) {
      const double steps = steps_along(course, before, after);
      whole += std::abs(steps - 1) <= Course::least_step;
      ++parts;
      BOOST_TEST(std::fmod(steps, Course::least_step) == 0);
      BOOST_TEST(steps_along(course, before, before) == 0);
      BOOST_TEST(steps_along(course, after, before) == 0);
      BOOST_TEST(steps_along(Course(), before, after) == 0);
      Placement undefined = after;
      undefined.column[3][1] = std::numeric_limits<double>::quiet_NaN();
      BOOST_TEST(steps_along(course, before, undefined) == 0);
    }
  }
  BOOST_TEST(whole == parts);
  BOOST_TEST(parts > 400);
}

BOOST_AUTO_TEST_CASE(a_course_is_reversed_in_the_frame_of_what_is_on_it)
{
  // A point q of B goes on in A's frame by a step. In B's frame as it is, it goes by the reversed step, the other way.
  Random random(5);
  int wrong = 0, asked = 0;
  double most = 0;
  for (int k = 0; k < 300; ++k) {
    const auto [p, q] = step(random, 4 * k);  // similarities
    const Placement of_b(p.map());
    const Course course(of_b, Placement(q.map()));
    const Placing other{p.b, p.a, p.in_b, p.in_a};
    const Placement of_a(other.map());
    if (!(of_a.error <= of_a.scale * 0x1p-25)) continue;
    const Course reversed = course.reversed(of_a);
    const rationals::Vector origin = other.image({0, 0, 0});
    float sum = 0;
    for (int j = 0; j < 4; ++j) {
      const rationals::Vector exact = rationals::minus(
          other.image({double(course.column[j][0]), double(course.column[j][1]), double(course.column[j][2])}), origin);
      for (int i = 0; i < 3; ++i) {
        const double off = std::abs(nearest_double(exact[i] + Rational(reversed.column[j][i])));
        ++asked;
        wrong += off > 0x1p-23 * double(reversed.size);
        most = std::max(most, off / double(reversed.size));
        sum += std::abs(reversed.column[j][i]);
      }
    }
    BOOST_TEST(sum <= reversed.size);
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(asked > 2000);
  BOOST_TEST(most > 0x1p-28);
}

BOOST_AUTO_TEST_CASE(what_is_infinite_or_undefined_gives_no_bound)
{
  const Placing unit_placing;
  const Placement unit(unit_placing.map()), none{Box_map()};
  const auto is_bound = [](double x) { return x < std::numeric_limits<double>::infinity(); };
  std::array<double, 12> far = Pose().entries();
  far[3] = 1e300;
  const Placement far_away(Placing{Pose(), Pose(far), {}, {}}.map());
  for (const auto bound : stray_bounds()) {
    BOOST_TEST(is_bound(bound({}, 0, unit, unit, unit_box())));
    BOOST_TEST(!is_bound(bound({}, 0, none, unit, unit_box())));
    BOOST_TEST(!is_bound(bound({}, 0, unit, none, unit_box())));
    BOOST_TEST(!is_bound(bound({}, 0, unit, far_away, unit_box())));
    BOOST_TEST(!is_bound(bound(Course(unit, far_away), 1, unit, unit, unit_box())));
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
      for (int j = 0; j < 4; ++j)
        for (int k = 0; k < 3; ++k) {
          Placement undefined = unit;
          undefined.column[j][k] = bad;
          BOOST_TEST(!is_bound(bound({}, 0, unit, undefined, unit_box())));
          BOOST_TEST(!is_bound(bound(Course(unit, undefined), 1, unit, unit, unit_box())));
          for (const auto pace : pace_bounds()) BOOST_TEST(!is_bound(pace(Course(unit, undefined), unit_box())));
        }
  }
}

BOOST_AUTO_TEST_SUITE_END()
