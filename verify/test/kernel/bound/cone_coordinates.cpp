#include "tetracone/kernel/bound/cone_coordinates.h"

#include "tetracone/tetratree/paper/tetra_cone.h"
#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_cone_coordinates)

using namespace tetracone::kernel;
using tetracone::tetratree::Tetra_cone;
namespace rationals = tetracone::verify::rationals;
namespace scenes = tetracone::verify::scenes;
using rationals::Vector;
using scenes::Random;

namespace {

using Lengths = std::array<double, 3>;

/// A cone with points, most of them in it, about an origin; and the same in rationals.
struct Case {
  Cone_lattice lattice;
  Tetra_cone cone;
  std::vector<Vertex> points, relative;
  double radius;
  std::vector<std::array<Rational, 3>> exact;  // coordinates of the points along the rays

  Case(Random& random, int n)
  {
    cone = Tetra_cone::octant(n % 8);
    for (int level = 1 + n % max_cone_depth; level > 1; --level) cone = cone.child(scenes::integer(random, 0, 3));
    const double scale = n % 5 == 0 ? std::ldexp(1.0, scenes::integer(random, -1050, 800)) : 1;
    const Vertex far = scenes::real_vertex(random, n % 3 == 0 ? 1e9 : 3);
    for (int k = 0; k < 3 + n % 6; ++k) {
      Vertex p{0, 0, 0};
      // A sliver now and then: all points near one ray.
      for (int i = 0; i < 3; ++i) {
        const double share = scenes::real(random, -0.2, 1) / lattice_size * (n % 4 == 0 && i > 0 ? 0x1p-30 : 1);
        for (int axis = 0; axis < 3; ++axis) p[axis] += share * cone.ray[i][axis];
      }
      if (n % 7 == 0) p = scenes::real_vertex(random, 1);
      for (int axis = 0; axis < 3; ++axis) p[axis] = scale * (p[axis] + far[axis]);
      points.push_back(p);
    }
    lattice = cone_lattice(points);
    if (n % 2 == 0)
      for (int k = 0; k < 3; ++k) lattice.origin[k] = std::nearbyint(scale * far[k] / lattice.step) * lattice.step;
    for (const Vertex& p : points) relative.push_back(difference<double>(p, lattice.origin));
    radius = enclosing_ball<double, true>(lattice.origin, points).radius;
    const auto ray = [&](int i) { return Vector{cone.ray[i][0], cone.ray[i][1], cone.ray[i][2]}; };
    const Rational determinant = rationals::determinant(ray(0), ray(1), ray(2)) * Rational(lattice.step);
    for (const Vertex& p : points) {
      const Vector x = rationals::minus(rationals::exactly(p), rationals::exactly(lattice.origin));
      exact.push_back({});
      for (int i = 0; i < 3; ++i)
        exact.back()[i] = rationals::determinant(x, ray((i + 1) % 3), ray((i + 2) % 3)) / determinant;
    }
  }

  Cone_coordinates<double, true> coordinates() const { return {cone.ray, lattice.step, relative, radius}; }

  /// The largest of sum_i c_i / length_i.
  Rational largest(const Lengths& length) const
  {
    Rational result = -1;
    for (const auto& c : exact) {
      Rational sum = 0;
      for (int i = 0; i < 3; ++i) sum += c[i] / Rational(length[i]);
      result = std::max<Rational>(result, sum);
    }
    return result;
  }
};

bool is_finite(const Lengths& length)
{
  return std::all_of(length.begin(), length.end(), [](double l) { return std::isfinite(l) && l > 0; });
}

constexpr int samples = 1200;

}  // namespace

BOOST_AUTO_TEST_CASE(isosceles_lengths_bound_every_point_and_are_equal_as_distances)
{
  Random random(1);
  int wrong = 0, finite = 0;
  for (int n = 0; n < samples; ++n) {
    const Case c(random, n);
    const Lengths length = c.coordinates().isosceles();
    if (!is_finite(length)) continue;
    ++finite;
    wrong += !(c.largest(length) <= 1);
    if (n % 5 == 0) continue;
    std::array<double, 3> distance;
    for (int i = 0; i < 3; ++i) {
      const auto& r = c.cone.ray[i];
      distance[i] = length[i] * std::hypot(r[0], r[1], r[2]);
    }
    wrong += std::abs(distance[0] - distance[1]) > 1e-9 * distance[0] ||
             std::abs(distance[0] - distance[2]) > 1e-9 * distance[0];
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(finite > samples * 9 / 10);
}

BOOST_AUTO_TEST_CASE(bounded_by_says_yes_only_where_all_points_are_exactly_on_the_side_of_the_origin)
{
  Random random(2);
  int wrong = 0, yes = 0, no = 0, missed = 0;
  for (int n = 0; n < samples; ++n) {
    const Case c(random, n);
    const auto coordinates = c.coordinates();
    for (int trial = 0; trial < 12; ++trial) {
      // Lengths whose plane runs through the farthest point, up to a few units in the last place.
      Lengths length = coordinates.isosceles();
      if (!is_finite(length)) continue;
      for (double& l : length) l *= scenes::real(random, 0.2, 1);
      const Rational farthest = c.largest(length);
      if (farthest <= 0) continue;
      const double scale = nearest_double(farthest) * (1 + (trial - 4) * (trial == 11 ? 0x1p-20 : 0x1p-52));
      for (double& l : length) l *= scale;
      if (!is_finite(length) || length[0] < 0x1p-900) continue;
      const bool answer = coordinates.bounded_by(length);
      const Rational largest = c.largest(length);
      wrong += answer && largest > 1;
      (answer ? yes : no) += 1;
      // By a margin that no rounding of a well-shaped case takes up.
      missed += !answer && n % 3 != 0 && n % 4 != 0 && n % 5 != 0 && largest < Rational(1 - 0x1p-24);
    }
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(missed == 0);
  BOOST_TEST(yes > samples / 4);
  BOOST_TEST(no > samples / 4);
}

BOOST_AUTO_TEST_CASE(the_least_volume_bounds_every_point_and_is_no_more_than_the_isosceles)
{
  Random random(3);
  int wrong = 0, smaller = 0;
  for (int n = 0; n < samples; ++n) {
    const Case c(random, n);
    const auto coordinates = c.coordinates();
    const Lengths start = coordinates.isosceles();
    if (!is_finite(start)) continue;
    const Lengths length = coordinates.least_volume(start);
    wrong += !is_finite(length) || c.largest(length) > 1;
    wrong += coordinates.volume(length) > coordinates.volume(start);
    for (int i = 0; i < 3; ++i) wrong += length[i] > 4 * start[i];
    smaller += coordinates.volume(length) < 0.9 * coordinates.volume(start);
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(smaller > samples / 10);
}

BOOST_AUTO_TEST_CASE(the_volume_is_that_of_the_tetrahedron_cut_off)
{
  const Tetra_cone octant = Tetra_cone::octant(0);
  const std::vector<Bound_point<double>> points = {{1, 1, 1}};
  const Cone_coordinates<double, true> coordinates(octant.ray, 1.0 / lattice_size, points, 2);
  BOOST_TEST(coordinates.volume({1, 1, 1}) == 1.0 / 6);
  BOOST_TEST(coordinates.volume({1, 2, 3}) == 1.0);
  // x + y + z <= 3 holds (1, 1, 1) on its border.
  BOOST_TEST(coordinates.bounded_by({3.0000001, 3.0000001, 3.0000001}));
  BOOST_TEST(!coordinates.bounded_by({3, 3, 3}));  // exactly on it, but not provably
  const Cone_coordinates<double, false> plain(octant.ray, 1.0 / lattice_size, points, 2);
  BOOST_TEST(!plain.bounded_by({2.999, 2.999, 2.999}));
  BOOST_TEST(plain.bounded_by({3.0000001, 3.0000001, 3.0000001}));
}

BOOST_AUTO_TEST_CASE(points_that_are_all_behind_the_origin_leave_lengths_that_are_not_zero)
{
  const Tetra_cone octant = Tetra_cone::octant(0);
  const std::vector<Bound_point<double>> points = {{-1, -2, -3}, {-3, -1, -1}};
  const Cone_coordinates<double, true> coordinates(octant.ray, 1.0 / lattice_size, points, 4);
  for (const double length : coordinates.least_volume(coordinates.isosceles())) BOOST_TEST(length > 0);
}

BOOST_AUTO_TEST_CASE(undefined_coordinates_are_bounded_by_nothing)
{
  const Tetra_cone octant = Tetra_cone::octant(0);
  const std::vector<Bound_point<double>> points = {{std::nan(""), 0, 0}};
  const Cone_coordinates<double, true> coordinates(octant.ray, 1, points, 1);
  BOOST_TEST(!coordinates.bounded_by({1, 1, 1}));
  BOOST_TEST(!coordinates.bounded_by({1e300, 1e300, 1e300}));
}

// Planted and seen to fail: the allowance for rounding left out,
// bounded_by_says_yes_only_where_all_points_are_exactly_on_the_side_of_the_origin.

BOOST_AUTO_TEST_SUITE_END()
