#include "tetracone/kernel/bound/relative_motion.h"

#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

BOOST_AUTO_TEST_SUITE(test_relative_motion)

using namespace tetracone::kernel;
namespace rationals = tetracone::verify::rationals;
namespace scenes = tetracone::verify::scenes;
using scenes::integer;
using scenes::Random;
using scenes::real;

namespace {

struct Placing {
  Pose a, b;
  Local_scale in_a, in_b;

  Relative_frame frame() const { return {a, in_a, b, in_b}; }

  /// The exact image of a point in B's local units, in A's.
  rationals::Vector image(const Body_box::Row& p) const
  {
    rationals::Vector v, column[3];
    for (int k = 0; k < 3; ++k) v[k] = Rational(in_b.origin[k]) + Rational(in_b.unit) * Rational(p[k]);
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

/// Both bodies before, and after a step: small and large ones, of both bodies, none at all, of other sizes, sheared, in
/// fractions, and far from the origin.
std::array<Placing, 2> step(Random& random, int kind)
{
  Placing p{scenes::random_rotation(random),
            scenes::rounded(scenes::random_rotation(random, 7)),
            {scenes::real_vertex(random, 2), std::ldexp(1.0, integer(random, -3, 3))},
            {scenes::real_vertex(random, 2), std::ldexp(1.0, integer(random, -3, 3))}};
  if (kind % 4 == 1) p.b = scenes::random_affine(random, 2);
  if (kind % 5 == 1) {
    auto a = p.a.entries(), b = p.b.entries();
    for (int i = 0; i < 3; ++i) {
      a[4 * i + 3] += 0x1p30 * (i + 1);
      b[4 * i + 3] += 0x1p30 * (i + 1);
    }
    p.a = Pose(a);
    p.b = Pose(b);
  }
  Placing q = p;
  const double size = std::ldexp(real(random, -1, 1), -integer(random, 0, 60));
  switch (kind % 6) {
    case 0: q.b = turned(p.b, 0, {size * real(random, -1, 1), size * real(random, -1, 1), size}); break;
    case 1: q.b = turned(p.b, size, {0, 0, 0}); break;
    case 2: q.a = turned(p.a, size, {size, -size, 0}); break;
    case 3: q.b = scenes::random_rotation(random); break;
    case 4: break;  // at rest
    default: {      // grows
      auto b = p.b.entries();
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) b[4 * i + j] *= 1 + size;
      q.b = Pose(b);
    }
  }
  return {p, q};
}

}  // namespace

BOOST_AUTO_TEST_CASE(no_point_of_the_box_moves_farther_than_the_bound)
{
  Random random(1);
  double worst = 0, of_linear = 0;
  int known = 0, beyond = 0, beyond_linear = 0;
  for (int k = 0; k < 1200; ++k) {
    const auto [p, q] = step(random, k);
    const Relative_frame before = p.frame(), after = q.frame();
    Body_box box;
    box.centre = scenes::real_vertex(random, 0.4);
    for (auto& edge : box.half_edge) edge = scenes::real_vertex(random, k % 7 == 0 ? 0 : 0.2);
    const double bound = motion_bound(before, after, box, box.reach());
    if (!(bound < std::numeric_limits<double>::infinity())) continue;
    ++known;
    double farthest = 0;
    for (int corner = 0; corner < 10; ++corner) {
      Body_box::Row at = box.centre;  // rounded: within the box but for far less than the bound's roundings
      for (int j = 0; j < 3; ++j) {
        const double s = corner < 8 ? (corner >> j & 1 ? 1 : -1) * (1 - 0x1p-45) : real(random, -1, 1);
        for (int i = 0; i < 3; ++i) at[i] += s * box.half_edge[j][i];
      }
      if (std::abs(at[0]) > 1 || std::abs(at[1]) > 1 || std::abs(at[2]) > 1) continue;
      const rationals::Vector moved = rationals::minus(q.image(at), p.image(at));
      const Rational square = moved[0] * moved[0] + moved[1] * moved[1] + moved[2] * moved[2];
      beyond += square > Rational(bound) * Rational(bound);
      farthest = std::max(farthest, std::sqrt(nearest_double(square)));
    }
    worst = std::max(worst, farthest / bound);
    // A vector's image, by the maps in double.
    const double change = linear_step(before, after);
    const Body_box::Row v = scenes::real_vertex(random, 1);
    Rational square = 0, length = 0;
    for (int i = 0; i < 3; ++i) {
      Rational x = 0;
      for (int j = 0; j < 3; ++j)
        x += (Rational(after.linear()[i][j]) - Rational(before.linear()[i][j])) * Rational(v[j]);
      square += x * x;
      length += Rational(v[i]) * Rational(v[i]);
    }
    beyond_linear += square > Rational(change) * Rational(change) * length;
    if (square > 0) of_linear = std::max(of_linear, nearest_double(Rational(square / length)) / (change * change));
  }
  BOOST_TEST(beyond == 0);
  BOOST_TEST(beyond_linear == 0);
  BOOST_TEST(known > 1100);
  BOOST_TEST(worst > 0.99);  // at a corner it is as large as the bound
  BOOST_TEST(of_linear > 0.5);
}

BOOST_AUTO_TEST_CASE(what_is_infinite_or_undefined_gives_no_bound)
{
  const Relative_frame unit(Pose(), {}, Pose(), {}), none;
  const Body_box box{{0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  const auto is_bound = [](double x) { return x < std::numeric_limits<double>::infinity(); };
  BOOST_TEST(is_bound(motion_bound(unit, unit, box, box.reach())));
  BOOST_TEST(!is_bound(motion_bound(none, unit, box, box.reach())));
  BOOST_TEST(!is_bound(motion_bound(unit, none, box, box.reach())));
  Body_box undefined = box;
  undefined.centre[1] = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(!is_bound(motion_bound(unit, unit, undefined, box.reach())));
  std::array<double, 12> far = Pose().entries();
  far[3] = 1e300;
  BOOST_TEST(!is_bound(motion_bound(unit, Relative_frame(Pose(), {}, Pose(far), {}), box, box.reach())));
}

BOOST_AUTO_TEST_SUITE_END()
