#include "tetracone/kernel/bound/cone_lattice.h"

#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_cone_lattice)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

// Points of the octahedron's surface: its corners, and random ones.
std::vector<Direction> directions(Random& random, int count)
{
  std::vector<Direction> result;
  for (int axis = 0; axis < 3; ++axis)
    for (const int sign : {-1, 1}) {
      Direction corner{0, 0, 0};
      corner[axis] = sign * lattice_size;
      result.push_back(corner);
    }
  for (int n = 0; n < count; ++n) {
    const int x = integer(random, 0, lattice_size), y = integer(random, 0, lattice_size - x);
    const auto sign = [&] { return integer(random, 0, 1) == 0 ? -1 : 1; };
    result.push_back({sign() * x, sign() * y, sign() * (lattice_size - x - y)});
  }
  return result;
}

bool is_power_of_two(double x)
{
  int exponent;
  return std::frexp(x, &exponent) == 0.5;
}

// Every lattice point is the exact sum in Number: of the origin and of step times the direction, all held by Number.
template <class Number>
int inexact(const Cone_lattice& lattice, Random& random)
{
  int wrong = 0;
  for (const Direction& d : directions(random, 200)) {
    const Vertex p = lattice.point(d);
    for (int k = 0; k < 3; ++k) {
      const Rational exact = Rational(lattice.origin[k]) + Rational(lattice.step) * Rational(d[k]);
      wrong += !std::isfinite(p[k]) || Rational(p[k]) != exact || double(Number(p[k])) != p[k];
      wrong += double(Number(lattice.origin[k])) != lattice.origin[k] || double(Number(lattice.step)) != lattice.step;
    }
  }
  return wrong;
}

std::vector<Vertex> cloud(Random& random, int count, double radius, const Vertex& centre)
{
  std::vector<Vertex> points(count);
  for (Vertex& p : points) {
    p = real_vertex(random, 1);
    for (int k = 0; k < 3; ++k) p[k] = p[k] * radius + centre[k];
  }
  return points;
}

BOOST_AUTO_TEST_CASE(lattice_points_are_exact_in_double_at_every_scale_and_place)
{
  Random random(1);
  for (const double scale : {1.0, 3e-5, 1e-300, 0x1p-1060, 0x1p-1074, 1e300, 8e307, 1.7e308})
    for (const double offset : {0.0, 1.0, 1e3, 1e15, 1e17, 1e30, -1e9}) {
      Vertex centre{offset * scale, -offset * scale, offset * scale / 3};
      for (double& x : centre)
        if (!std::isfinite(x) || std::abs(x) > 1.7e308 - scale) x = 0;
      const auto points = cloud(random, 1 + integer(random, 0, 50), scale, centre);
      const Cone_lattice lattice = cone_lattice(points);
      BOOST_TEST_INFO_SCOPE("scale " << scale << " offset " << offset);
      BOOST_TEST(is_power_of_two(lattice.step));
      BOOST_TEST(inexact<double>(lattice, random) == 0);
    }
}

BOOST_AUTO_TEST_CASE(lattice_points_are_exact_in_float_for_models_about_the_coordinate_origin)
{
  Random random(2);
  for (const double scale : {1.0, 0.37, 1e-25, 1e30})
    for (int n = 0; n < 10; ++n) {
      std::vector<Vertex> points = cloud(random, 8, scale, {0, 0, 0});
      points.push_back({scale, scale, scale});
      points.push_back({-scale, -scale, -scale});
      BOOST_TEST(inexact<float>(cone_lattice(points), random) == 0);
    }
}

BOOST_AUTO_TEST_CASE(the_origin_is_the_centroid_but_for_a_step)
{
  Random random(3);
  for (const double offset : {0.0, 1e6, -1e12}) {
    const auto points = cloud(random, 30, 2, {offset, offset / 2, -offset});
    const Cone_lattice lattice = cone_lattice(points);
    rationals::Vector sum = {0, 0, 0};
    for (const Vertex& p : points) sum = rationals::plus(sum, rationals::exactly(p));
    for (int k = 0; k < 3; ++k) {
      // The mean is summed in double, with an error below 30 ulps of the largest term.
      const Rational allowed = Rational(lattice.step) + Rational(std::abs(offset) + 2) * Rational(0x1p-45);
      BOOST_TEST((abs(Rational(sum[k] / 30 - Rational(lattice.origin[k]))) <= allowed));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_lattice_is_fine_enough_for_the_model_and_models_of_one_point_and_of_none_have_one)
{
  Random random(4);
  for (const double scale : {1.0, 1e-200, 1e200}) {
    const Cone_lattice lattice = cone_lattice(cloud(random, 20, scale, {0, 0, 0}));
    BOOST_TEST(lattice.step <= scale * 0x1p-14);
    BOOST_TEST(lattice.step >= scale * 0x1p-20);
  }
  BOOST_TEST(inexact<double>(cone_lattice({}), random) == 0);
  for (const Vertex& v : {Vertex{0, 0, 0},
                          {1, 2, 3},
                          {0x1p-1074, 0, 0},
                          {0x1.fffffffffffffp1023, -0x1.fffffffffffffp1023, 0},
                          {0.1, 1e-300, -7e100}}) {
    const std::vector<Vertex> points(3, v);
    BOOST_TEST(inexact<double>(cone_lattice(points), random) == 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
