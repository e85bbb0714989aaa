#include "tetracone/kernel/bound/oriented_box.h"

#include "verify/test/support/placed_boxes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_oriented_box)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

std::vector<Vector> points(Random& random, int count, int kind)
{
  std::vector<Vector> all;
  const Vector a = vector(random), b = vector(random);
  for (int k = 0; k < count; ++k) {
    if (kind == 0) all.push_back(vector(random));
    if (kind == 1) all.push_back(real(random, -1, 1) * a + real(random, -1, 1) * b);  // in a plane
    if (kind == 2) all.push_back(real(random, -1, 1) * a);                            // on a line
    if (kind == 3) all.push_back(a);                                                  // in a point
    if (kind == 4) all.push_back(1e-9 * vector(random) + a);
  }
  return all;
}

/// A point along an axis of a box, from its centre.
double along(const Obb8& boxes, int lane, int i, const Vector& node_origin, const Vector& p)
{
  double sum = 0;
  for (int k = 0; k < 3; ++k) sum += boxes.axis[i][k][lane] * (p[k] - (node_origin[k] + double(boxes.centre[k][lane])));
  return sum;
}

BOOST_AUTO_TEST_CASE(a_stored_box_holds_its_points)
{
  Random random(1);
  for (int k = 0; k < 1500; ++k) {
    const auto all = points(random, 3 + int(random() % 30), k % 5);
    const bool triangle = k % 3 == 0;
    const std::span<const Vector> used =
        triangle ? std::span<const Vector>(all).first(3) : std::span<const Vector>(all);
    const Oriented_box box = triangle ? triangle_box(used.first<3>()) : fitted_box(used, k % 4);
    const Vector origin(0.25f * float(real(random, -1, 1)), 0.5, -0.125);
    const Vector node_origin = origin.in_float();
    Obb8 boxes{};
    store_lane(boxes, 5, box.axes, node_origin, used);
    // Solved in double for the float axes: far more digits than the margin.
    Matrix axes;
    Vector centre, extent;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) axes(j, i) = boxes.axis[i][j][5];
      centre[i] = boxes.centre[i][5] + node_origin[i];
      extent[i] = boxes.extent[i][5];
    }
    for (const Vector& p : used) {
      const Vector s = solved(axes, p - centre);
      for (int i = 0; i < 3; ++i) BOOST_TEST(std::abs(s[i]) <= extent[i] + 1e-15);
    }
    BOOST_TEST(axes.orthonormal_defect() <= axis_defect);
  }
}

BOOST_AUTO_TEST_CASE(boxes_of_triangles_of_any_size_have_orthonormal_axes)
{
  // Down to sides of one denormal: squares of sides and of normals underflow in between.
  Random random(7);
  int wrong = 0, tried = 0;
  for (int exponent = -1074; exponent <= 0; ++exponent)
    for (int k = 0; k < 24; ++k) {
      const double d = std::ldexp(1 + std::abs(real(random, -1, 1)), exponent),
                   e = k % 3 == 0 ? d : std::ldexp(d, -int(random() % 60));
      std::array<Vector, 3> t = {Vector(d, 0, 0), Vector(-d, 0, 0), Vector(k % 2 == 0 ? 0 : d, 0, e)};
      if (k % 4 >= 2)
        for (Vector& p : t) p = Vector(0.5 * p[0] - 0.25 * p[2], 0.5 * p[0] + p[2], p[2] + 0.125 * p[0]);
      for (const Oriented_box& box : {triangle_box(t), fitted_box(t, 2)}) {
        ++tried;
        wrong += !(box.axes.orthonormal_defect() <= 1e-14);
        Obb8 boxes{};
        store_lane(boxes, 0, box.axes, Vector(), t);
        for (int i = 0; i < 3; ++i) wrong += !std::isfinite(boxes.extent[i][0]);
      }
    }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(tried == 51600);
}

BOOST_AUTO_TEST_CASE(axes_that_are_not_orthonormal_are_not_stored)
{
  Random random(8);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto all = points(random, 12, 0);
  for (int kind = 0; kind < 6; ++kind) {
    Oriented_box box = fitted_box(all, 1);
    Matrix& axes = box.axes;
    if (kind == 0) axes.col(1) = Vector();
    if (kind == 1) axes.col(2) = axes.col(0);
    if (kind == 2) axes = (1 + 0x1p-20) * axes;
    if (kind == 3) axes(1, 2) = nan;
    if (kind == 4) axes = {{Vector::all(nan), Vector::all(nan), Vector::all(nan)}};
    if (kind == 5) axes.col(0) *= std::numeric_limits<double>::infinity();
    Obb8 boxes{};
    store_lane(boxes, 2, box.axes, Vector(), all);
    for (const Vector& p : all)
      for (int i = 0; i < 3; ++i) {
        BOOST_TEST(std::abs(along(boxes, 2, i, Vector(), p)) <= boxes.extent[i][2]);
        for (int j = 0; j < 3; ++j) BOOST_TEST(boxes.axis[i][j][2] == (i == j));
      }
  }
}

BOOST_AUTO_TEST_CASE(a_lane_holds_its_points_wherever_it_was_told_that_they_are)
{
  Random random(9);
  int outside = 0, loose = 0;
  for (int k = 0; k < 1000; ++k) {
    const double size = std::ldexp(1.0, -int(random() % 12));
    std::vector<Vector> all;
    for (int j = 0; j < 5; ++j)
      all.push_back(Vector(0.5, 0.25, -0.25) + size * Vector(real(random, -1, 1), 0, real(random, -1, 1)));
    Lane_box box(fitted_axes(all, 2), k % 2 == 0 ? vector(random) : all[0]);
    for (const Vector& p : all) box.add(p);
    Obb8 boxes{};
    const Vector origin = Vector(0.5, 0.25, 0).in_float();
    box.store(boxes, 1, origin, 0);
    for (int i = 0; i < 3; ++i) {
      double most = 0;
      for (const Vector& p : all) most = std::max(most, std::abs(along(boxes, 1, i, origin, p)));
      outside += !(most <= boxes.extent[i][1]);
      loose += !(boxes.extent[i][1] <= 1.00001 * most + 1e-5 * size + 1e-10);
    }
  }
  BOOST_TEST(outside == 0);
  BOOST_TEST(loose == 0);
}

BOOST_AUTO_TEST_CASE(boxes_of_halves_added_are_that_of_all)
{
  Random random(10);
  for (int k = 0; k < 200; ++k) {
    const auto all = points(random, 20, 1);
    Lane_box whole(fitted_axes(all, 2), all[0]), first = whole, second = whole;
    for (std::size_t j = 0; j < all.size(); ++j) {
      whole.add(all[j]);
      (j < std::size_t(k % 20) ? first : second).add(all[j]);
    }
    first.add(second);
    Obb8 boxes{};
    whole.store(boxes, 0, Vector(), 0);
    first.store(boxes, 1, Vector(), 0);
    for (int i = 0; i < 3; ++i) {
      BOOST_TEST(boxes.centre[i][0] == boxes.centre[i][1]);
      BOOST_TEST(boxes.extent[i][0] == boxes.extent[i][1]);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_lane_of_a_point_that_is_no_number_has_no_extent)
{
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (int place = 0; place < 3; ++place) {
      Lane_box known(Matrix::identity(), Vector(0, 0, 0)), none = known;
      known.add(Vector(0.5, 0.25, 0.125));
      for (int k = 0; k < 3; ++k) none.add(Vector(0.5, k == place ? bad : 0.25, 0.125));
      known.add(none);
      Obb8 boxes{};
      none.store(boxes, 0, Vector(), 0);
      known.store(boxes, 1, Vector(), 0);
      for (int i = 0; i < 3; ++i) BOOST_TEST((std::isnan(boxes.extent[i][0]) && std::isnan(boxes.extent[i][1])));
    }
}

BOOST_AUTO_TEST_CASE(a_flat_cloud_gets_a_flat_box_and_more_rounds_never_make_a_larger_surface)
{
  Random random(2);
  for (int k = 0; k < 200; ++k) {
    const auto all = points(random, 20, 1);
    const Oriented_box box = fitted_box(all, 3);
    BOOST_TEST(minimum(box.extent[0], box.extent[1], box.extent[2]) < 1e-7);
    const Oriented_box of_triangle = triangle_box(std::span<const Vector>(all).first<3>());
    BOOST_TEST(of_triangle.extent[0] < 1e-7);
    const auto cloud = points(random, 12, 0);
    for (const int rounds : {1, 2, 4, 8})
      BOOST_TEST(fitted_box(cloud, rounds).surface() <= fitted_box(cloud, rounds / 2).surface());
  }
}

BOOST_AUTO_TEST_CASE(the_principal_direction_is_where_points_spread_most)
{
  std::vector<Vector> all;
  for (int k = -5; k <= 5; ++k) all.emplace_back(3 * k, k % 2, 0.25 * (k % 3));
  const Matrix axes = Spread(all).principal_axes();
  BOOST_TEST(std::abs(axes(0, 2)) > 0.99);
  BOOST_TEST(axes.orthonormal_defect() < 1e-12);
  const auto along = [&](int k) {
    double square = 0;
    for (const Vector& p : all) square += std::pow(axes.col(k).dot(p - Spread(all).mean), 2);
    return square;
  };
  BOOST_TEST(along(0) <= along(1));
  BOOST_TEST(along(1) <= along(2));
  const Spread of_one(std::vector<Vector>{Vector(1, 2, 3)});
  BOOST_TEST(of_one.size() == 0);
  BOOST_TEST((of_one.principal_axes() == Matrix::identity()));
}

struct Lane {
  Obb8 boxes{};
  Vector node_origin;  // as near as a node's is
  std::array<Vector, 3> corners;

  Lane(const Oriented_box& box, const std::array<Vector, 3>& corners)
      : node_origin((corners[0] + (corners[1] - corners[0]) * 3).in_float()), corners(corners)
  {
    store_lane(boxes, 3, box.axes, node_origin, corners);
  }
  Apex_code code() const { return apex_code(boxes, 3, node_origin, corners); }

  /// The corner along axes 1 and 2 of the box, from its centre.
  std::array<double, 2> in_plane(const Vector& p) const
  {
    return {along(boxes, 3, 1, node_origin, p), along(boxes, 3, 2, node_origin, p)};
  }
};

BOOST_AUTO_TEST_CASE(a_triangle_lies_in_its_box_where_its_apex_says)
{
  Random random(4);
  int known = 0, tried = 0;
  for (int k = 0; k < 3000; ++k) {
    const double size = std::ldexp(1.0, -int(random() % 20));
    std::array<Vector, 3> t;
    for (Vector& p : t) p = 0.5 * size * vector(random);
    if (k % 4 == 1) t[2] = t[0] + 0.999 * (t[1] - t[0]) + 1e-3 * (t[2] - t[0]);  // a sliver, its apex over one end
    if (k % 4 == 2) t[2] = 0.5 * (t[0] + t[1]) + 0.01 * (t[2] - t[0]);
    if (k % 4 == 3) {  // with a right angle
      const Vector leg = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
      t[2] = t[0] + leg * (t[1] - t[0]).norm() * (0.1 + std::abs(real(random, -1, 1)));
    }
    const Lane lane(triangle_box(t), t);
    const Apex_code code = lane.code();
    ++tried;
    if (code == 0) continue;
    ++known;
    const double e1 = lane.boxes.extent[1][3], e2 = lane.boxes.extent[2][3], apex = apex_of(code);
    BOOST_TEST(std::abs(apex) <= 1);
    // Within all three sides: on the left of each, seen along it, or beyond by the tolerance.
    const std::array<std::array<double, 2>, 3> corner = {{{-e1, -e2}, {e1, -e2}, {apex * e1, e2}}};
    for (int side = 0; side < 3; ++side) {
      const auto &from = corner[side], &to = corner[(side + 1) % 3];
      const double x = to[0] - from[0], y = to[1] - from[1], length = std::abs(x) + std::abs(y);
      for (const Vector& p : t) {
        const auto at = lane.in_plane(p);
        BOOST_TEST(x * (at[1] - from[1]) - y * (at[0] - from[0]) >= -1.001 * apex_tolerance * (e1 + e2) * length);
      }
    }
  }
  BOOST_TEST(tried == 3000);
  BOOST_TEST(known > 2900);
}

BOOST_AUTO_TEST_CASE(what_is_no_triangle_along_its_box_has_no_apex)
{
  BOOST_TEST(apex_of(0) == no_apex);
  BOOST_TEST(apex_of(1) == -1.0f);
  BOOST_TEST(apex_of(32768) == 0.0f);
  BOOST_TEST(apex_of(65535) == 1.0f);
  const std::array<Vector, 3> t = {Vector(0, 0, 0), Vector(0.5, 0, 0), Vector(0.25, 0.25, 0)};
  BOOST_TEST(apex_of(Lane(triangle_box(t), t).code()) == 0.0f);
  // Upside down, along no side, and a point.
  BOOST_TEST(Lane(Oriented_box(detail::axes_from(Vector(0, 0, -1), Vector(1, 0, 0)), t), t).code() == 0);
  BOOST_TEST(Lane(Oriented_box(detail::axes_from(Vector(0, 0, 1), Vector(1, 1, 0)), t), t).code() == 0);
  const std::array<Vector, 3> dot = {t[1], t[1], t[1]};
  const Lane of_dot(triangle_box(dot), dot);
  const Apex_code code = of_dot.code();
  if (code != 0) BOOST_TEST(of_dot.boxes.extent[2][3] < 1e-6);  // of a box that is nothing but margin
}

BOOST_AUTO_TEST_SUITE_END()
