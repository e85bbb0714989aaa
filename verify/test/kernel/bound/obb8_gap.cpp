#include "tetracone/kernel/bound/obb8_gap.h"

#include "tetracone/kernel/bound/oriented_box.h"
#include "tetracone/kernel/bound/relative_motion.h"
#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/simd_versions.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace tetracone::kernel {

using Certify = void(const Obb8&, const Box_map&, const Obb8&, int, float, Certified_gaps&);
using Least_after = double(const Certified_gaps&, unsigned, const Carried_box&, const Box_map&, double);

std::vector<Certify*> certifying()
{
  return verify::versions_here<Certify>(TETRACONE_SIMD_VERSIONS(certified_gaps_simd));
}
std::vector<Least_after*> least_after()
{
  return verify::versions_here<Least_after>(TETRACONE_SIMD_VERSIONS(least_gap_after_simd));
}

}  // namespace tetracone::kernel

BOOST_AUTO_TEST_SUITE(test_obb8_gap)

using namespace tetracone::kernel;
namespace rationals = tetracone::verify::rationals;
namespace scenes = tetracone::verify::scenes;
using scenes::integer;
using scenes::Random;
using scenes::real;

namespace {

Vector vector(Random& random, double size = 1)
{
  return size * Vector(real(random, -1, 1), real(random, -1, 1), real(random, -1, 1));
}

void set(Obb8& boxes, int lane, const Vector& centre, const Matrix& axes, const Vector& extent)
{
  for (int i = 0; i < 3; ++i) {
    boxes.centre[i][lane] = float(centre[i]);
    boxes.extent[i][lane] = float(extent[i]);
    for (int k = 0; k < 3; ++k) boxes.axis[i][k][lane] = float(axes(k, i));
  }
}

/// A point of a box, exactly, by its shares of the extents.
rationals::Vector point(const Obb8& boxes, int lane, const std::array<double, 3>& share)
{
  rationals::Vector p;
  for (int k = 0; k < 3; ++k) {
    p[k] = Rational(boxes.origin[k]) + Rational(boxes.centre[k][lane]);
    for (int i = 0; i < 3; ++i)
      p[k] += Rational(share[i]) * Rational(boxes.extent[i][lane]) * Rational(boxes.axis[i][k][lane]);
  }
  return p;
}

struct Placing {
  Pose a, b;
  Local_scale in_a, in_b;

  Box_map map() const { return {a, in_a, b, in_b}; }

  rationals::Vector image(const rationals::Vector& p) const
  {
    rationals::Vector v, column[3];
    for (int k = 0; k < 3; ++k) v[k] = Rational(in_b.origin[k]) + Rational(in_b.unit) * p[k];
    rationals::Vector right = rationals::image(b, v);
    for (int i = 0; i < 3; ++i) {
      right[i] -= a.exact(4 * i + 3);
      for (int j = 0; j < 3; ++j) column[j][i] = a.exact(4 * i + j);
    }
    const Rational whole = rationals::determinant(column[0], column[1], column[2]);
    const Rational x[3] = {rationals::determinant(right, column[1], column[2]),
                           rationals::determinant(column[0], right, column[2]),
                           rationals::determinant(column[0], column[1], right)};
    for (int k = 0; k < 3; ++k) v[k] = (x[k] / whole - Rational(in_a.origin[k])) / Rational(in_a.unit);
    return v;
  }
};

/// The shares of the corner of a box that reaches least along n, in the frame that `map` leads to, null: its own.
std::array<double, 3> lowest(const Obb8& boxes, int lane, const Vector& n, const Box_map* map)
{
  std::array<double, 3> share;
  for (int i = 0; i < 3; ++i) {
    std::array<double, 3> axis = {boxes.axis[i][0][lane], boxes.axis[i][1][lane], boxes.axis[i][2][lane]};
    if (map) axis = map->frame().direction(axis);
    share[i] = n[0] * axis[0] + n[1] * axis[1] + n[2] * axis[2] > 0 ? -1 : 1;
  }
  return share;
}

/// The box itself, or of one that holds a triangle the corner of that which reaches least.
std::array<double, 3> lowest_point(const Obb8& boxes, int lane, float apex, const Vector& n, const Box_map& map)
{
  if (apex == no_apex) return lowest(boxes, lane, n, &map);
  const auto along = [&](const std::array<double, 3>& share) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      const auto axis = map.frame().direction(
          std::array<double, 3>{boxes.axis[i][0][lane], boxes.axis[i][1][lane], boxes.axis[i][2][lane]});
      sum += share[i] * boxes.extent[i][lane] * (n[0] * axis[0] + n[1] * axis[1] + n[2] * axis[2]);
    }
    return sum;
  };
  std::array<double, 3> best = {0, -1, -1};
  for (const std::array<double, 3>& corner : {std::array<double, 3>{0, 1, -1}, {0, apex, 1}})
    if (along(corner) < along(best)) best = corner;
  return best;
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
  p = {scenes::rounded(scenes::random_rotation(random)),
       scenes::random_rotation(random),
       {scenes::real_vertex(random, 2), std::ldexp(1.0, integer(random, -3, 3))},
       {scenes::real_vertex(random, 2), std::ldexp(1.0, integer(random, -3, 3))}};
  auto b = p.b.entries();
  if (kind % 4 == 1)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) b[4 * i + j] *= 1.7;
  if (kind % 5 == 2) {
    auto a = p.a.entries();
    for (int i = 0; i < 3; ++i) {
      a[4 * i + 3] += 0x1p33 * (i + 1);
      b[4 * i + 3] += 0x1p33 * (i + 1);
    }
    p.a = Pose(a);
  }
  if (kind % 3 != 0) p.b = Pose(b);
  s.lane = integer(random, 0, 7);
  const double small = kind % 7 < 2 ? 1e-3 : 0.3;
  Vector extent = small * Vector(real(random, 0, 1), real(random, 0, 1), real(random, 0, 1));
  if (kind % 2 == 0) {
    extent[0] = 0;
    s.apex = float(real(random, -1, 1));
  }
  for (int i = 0; i < 3; ++i) s.from.origin[i] = float(real(random, -0.25, 0.25));
  set(s.from, s.lane, vector(random, 0.4), detail::axes_from(vector(random), vector(random)), extent);
  rationals::Vector middle = p.image(point(s.from, s.lane, {0, 0, 0}));
  const double near = small * nearest_double(Rational(p.in_b.unit / p.in_a.unit)) * (kind % 4 == 1 ? 1.7 : 1);
  for (int i = 0; i < 3; ++i)
    s.boxes.origin[i] = float(nearest_double(middle[i]) + near * real(random, -1, 1) * (kind % 6 == 0 ? 300 : 2));
  for (int other = 0; other < int(lanes); ++other) {
    const Vector e = near * Vector(real(random, 0, 1), real(random, 0, 1), real(random, 0, 1));
    const Vector centre = vector(random, 2 * near);
    set(s.boxes, other, centre, detail::axes_from(vector(random), vector(random)), e);
    s.boxes.reach = maximum(s.boxes.reach, float(e.sum() + centre.norm()) * 1.00001f);
  }
  s.boxes.lane_count = 8;

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

}  // namespace

BOOST_AUTO_TEST_CASE(boxes_are_as_far_apart_along_its_axis_as_a_gap_says_and_after_a_step_too)
{
  Random random(1);
  int gaps = 0, wrong = 0, short_axes = 0, after = 0, wrong_after = 0, kept = 0;
  double tightest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 900; ++k) {
    const Scene s = scene(random, k);
    const Box_map map = s.before.map(), moved = s.after.map();
    BOOST_TEST_REQUIRE(map.is_similarity());
    Certified_gaps found;
    certifying()[std::size_t(k) % certifying().size()](s.boxes, map, s.from, s.lane, s.apex, found);
    const Carried_box carried(map, s.from, s.lane, 0);
    const double turned = linear_step(map.frame(), moved.frame());
    for (int lane = 0; lane < int(lanes); ++lane) {
      if (!(found.gap[lane] > 0)) continue;
      ++gaps;
      const Vector n(found.axis[0][lane], found.axis[1][lane], found.axis[2][lane]);
      const rationals::Vector exact_n = {Rational(n[0]), Rational(n[1]), Rational(n[2])};
      short_axes += n.norm() > 1 + 1e-5 || n.norm() < 1e-4;
      const rationals::Vector p = point(s.boxes, lane, lowest(s.boxes, lane, -n, nullptr));
      const auto q = point(s.from, s.lane, lowest_point(s.from, s.lane, s.apex, n, map)), at = s.before.image(q);
      wrong += is_less(exact_n, p, at, found.gap[lane]);
      const double exact = nearest_double(rationals::inner(exact_n, rationals::minus(at, p)));
      tightest = std::min(tightest, (exact - found.gap[lane]) / exact);
      // The step.
      const double left =
          least_after()[std::size_t(lane) % least_after().size()](found, 1u << lane, carried, moved, turned);
      const auto q_after = point(s.from, s.lane, lowest_point(s.from, s.lane, s.apex, n, moved));
      ++after;
      wrong_after += is_less(exact_n, p, s.after.image(q_after), left);
      kept += left > 0;
    }
  }
  BOOST_TEST_MESSAGE("gaps " << gaps << ", left after a step " << kept << ", tightest by " << tightest);
  BOOST_TEST(wrong == 0);
  BOOST_TEST(wrong_after == 0);
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
  const Carried_box carried(s.before.map(), s.from, s.lane, 0);
  for (const auto after : least_after()) {
    BOOST_TEST(!(after(found, 255, carried, no_similarity.map(), std::numeric_limits<double>::infinity()) > 0));
    BOOST_TEST(!(after(found, 255, carried, no_similarity.map(), std::numeric_limits<double>::quiet_NaN()) > 0));
    BOOST_TEST(!(after(found, 255, carried, Box_map(), 0) > 0));
  }
}

BOOST_AUTO_TEST_SUITE_END()
