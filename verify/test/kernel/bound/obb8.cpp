#include "tetracone/kernel/bound/obb8.h"

#include "verify/test/support/placed_boxes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_obb8)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

/// Similarities, shears, reflections; far from the origin; bodies of unlike units.
Placing placing(Random& random, int kind)
{
  Placing p = random_placing(random);
  p.a = kind % 2 == 0 ? random_rotation(random, 5, {Rational(1) / 3, 0, 1}) : rounded(random_rotation(random, 5));
  p.b = rounded(random_rotation(random, 5, {1, 0, Rational(1) / 7}));
  if (kind % 3 == 1) p.b = random_affine(random, 2);
  if (kind % 3 == 2) move_far(p, 0x1p30);  // where the translations cancel
  return p;
}

/// The exact image of a point of B's local units in A's world, less that of a point of A's.
Vector exact_difference(const Placing& p, const std::array<double, 3>& in_b, const Vector& in_a)
{
  const auto world = [](const Pose& pose, const Local_scale& units, const auto& local) {
    rationals::Vector v;
    for (int k = 0; k < 3; ++k) v[k] = Rational(units.origin[k]) + Rational(units.unit) * Rational(local[k]);
    return rationals::image(pose, v);
  };
  const rationals::Vector d =
      rationals::minus(world(p.b, p.in_b, in_b), world(p.a, p.in_a, std::array{in_a[0], in_a[1], in_a[2]}));
  return {nearest_double(d[0]), nearest_double(d[1]), nearest_double(d[2])};
}

void set_lane(Obb8& boxes, int lane, Random& random)
{
  std::vector<Vector> points;
  for (int k = 0; k < 6; ++k) points.push_back(vector(random, 0.5));
  store_lane(boxes, lane, fitted_box(points, 1).axes, vector_of(boxes.origin), points);
}

BOOST_AUTO_TEST_CASE(a_mapped_box_holds_the_exact_images_of_its_points_but_for_the_slack)
{
  // Held: no farther out than the box along any of many directions. The slack is meant for the two boxes of a
  // comparison and 15 axes, so one box alone never needs a quarter of it.
  Random random(1);
  double worst = 0;
  int similar = 0, general = 0;
  for (int k = 0; k < 900; ++k) {
    const Placing p = placing(random, k);
    const Box_map map(p.a, p.in_a, p.b, p.in_b);
    Obb8 from{}, boxes{};
    for (int i = 0; i < 3; ++i) {
      from.origin[i] = float(real(random, -0.5, 0.5));
      boxes.origin[i] = float(real(random, -0.5, 0.5));
    }
    boxes.reach = 1;
    const int lane = integer(random, 0, 7);
    set_lane(from, lane, random);
    const Single_box box = map(boxes, from, lane);
    BOOST_TEST_REQUIRE(std::isfinite(box.slack));
    ++(map.is_similarity() ? similar : general);
    for (int j = 0; j < 3; ++j) {
      const Vector normal = vector_of(box.edge[(j + 1) % 3]).cross(vector_of(box.edge[(j + 2) % 3]));
      BOOST_TEST(std::abs(vector_of(box.edge[j]).norm() - 1) < 1e-6);
      BOOST_TEST((normal - vector_of(box.normal[j])).norm() < 1e-6);
    }
    const Relative_frame frame(p.a, p.in_a, p.b, p.in_b);
    BOOST_TEST(map.is_similarity() == frame.is_similarity());
    BOOST_TEST(map.scale() == frame.scale());
    BOOST_TEST(double(map.stretch()) >= frame.scale());
    BOOST_TEST(double(map.stretch()) <= frame.scale() * (1 + 0x1p-18));
    Matrix linear;
    for (int i = 0; i < 3; ++i) {
      BOOST_TEST(map.column(3)[i] == frame.offset()[i]);
      for (int j = 0; j < 3; ++j) {
        linear(i, j) = p.a[4 * i + j] * p.in_a.unit;
        BOOST_TEST(map.column(j)[i] == frame.linear()[i][j]);
        BOOST_TEST(std::abs(map.direction(j)[i] * frame.scale() - frame.linear()[i][j]) <=
                   0x1p-22 * frame.scale() + 0x1p-24 * std::abs(frame.linear()[i][j]));
      }
    }
    for (int corner = 0; corner < 8; ++corner) {
      std::array<double, 3> at;
      for (int i = 0; i < 3; ++i) {
        at[i] = double(from.origin[i]) + from.centre[i][lane];
        for (int j = 0; j < 3; ++j)
          at[i] += (corner >> j & 1 ? 1 : -1) * double(from.extent[j][lane]) * from.axis[j][i][lane];
      }
      // The corner seen from the box's centre, solved in A's local units.
      const Vector centre = vector_of(boxes.origin) + vector_of(box.centre);
      const Vector out = solved(linear, exact_difference(p, at, centre));
      for (int n = 0; n < 12; ++n) {
        Vector direction = vector(random).normalized();
        if (n < 3) direction = Vector::unit(n);
        if (n >= 3 && n < 6) direction = vector_of(box.normal[n - 3]);
        double reach = 0;
        for (int j = 0; j < 3; ++j) reach += box.extent[j] * std::abs(direction.dot(vector_of(box.edge[j])));
        worst = maximum(worst, (std::abs(direction.dot(out)) - reach) / box.slack);
      }
    }
  }
  BOOST_TEST(worst <= 0.25);
  BOOST_TEST(worst > -1);
  BOOST_TEST(similar > 200);
  BOOST_TEST(general > 200);
}

BOOST_AUTO_TEST_CASE(edges_so_short_that_their_squares_underflow_have_length_1_or_no_lane_is_apart)
{
  Random random(9);
  int unknown = 0, known = 0, wrong = 0;
  for (int exponent = -1070; exponent <= -300; ++exponent)
    for (int axis = 0; axis < 3; ++axis) {
      std::array<double, 12> entries = Pose().entries();
      entries[5 * axis] = std::ldexp(real(random, 1, 2), exponent);
      const Box_map map(Pose(), {}, Pose(entries), {});
      Obb8 from{}, boxes{};
      const std::vector<Vector> corners = {Vector(0.5, 0.25, 0.125), Vector(-0.5, -0.25, -0.125),
                                           Vector(0.5, -0.25, 0.125), Vector(-0.5, 0.25, -0.125)};
      store_lane(from, 0, Matrix::identity(), Vector(), corners);
      const Single_box box = map(boxes, from, 0);
      if (!std::isfinite(box.slack)) {
        ++unknown;
        continue;
      }
      ++known;
      for (int j = 0; j < 3; ++j) wrong += !(std::abs(vector_of(box.edge[j]).norm() - 1) <= 1e-6);
    }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(unknown > 1000);
  BOOST_TEST(known > 300);
}

BOOST_AUTO_TEST_CASE(slack_grows_with_each_of_its_causes_and_is_never_0)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  BOOST_TEST(obb8_slack(0, 0) > 0);
  for (const double m : {1e-30, 0.5, 1.0, 3.0, 1e6}) {
    BOOST_TEST(double(obb8_slack(m, 0)) >= box_rounding * m);
    BOOST_TEST(double(obb8_slack(m, 1e-3)) >= box_rounding * m + position_factor * 1e-3);
  }
  BOOST_TEST(std::isinf(obb8_slack(1, infinity)));
  BOOST_TEST(std::isinf(obb8_slack(infinity, 0)));
  BOOST_TEST(std::isinf(obb8_slack(1e300, 0)));

  // For a map without a bound of its error, slack is infinite wherever the box is.
  const Box_map unknown{Relative_frame()};
  BOOST_TEST(std::isinf(unknown.slack(1, 1)));
  // The slack of a carried box does not ask for the distance.
  const Box_map map{Pose(), {}, Pose(), {}};
  for (const float reach : {0.01f, 1.0f, 2.0f})
    for (const float size : {0.001f, 1.0f}) {
      const double of_size = carried_box_rounding * (double(reach) + size);
      BOOST_TEST(double(map.slack(reach, size)) >= of_size * (1 - 0x1p-22));
      BOOST_TEST(double(map.slack(reach, size)) >= double(obb8_slack(0, map.frame().error())));
    }
}

BOOST_AUTO_TEST_SUITE_END()
