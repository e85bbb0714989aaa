#include "tetracone/tetratree/paper/bounding_tetrahedron.h"

#include "verify/test/support/cones.h"
#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <span>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_bounding_tetrahedron)

using namespace tetracone::tetratree;
using namespace tetracone::kernel;
namespace rationals = tetracone::verify::rationals;
namespace scenes = tetracone::verify::scenes;
using scenes::Random;

namespace {

using Lengths = std::array<double, 3>;

// Points about 0, most of them in the cone, as a node of a tree has them.
std::vector<Bound_point<double>> points_about(Random& random, const Tetra_cone& cone, int count, double scale)
{
  std::vector<Bound_point<double>> points(count, {0, 0, 0});
  for (auto& p : points)
    for (int i = 0; i < 3; ++i) {
      const double share = scenes::real(random, -0.3, 1) * scale / lattice_size;
      for (int axis = 0; axis < 3; ++axis) p[axis] += share * cone.ray[i][axis];
    }
  return points;
}

// sum_i c_i / length_i <= 1 in rationals: all points on the side of V0.
bool bounds(const Tetra_cone& cone, double step, const Lengths& length, std::span<const Bound_point<double>> points)
{
  const Rational determinant = scenes::determinant(cone) * Rational(step);
  for (const auto& p : points) {
    Rational sum = 0;
    for (int i = 0; i < 3; ++i)
      sum += rationals::determinant(rationals::exactly(p), scenes::ray(cone, i + 1), scenes::ray(cone, i + 2)) /
             determinant / Rational(length[i]);
    if (sum > 1) return false;
  }
  return true;
}

}  // namespace

BOOST_AUTO_TEST_CASE(both_far_planes_bound_all_points_and_the_tightest_is_the_smaller_on_average)
{
  Random random(1);
  int wrong = 0, worse = 0;
  double log_ratio = 0;
  constexpr int samples = 800;
  for (int n = 0; n < samples; ++n) {
    const Tetra_cone cone = scenes::random_cone(random, 1 + n % max_cone_depth);
    const double scale = n % 4 == 0 ? std::ldexp(1.0, scenes::integer(random, -200, 200)) : 1,
                 step = scale / lattice_size;
    const auto points = points_about(random, cone, 3 + n % 9, scale);
    const double radius = enclosing_ball<double, true>({0, 0, 0}, points).radius;
    const Cone_coordinates<double, true> coordinates(cone.ray, step, points, radius);
    Config config;
    const Lengths shortened = bounding_tetrahedron(coordinates, config);
    config.far_plane = Far_plane::tightest;
    const Lengths tightest = bounding_tetrahedron(coordinates, config);
    wrong += !bounds(cone, step, shortened, points) || !bounds(cone, step, tightest, points);
    wrong += coordinates.volume(shortened) > coordinates.volume(coordinates.isosceles());
    const double ratio = coordinates.volume(tightest) / coordinates.volume(shortened);
    worse += ratio > 1;
    log_ratio += std::log(ratio);
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(log_ratio / samples < -0.1);
  BOOST_TEST(worse < samples / 10);
}

BOOST_AUTO_TEST_CASE(no_rounds_leave_the_isosceles_tetrahedron_and_more_rounds_never_enlarge_it)
{
  Random random(2);
  int wrong = 0;
  for (int n = 0; n < 200; ++n) {
    const Tetra_cone cone = scenes::random_cone(random, 1 + n % 5);
    const auto points = points_about(random, cone, 5, 1);
    const double radius = enclosing_ball<double, true>({0, 0, 0}, points).radius;
    const Cone_coordinates<double, true> coordinates(cone.ray, 1.0 / lattice_size, points, radius);
    Config config;
    config.shortening_rounds = 0;
    wrong += bounding_tetrahedron(coordinates, config) != coordinates.isosceles();
    double volume = coordinates.volume(coordinates.isosceles());
    for (const int rounds : {1, 3, 10, 30}) {
      config.shortening_rounds = rounds;
      const double next = coordinates.volume(bounding_tetrahedron(coordinates, config));
      wrong += next > volume;
      volume = next;
    }
  }
  BOOST_TEST(wrong == 0);
}

BOOST_AUTO_TEST_CASE(the_loop_is_the_papers_step_by_step)
{
  // In the octant, all points on one plane x/a + y/b + z/c = 1 with a the shares of z, x, y: one shortening a round
  // at most.
  const Tetra_cone cone = Tetra_cone::octant(0);
  const std::vector<Bound_point<double>> points = {{1, 0, 0}};  // on V2 only: the other two edges may shrink at will
  const Cone_coordinates<double, true> coordinates(cone.ray, 1.0 / lattice_size, points, 1);
  Config config;
  config.shorten_by = 0.10;
  config.lengthen_by = 0.05;
  config.shortening_rounds = 2;
  const Lengths start = coordinates.isosceles(), length = bounding_tetrahedron(coordinates, config);
  BOOST_TEST(start[0] > std::sqrt(3.0));
  BOOST_TEST(length[0] == start[0] * 0.9 * 0.9, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(length[1] == start[1] * 0.9 * 0.9, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(length[2] == start[2] * 0.9 * 0.9, boost::test_tools::tolerance(1e-12));
  // Down to where 10 % less is too short and 5 % more is not: x stays at or above 1.
  config.shortening_rounds = 50;
  const Lengths end = bounding_tetrahedron(coordinates, config);
  BOOST_TEST(end[1] >= 1);
  BOOST_TEST(end[1] < 1.1);
  BOOST_TEST(end[0] < 0.01);
}

BOOST_AUTO_TEST_SUITE_END()
