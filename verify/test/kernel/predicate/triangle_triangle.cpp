#include "tetracone/kernel/predicate/triangle_triangle.h"

#include "tetracone/kernel/predicate/frame.h"
#include "verify/integer_truth/integer_truth.h"
#include "verify/test/support/segment_truth.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_triangle_triangle)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;
using Three = std::array<Vertex, 3>;

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
