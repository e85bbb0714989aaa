#include "tetracone/kernel/bound/obb8_ray.h"

#include "tetracone/kernel/bound/oriented_box.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/simd_versions.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_obb8_ray)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

inline auto ray_versions() { return TETRACONE_VERSIONS_HERE(ray_lanes_simd); }

Vector unit_vector(Random& random)
{
  Vector v;
  do v = Vector(real(random, -1, 1), real(random, -1, 1), real(random, -1, 1));
  while (!(v.norm() > 0.1 && v.norm() < 1));
  return v.normalized();
}

/// A ray in a model's units, and in its local ones without rounding.
struct Scene {
  Local_scale scale;
  Vertex origin, direction;

  /// A ray to `target` along `along`, in local units, from `way` before it; up to what doubles round.
  Scene(Random& random, const Vector& target, const Vector& along, double way)
  {
    scale.unit = std::ldexp(1.0, 90 * integer(random, -2, 2));
    const double length = real(random, 0.5, 1) / along.norm_infinity();
    for (int k = 0; k < 3; ++k) {
      scale.origin[k] = scale.unit * integer(random, -9, 9) * 0.125;
      origin[k] = scale.origin[k] + scale.unit * (target[k] - way * along[k]);
      direction[k] = 2 * length * along[k];
    }
  }

  rationals::Vector local_origin() const
  {
    return rationals::times(1 / Rational(scale.unit),
                            rationals::minus(rationals::exactly(origin), rationals::exactly(scale.origin)));
  }
  rationals::Vector local_direction() const
  {
    return rationals::times(1 / Rational(scale.unit), rationals::exactly(direction));
  }
};

/// From t on, and up to it.
struct Span {
  Rational first, last;

  bool empty() const { return first > last; }

  /// Where |at + t step| <= reach.
  void clip(const Rational& at, const Rational& step, const Rational& reach)
  {
    if (step == 0) {
      if (abs(at) > reach) last = first - 1;
      return;
    }
    const Rational one = (-at - reach) / step, other = (-at + reach) / step;
    const Rational &in = one < other ? one : other, &out = one < other ? other : one;
    if (in > first) first = in;
    if (out < last) last = out;
  }
};

rationals::Vector vector_of(const float* x, const float* y, const float* z, int lane)
{
  return {Rational(x[lane]), Rational(y[lane]), Rational(z[lane])};
}

/// The t >= 0 of the ray's points x in the box, |x_k| <= 1: by Cramer's rule, from the floats of the box.
Span span_of(const Scene& scene, const Obb8& boxes, int lane)
{
  using namespace rationals;
  const rationals::Vector o = scene.local_origin(), d = scene.local_direction();
  Span span{0, Rational(0x1p40)};
  for (int k = 0; k < 3; ++k) span.clip(o[k], d[k], 1);
  std::array<rationals::Vector, 3> axis;
  for (int i = 0; i < 3; ++i) axis[i] = vector_of(boxes.axis[i][0], boxes.axis[i][1], boxes.axis[i][2], lane);
  const rationals::Vector centre =
      plus(vector_of(boxes.centre[0], boxes.centre[1], boxes.centre[2], lane),
           {Rational(boxes.origin[0]), Rational(boxes.origin[1]), Rational(boxes.origin[2])});
  const rationals::Vector from = minus(o, centre);
  const Rational volume = determinant(axis[0], axis[1], axis[2]);
  for (int i = 0; i < 3; ++i) {
    const rationals::Vector normal = outer(axis[(i + 1) % 3], axis[(i + 2) % 3]);
    span.clip(inner(normal, from) / volume, inner(normal, d) / volume, Rational(boxes.extent[i][lane]));
  }
  return span;
}

/// A box of which one corner, or an inner point of a face or an edge, is `at`. It lies on one side of a plane through
/// that point which the ray is in, moved by `off` away from that plane.
void put(Obb8& boxes, int lane, Random& random, const Vector& at, const Vector& along, double off)
{
  // Some have an axis across the ray.
  const Vector first = unit_vector(random), across = along.cross(first).normalized();
  const Matrix axes = detail::axes_from(integer(random, 0, 2) ? first : across, unit_vector(random));
  Vector extent(real(random, 0, 0.4), real(random, 0, 0.4), real(random, 0, 0.4));
  if (integer(random, 0, 2) == 0) extent[integer(random, 0, 2)] = 0;
  if (integer(random, 0, 3) == 0) extent *= 1e-3;
  // Across the ray: any direction, or one in which a whole face or edge is first.
  Vector side = along.cross(integer(random, 0, 1) ? unit_vector(random) : axes.col(integer(random, 0, 2)));
  side = side.normalized();
  Vector centre = at;
  for (int i = 0; i < 3; ++i) {
    const float e = float(extent[i]);
    boxes.extent[i][lane] = e;
    Vector rounded;
    for (int k = 0; k < 3; ++k) rounded[k] = boxes.axis[i][k][lane] = float(axes(k, i));
    const double slope = side.dot(rounded);
    centre += (std::abs(slope) < 1e-6 ? real(random, -1, 1) : slope < 0 ? -1.0 : 1.0) * double(e) * rounded;
  }
  centre += off * side;
  for (int k = 0; k < 3; ++k) boxes.centre[k][lane] = float(centre[k] - double(boxes.origin[k]));
}

/// Where the ray comes from: near, as far as is taken, and in between; and about where a start is moved along it.
double any_way(Random& random)
{
  switch (integer(random, 0, 4)) {
    case 0: return real(random, 0, 2);
    case 1: return real(random, 1, 4);
    case 2: return std::ldexp(real(random, 1, 2), integer(random, 1, 28));
    case 3: return 0x1p28 * real(random, 1, 2);
    default: return real(random, -1, 0.1);  // in or behind the box
  }
}

BOOST_AUTO_TEST_CASE(what_the_ray_meets_is_never_missed)
{
  Random random(1);
  int met = 0, touched = 0, missed = 0, beside = 0, found_beside = 0, gone = 0;
  for (const auto lanes_of : ray_versions())
    for (int round = 0; round < 600; ++round) {
      const Vector along = unit_vector(random), target = real(random, 0, 0.9) * unit_vector(random);
      const Scene scene(random, target, along, any_way(random));
      BOOST_TEST_REQUIRE(Local_ray::may_be_local(scene.scale, scene.origin));
      Obb8 boxes{};
      boxes.lane_count = int(lanes);
      for (float& x : boxes.origin) x = float(real(random, -1, 1));
      // Just touched or just missed; by far more than the slack; or well within.
      const int kind = integer(random, 0, 3);
      const double off = kind == 0 ? 0x1p-13 : kind == 1 ? -real(random, 0, 0.01) : integer(random, -6, 2) * 0x1p-24;
      for (int lane = 0; lane < int(lanes); ++lane)
        put(boxes, lane, random, target + real(random, -0.1, 0.1) * along, along, off);

      const auto ray = Local_ray::of(scene.scale, scene.origin, scene.direction);
      std::array<Span, lanes> spans;
      for (int lane = 0; lane < int(lanes); ++lane) spans[std::size_t(lane)] = span_of(scene, boxes, lane);
      if (!ray) {
        ++gone;
        for (const Span& span : spans) BOOST_TEST(span.empty());
        continue;
      }
      // Up to the first box of them all, or everywhere.
      const rationals::Vector d = scene.local_direction();
      const Rational square = rationals::inner(d, d);
      const auto way_to = [&](const Rational& t) {
        return Rational(t).get_d() * std::sqrt(square.get_d()) - ray->skipped;
      };
      double limit = Local_ray::length;
      if (integer(random, 0, 1) == 0)
        for (const Span& span : spans)
          if (!span.empty()) limit = std::min(limit, way_to(span.first) + 0x1p-20);
      Lane_entries nearest{};
      const unsigned found = lanes_of(boxes, *ray, limit, nearest.data());
      for (int lane = 0; lane < int(lanes); ++lane) {
        const Span& span = spans[std::size_t(lane)];
        const bool is_found = found >> lane & 1;
        if (span.empty()) {
          missed += kind >= 2;
          beside += kind == 0;
          found_beside += kind == 0 && is_found;
          continue;
        }
        if (way_to(span.first) > limit - 0x1p-21) continue;
        ++met;
        touched += kind >= 2;
        BOOST_TEST(is_found, "kind " << kind << ", " << ray->skipped << " skipped");
        // nearest + skipped <= t |d|.
        const Rational from = Rational(nearest[std::size_t(lane)]) + Rational(ray->skipped);
        BOOST_TEST((from <= 0 || from * from <= span.first * span.first * square));
      }
    }
  BOOST_TEST(met > 1000);
  BOOST_TEST(touched > 500);
  BOOST_TEST(missed > 500);
  // Rays beyond the slack are seldom accepted.
  BOOST_TEST(beside > 1000);
  BOOST_TEST(found_beside < beside / 50);
}

BOOST_AUTO_TEST_CASE(a_ray_that_is_dropped_does_not_come_near_the_body)
{
  Random random(2);
  int dropped = 0, kept = 0;
  for (int k = 0; k < 4000; ++k) {
    // About as far from the local origin as the body reaches, and as rays are kept; or away from it.
    const Vector along = unit_vector(random), across = along.cross(unit_vector(random)).normalized();
    const double beside = integer(random, 0, 1) ? real(random, 1.6, 2.1) : real(random, 0, 1.7);
    const Scene scene(random, beside * across, along, integer(random, 0, 3) ? any_way(random) : real(random, -3, 0));
    const auto ray = Local_ray::of(scene.scale, scene.origin, scene.direction);
    ++(ray ? kept : dropped);
    const rationals::Vector o = scene.local_origin(), d = scene.local_direction();
    const Rational ascent = rationals::inner(o, d), square = rationals::inner(d, d), away = rationals::inner(o, o);
    // The least squared distance from the local origin.
    const Rational least = ascent >= 0 ? away : Rational(away - ascent * ascent / square);
    if (!ray) {
      BOOST_TEST(least > 3);
      continue;
    }
    // All within sqrt(3) lies between the start and `length` farther, the rest of rounding left out.
    if (least >= 3 || away <= 3) continue;
    const double middle = -ascent.get_d() / std::sqrt(square.get_d()), half = std::sqrt(3 - least.get_d());
    if (middle + half < 0) continue;
    BOOST_TEST(std::max(middle - half, 0.0) >= ray->skipped - 1e-6);
    BOOST_TEST(middle + half <= ray->skipped + Local_ray::length + 1e-6);
  }
  BOOST_TEST(dropped > 500);
  BOOST_TEST(kept > 1000);
}

BOOST_AUTO_TEST_CASE(what_is_no_number_or_too_far_is_not_left_out)
{
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  const Local_scale scale{{0, 0, 0}, 1};
  BOOST_TEST(Local_ray::may_be_local(scale, {0x1p29, -0x1p29, 0}));
  for (const double x : {0x1.0000001p29, -0x1.0000001p29, infinity, -infinity, nan, 0x1p1023})
    for (int k = 0; k < 3; ++k) {
      Vertex origin = {0.5, 0.5, 0.5};
      origin[std::size_t(k)] = x;
      BOOST_TEST(!Local_ray::may_be_local(scale, origin));
    }
  BOOST_TEST(!Local_ray::may_be_local({{0, 0, 0}, 0x1p-201}, {0, 0, 0}));
  BOOST_TEST(!Local_ray::may_be_local({{nan, 0, 0}, 1}, {0, 0, 0}));

  // A box before the ray, one number of which, or of the ray or its limit, is none.
  const Local_ray ray{{-1, 0, 0}, {1, 0, 0}, 0};
  for (const auto lanes_of : ray_versions()) {
    Obb8 good{};
    good.lane_count = int(lanes);
    for (std::size_t lane = 0; lane < lanes; ++lane)
      for (int i = 0; i < 3; ++i) {
        good.axis[i][i][lane] = 1;
        good.extent[i][lane] = 0.25f;
      }
    Lane_entries nearest{};
    const auto all_found = [&](const Obb8& boxes, const Local_ray& of, double limit) {
      return lanes_of(boxes, of, limit, nearest.data()) == 0xff;
    };
    BOOST_TEST(all_found(good, ray, Local_ray::length));
    BOOST_TEST(all_found(good, ray, infinity));
    BOOST_TEST(all_found(good, ray, nan));
    BOOST_TEST(lanes_of(good, ray, 0.5, nearest.data()) == 0);
    const float undefined = std::numeric_limits<float>::quiet_NaN();
    for (int i = 0; i < 3; ++i) {
      std::array<Obb8, 7> wrong;
      wrong.fill(good);
      wrong[0].centre[i][3] = wrong[1].extent[i][3] = wrong[2].origin[i] = undefined;
      wrong[3].extent[i][3] = std::numeric_limits<float>::infinity();
      for (int k = 0; k < 3; ++k) wrong[std::size_t(4 + k)].axis[i][k][3] = undefined;
      for (const Obb8& boxes : wrong) BOOST_TEST(all_found(boxes, ray, Local_ray::length));
    }
    // Lanes that hold nothing are not met.
    Obb8 few = good;
    few.lane_count = 3;
    BOOST_TEST(lanes_of(few, ray, Local_ray::length, nearest.data()) == 7);
  }
}

BOOST_AUTO_TEST_SUITE_END()
