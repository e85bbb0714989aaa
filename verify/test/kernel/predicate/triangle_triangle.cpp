#include "tetracone/kernel/predicate/triangle_triangle.h"

#include "tetracone/kernel/predicate/frame.h"
#include "verify/integer_truth/integer_truth.h"
#include "verify/test/support/rationals.h"
#include "verify/test/support/segment_truth.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_triangle_triangle)

using namespace tetracone::kernel;
namespace rationals = tetracone::verify::rationals;
using namespace tetracone::verify::scenes;
using rationals::Vector;
using Three = std::array<Vertex, 3>;

namespace {

using Exact_three = std::array<Vector, 3>;

Exact_three exactly(const Three& t, const Pose& pose)
{
  return {rationals::image(pose, rationals::exactly(t[0])), rationals::image(pose, rationals::exactly(t[1])),
          rationals::image(pose, rationals::exactly(t[2]))};
}

/// In integers, by the second truth.
bool share_a_point(const Three& p, const Three& q)
{
  const auto body = [](const Three& t) { return std::make_shared<const Polyhedron>(face_of({{t[0], t[1], t[2]}})); };
  return tetracone::verify::integer_truth::collide({body(p), body(q), Pose(), Pose(), {}, {}, {}}, Question::surface);
}

template <class K>
std::array<Point<K>, 3> placed(const Three& t, const Pose& pose)
{
  const Frame<K> frame(pose);
  return {frame(point<K>(t[0])), frame(point<K>(t[1])), frame(point<K>(t[2]))};
}

template <class K>
Corners<K> corners(const std::array<Point<K>, 3>& t)
{
  return {&t[0], &t[1], &t[2]};
}

template <class K>
bool meet(const Three& p, const Three& q)
{
  const auto a = placed<K>(p, Pose()), b = placed<K>(q, Pose());
  return triangles_meet<K>(corners<K>(a), corners<K>(b));
}

Three grid_triangle(Random& random, int radius)
{
  return {grid_vertex(random, radius), grid_vertex(random, radius), grid_vertex(random, radius)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_triangle_of_a_small_grid_against_some)
{
  // All triangles with corners on {0,1}^2 x {0,1,2}, degenerate ones too, against representatives of every shape.
  std::vector<Vertex> grid;
  for (int x = 0; x < 2; ++x)
    for (int y = 0; y < 2; ++y)
      for (int z = 0; z < 3; ++z) grid.push_back({double(x), double(y), double(z)});
  const std::vector<Three> others = {
      {{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}}, {{{0, 0, 0}, {1, 1, 0}, {1, 1, 2}}},
      {{{0, 0, 0}, {1, 0, 1}, {0, 1, 2}}}, {{{0.5, 0.5, 0.5}, {0.5, 0.5, 1}, {2, 0.5, 1}}},
      {{{0, 0, 0}, {1, 1, 2}, {1, 1, 2}}}, {{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}}};
  int wrong = 0, yes = 0, no = 0;
  for (const Vertex& a : grid)
    for (const Vertex& b : grid)
      for (const Vertex& c : grid)
        for (const Three& q : others) {
          const Three p = {a, b, c};
          const bool truth = share_a_point(p, q);
          wrong += meet<Adaptive>(p, q) != truth;
          wrong += meet<Double>(q, p) != truth;  // exact on this grid
          ++(truth ? yes : no);
        }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(yes > 1000);
  BOOST_TEST(no > 1000);
}

BOOST_AUTO_TEST_CASE(sides_are_the_signs_of_the_three_volumes)
{
  Random random(4);
  int wrong = 0;
  std::array<int, 3> seen{};
  for (int k = 0; k < 4000; ++k) {
    const Pose pose = k % 3 == 0   ? Pose()
                      : k % 3 == 1 ? random_rotation(random, 5)
                                   : rounded(random_rotation(random, 5));
    const Three t = grid_triangle(random, 2);
    Three points = grid_triangle(random, 2);
    for (int i = 0; i < 3; ++i) {
      if (k % 2 == 0) continue;
      points[i] = t[i];  // in the plane, or so near to it that the filter says nothing
      points[i][2] += std::ldexp(double(integer(random, -1, 1)), -integer(random, 30, 52));
    }
    const auto a = placed<Adaptive>(t, pose), b = placed<Adaptive>(points, pose);
    const auto side = sides<Adaptive>(corners<Adaptive>(a), corners<Adaptive>(b));
    const Exact_three e = exactly(t, pose), f = exactly(points, pose);
    for (int i = 0; i < 3; ++i) {
      const int truth = rationals::sign(rationals::determinant(
          rationals::minus(e[1], e[0]), rationals::minus(e[2], e[0]), rationals::minus(f[i], e[0])));
      wrong += int(side[i]) != truth;
      ++seen[truth + 1];
    }
  }
  BOOST_TEST(wrong == 0);
  for (const int count : seen) BOOST_TEST(count > 1000);
}

BOOST_AUTO_TEST_CASE(points_beyond_the_gate_are_decided_exactly)
{
  const double huge = 0x1p900;
  const Three p = {{{-huge, -huge, 0}, {huge, -huge, 0}, {0, huge, 0}}};
  for (const double z : {0.0, 0x1p-1074, -0x1p-1074, 1.0}) {
    const Three q = {{{0, 0, z}, {0, 1, z < 0 ? z : 1}, {1, 0, z < 0 ? -huge : huge}}};
    BOOST_TEST(meet<Adaptive>(p, q) == (z == 0));
    BOOST_TEST(meet<Adaptive>(q, p) == (z == 0));
  }
}

BOOST_AUTO_TEST_SUITE_END()
