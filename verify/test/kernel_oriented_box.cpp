#include "kernel/oriented_box.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>
#include <vector>

using namespace tetracone::kernel;

namespace {

using Random = std::mt19937_64;
double real(Random& random) { return std::uniform_real_distribution<double>(-1, 1)(random); }

std::vector<Vector> points(Random& random, int count, int kind)
{
  std::vector<Vector> all;
  const Vector a(real(random), real(random), real(random)), b(real(random), real(random), real(random));
  for (int k = 0; k < count; ++k) {
    if (kind == 0) all.emplace_back(real(random), real(random), real(random));
    if (kind == 1) all.push_back(real(random) * a + real(random) * b);  // in a plane
    if (kind == 2) all.push_back(real(random) * a);                     // on a line
    if (kind == 3) all.push_back(a);                                    // in a point
    if (kind == 4) all.push_back(1e-9 * Vector(real(random), real(random), real(random)) + a);
  }
  return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_stored_box_holds_its_points)
{
  Random random(1);
  for (int k = 0; k < 1500; ++k) {
    const auto all = points(random, 3 + int(random() % 30), k % 5);
    const bool triangle = k % 3 == 0;
    const std::span<const Vector> used = triangle ? std::span<const Vector>(all).first(3) : std::span<const Vector>(all);
    const Oriented_box box = triangle ? triangle_box(used.first<3>()) : fitted_box(used, k % 4);
    const Vector origin(0.25f * float(real(random)), 0.5, -0.125);
    const Vector node_origin = origin.cast<float>().cast<double>();
    Wide_boxes boxes{};
    store_lane(boxes, 5, box, node_origin, used, 0);
    // Solved in double for the float axes: far more digits than the margin.
    Matrix axes;
    Vector centre, extent;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) axes(j, i) = boxes.axis[i][j][5];
      centre[i] = boxes.centre[i][5] + node_origin[i];
      extent[i] = boxes.extent[i][5];
    }
    for (const Vector& p : used) {
      const Vector s = axes.fullPivLu().solve(p - centre);
      for (int i = 0; i < 3; ++i) BOOST_TEST(std::abs(s[i]) <= extent[i] + 1e-15);
    }
    BOOST_TEST((axes.transpose() * axes - Matrix::Identity()).cwiseAbs().maxCoeff() <= axis_defect);
  }
}

BOOST_AUTO_TEST_CASE(a_flat_cloud_gets_a_flat_box)
{
  Random random(2);
  for (int k = 0; k < 200; ++k) {
    const auto all = points(random, 20, 1);
    const Oriented_box box = fitted_box(all, 3);
    BOOST_TEST(box.extent.minCoeff() < 1e-7);
    const Oriented_box of_triangle = triangle_box(std::span<const Vector>(all).first<3>());
    BOOST_TEST(of_triangle.extent[0] < 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(more_rounds_never_make_a_larger_surface)
{
  Random random(3);
  for (int k = 0; k < 100; ++k) {
    const auto all = points(random, 12, 0);
    double last = fitted_box(all, 0).surface();
    for (const int rounds : {1, 2, 4, 8}) {
      const double now = fitted_box(all, rounds).surface();
      BOOST_TEST(now <= last);
      last = now;
    }
  }
}

BOOST_AUTO_TEST_CASE(the_principal_direction_is_where_points_spread_most)
{
  std::vector<Vector> all;
  for (int k = -5; k <= 5; ++k) all.emplace_back(3 * k, k % 2, 0.25 * (k % 3));
  const Matrix axes = Spread(all).principal_axes();
  BOOST_TEST(std::abs(axes(0, 2)) > 0.99);
  BOOST_TEST((axes.transpose() * axes - Matrix::Identity()).cwiseAbs().maxCoeff() < 1e-12);
  const auto along = [&](int k) {
    double square = 0;
    for (const Vector& p : all) square += std::pow(axes.col(k).dot(p - Spread(all).mean), 2);
    return square;
  };
  BOOST_TEST(along(0) <= along(1));
  BOOST_TEST(along(1) <= along(2));
  const Spread of_one(std::vector<Vector>{Vector(1, 2, 3)});
  BOOST_TEST(of_one.size() == 0);
  BOOST_TEST((of_one.principal_axes() == Matrix::Identity()));
}
