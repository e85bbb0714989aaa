#include "tetracone/kernel/predicate/triangle_triangle.h"

#include "tetracone/kernel/predicate/frame.h"
#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_triangle_triangle)

using namespace tetracone::kernel;
namespace rationals = tetracone::verify::rationals;
using namespace tetracone::verify::scenes;
using rationals::Vector;
using Three = std::array<Vertex, 3>;

namespace {

// --- another formulation: rational arithmetic, no sign of the library ------------------------------------------------

using Exact_three = std::array<Vector, 3>;

Exact_three exactly(const Three& t, const Pose& pose = Pose())
{
  return {rationals::image(pose, rationals::exactly(t[0])), rationals::image(pose, rationals::exactly(t[1])),
          rationals::image(pose, rationals::exactly(t[2]))};
}

/// p is on the closed triangle, which may be a segment or a point: three signs of turns about the normal, or three
/// segments.
bool holds(const Exact_three& t, const Vector& p)
{
  using namespace rationals;
  for (int k = 0; k < 3; ++k)
    if (is_on_segment(p, t[k], t[(k + 1) % 3])) return true;
  const Vector n = outer(minus(t[1], t[0]), minus(t[2], t[0]));
  if (rationals::is_zero(n) || inner(n, minus(p, t[0])) != 0) return false;
  for (int k = 0; k < 3; ++k)
    if (inner(n, outer(minus(t[(k + 1) % 3], t[k]), minus(p, t[k]))) < 0) return false;
  return true;
}

bool segments_cross(const Vector& a, const Vector& b, const Vector& c, const Vector& d)
{
  using namespace rationals;
  const Vector u = minus(b, a), v = minus(d, c), w = minus(c, a), n = outer(u, v);
  if (rationals::is_zero(n) || inner(n, w) != 0) return false;  // parallel: an end is on the other, which `holds` finds
  const Rational square = inner(n, n), s = Rational(inner(outer(w, v), n) / square),
                 t = Rational(inner(outer(w, u), n) / square);
  return 0 <= s && s <= 1 && 0 <= t && t <= 1;
}

/// Closed triangles meet when an edge of one crosses the other's plane in a point of it, when a corner of one is on the
/// other, or when two edges cross. Points are constructed, in rationals.
bool share_a_point(const Exact_three& p, const Exact_three& q)
{
  using namespace rationals;
  const auto one_way = [](const Exact_three& edges, const Exact_three& face) {
    const Vector n = outer(minus(face[1], face[0]), minus(face[2], face[0]));
    for (int k = 0; k < 3; ++k) {
      const Vector &a = edges[k], &b = edges[(k + 1) % 3];
      if (holds(face, a)) return true;
      if (rationals::is_zero(n)) continue;
      const Rational at_a = inner(n, minus(a, face[0])), at_b = inner(n, minus(b, face[0]));
      if (at_a * at_b >= 0) continue;
      if (holds(face, plus(a, times(Rational(at_a / (at_a - at_b)), minus(b, a))))) return true;
    }
    return false;
  };
  if (one_way(p, q) || one_way(q, p)) return true;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (segments_cross(p[i], p[(i + 1) % 3], q[j], q[(j + 1) % 3])) return true;
  return false;
}

// --- what is asked ---------------------------------------------------------------------------------------------------

template <class K>
std::array<Point<K>, 3> placed(const Three& t, const Pose& pose)
{
  const Frame<K> frame(pose);
  return {frame(point<K>(t[0])), frame(point<K>(t[1])), frame(point<K>(t[2]))};
}

template <class K>
Corners<K> corners(const std::array<Point<K>, 3>& t, const std::array<int, 3>& order = {0, 1, 2})
{
  return {&t[order[0]], &t[order[1]], &t[order[2]]};
}

template <class K>
bool meet(const Three& p, const Three& q, const Pose& pose_p = Pose(), const Pose& pose_q = Pose())
{
  const auto a = placed<K>(p, pose_p), b = placed<K>(q, pose_q);
  return triangles_meet<K>(corners<K>(a), corners<K>(b));
}

/// By the segment tests, both ways.
template <class K>
bool edges_meet(const Three& p, const Three& q)
{
  const auto a = placed<K>(p, Pose()), b = placed<K>(q, Pose());
  for (int k = 0; k < 3; ++k) {
    if (segment_face<K>(a[k], a[(k + 1) % 3], Triangle<K>{b[0], b[1], b[2]}) != Contact::none) return true;
    if (segment_face<K>(b[k], b[(k + 1) % 3], Triangle<K>{a[0], a[1], a[2]}) != Contact::none) return true;
  }
  return false;
}

constexpr std::array<std::array<int, 3>, 6> orders = {
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};

Three grid_triangle(Random& random, int radius)
{
  return {grid_vertex(random, radius), grid_vertex(random, radius), grid_vertex(random, radius)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(hand_made_triangles_of_every_kind_of_contact)
{
  struct Named_pair {
    const char* name;
    Three p, q;
    bool meet;
  };
  const Three t = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  const std::vector<Named_pair> pairs = {
      {"through", t, {{{1, 1, -1}, {1, 1, 1}, {5, 5, 1}}}, true},
      {"linked by one edge each", t, {{{1, 1, 1}, {1, 1, -1}, {-3, -3, 0}}}, true},
      {"beside the other's line", t, {{{3, 3, -1}, {3, 3, 1}, {5, 5, 0}}}, false},
      {"parallel", t, {{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}}, false},
      {"a corner on the face", t, {{{1, 1, 0}, {1, 1, 2}, {2, 1, 2}}}, true},
      {"a corner on an edge", t, {{{2, 2, 0}, {5, 5, 2}, {5, 5, -2}}}, true},
      {"corner to corner", t, {{{4, 0, 0}, {6, 0, 1}, {6, 0, -1}}}, true},
      {"a corner in the plane, outside", t, {{{3, 3, 0}, {3, 3, 2}, {4, 3, 2}}}, false},
      {"edge crosses edge", t, {{{2, -1, 0}, {2, 1, 0}, {2, 0, 3}}}, true},
      {"edge along edge", t, {{{1, 0, 0}, {3, 0, 0}, {2, 0, 3}}}, true},
      {"edges in line, apart", t, {{{5, 0, 0}, {7, 0, 0}, {6, 0, 3}}}, false},
      {"one plane, overlapping", t, {{{1, 1, 0}, {5, 1, 0}, {1, 5, 0}}}, true},
      {"one plane, one inside", t, {{{1, 1, 0}, {1.5, 1, 0}, {1, 1.5, 0}}}, true},
      {"one plane, crossing with no corner inside",
       {{{0, 0, 0}, {6, 0, 0}, {3, 5, 0}}},
       {{{0, 3, 0}, {6, 3, 0}, {3, -2, 0}}},
       true},
      {"one plane, apart", t, {{{3, 3, 0}, {5, 3, 0}, {3, 5, 0}}}, false},
      {"one plane, a corner shared", t, {{{4, 0, 0}, {8, 0, 0}, {8, 4, 0}}}, true},
      {"a segment through", t, {{{1, 1, -1}, {1, 1, 1}, {1, 1, 1}}}, true},
      {"a segment in the plane, across", t, {{{-1, 1, 0}, {9, 1, 0}, {4, 1, 0}}}, true},
      {"a segment in the plane, beside", t, {{{5, 1, 0}, {9, 1, 0}, {7, 1, 0}}}, false},
      {"a segment that ends above", t, {{{1, 1, 2}, {1, 1, 1}, {1, 1, 1}}}, false},
      {"a point on the face", t, {{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}}, true},
      {"a point off the face", t, {{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}}, false},
      {"two points", {{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}}, {{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}}, true},
      {"two points apart", {{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}}, {{{1, 1, 2}, {1, 1, 2}, {1, 1, 2}}}, false},
      {"two segments that cross", {{{0, 0, 0}, {2, 2, 2}, {0, 0, 0}}}, {{{0, 2, 0}, {2, 0, 2}, {1, 1, 1}}}, true},
      {"two skew segments", {{{0, 0, 0}, {2, 0, 0}, {0, 0, 0}}}, {{{1, -1, 1}, {1, 1, 1}, {1, 0, 1}}}, false},
  };
  for (const auto& [name, p, q, expected] : pairs) {
    BOOST_TEST_INFO_SCOPE(name);
    BOOST_TEST(meet<Adaptive>(p, q) == expected);
    BOOST_TEST(meet<Rational_kernel>(p, q) == expected);
    BOOST_TEST(meet<Double>(p, q) == expected);
    BOOST_TEST(share_a_point(exactly(p), exactly(q)) == expected);
  }
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
          const bool truth = share_a_point(exactly(p), exactly(q));
          wrong += meet<Adaptive>(p, q) != truth;
          wrong += meet<Double>(q, p) != truth;  // exact on this grid
          ++(truth ? yes : no);
        }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(yes > 1000);
  BOOST_TEST(no > 1000);
}

BOOST_AUTO_TEST_CASE(random_triangles_of_grids_in_every_order_swapped_and_scaled)
{
  Random random(1);
  int wrong = 0, yes = 0, no = 0, by_edges = 0;
  for (int k = 0; k < 6000; ++k) {
    const int radius = 1 + k % 3;
    Three p = grid_triangle(random, radius), q = grid_triangle(random, radius);
    if (k % 5 == 0) p[2] = p[1];                                          // a segment
    if (k % 7 == 0) q[integer(random, 0, 2)] = p[integer(random, 0, 2)];  // a corner shared
    if (k % 4 == 0)
      for (int i = 0; i < 3; ++i) p[i][2] = q[i][2] = 0;  // one plane
    const bool truth = share_a_point(exactly(p), exactly(q));
    ++(truth ? yes : no);
    by_edges += edges_meet<Adaptive>(p, q) != truth;
    wrong += meet<Rational_kernel>(p, q) != truth;
    const double scale = std::ldexp(1.0, integer(random, -300, 300));
    Three far_p = p, far_q = q;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        far_p[i][j] *= scale;
        far_q[i][j] *= scale;
      }
    wrong += meet<Adaptive>(far_p, far_q) != truth;
    const auto a = placed<Adaptive>(p, Pose()), b = placed<Adaptive>(q, Pose());
    for (const auto& order : orders) {
      const auto& other = orders[random() % 6];
      wrong += triangles_meet<Adaptive>(corners<Adaptive>(a, order), corners<Adaptive>(b, other)) != truth;
      wrong += triangles_meet<Adaptive>(corners<Adaptive>(b, other), corners<Adaptive>(a, order)) != truth;
    }
  }
  BOOST_TEST(by_edges == 0);
  BOOST_TEST(wrong == 0);
  BOOST_TEST(yes > 1000);
  BOOST_TEST(no > 1000);
}

BOOST_AUTO_TEST_CASE(answers_are_those_of_the_exact_images_under_poses)
{
  Random random(2);
  int wrong = 0, yes = 0, no = 0;
  for (int k = 0; k < 2400; ++k) {
    Three p = grid_triangle(random, 2), q = grid_triangle(random, 2);
    if (k % 4 == 0)
      for (int i = 0; i < 3; ++i) p[i][2] = q[i][2] = 1;
    const Pose rational = random_rotation(random, 4, {Rational(integer(random, -1, 1)) / 3, 0, Rational(1) / 7});
    const Pose pose_p = k % 3 == 0 ? rational : k % 3 == 1 ? rounded(rational) : random_affine(random, 2);
    // Under one pose contacts stay what they are; under two they are rare.
    const Pose pose_q = k % 2 == 0 ? pose_p : k % 5 == 0 ? Pose() : rounded(random_rotation(random, 4));
    const bool truth = share_a_point(exactly(p, pose_p), exactly(q, pose_q));
    ++(truth ? yes : no);
    wrong += meet<Adaptive>(p, q, pose_p, pose_q) != truth;
    if (k % 4 < 2) wrong += meet<Rational_kernel>(p, q, pose_p, pose_q) != truth;
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(yes > 400);
  BOOST_TEST(no > 400);
}

BOOST_AUTO_TEST_CASE(a_hair_decides)
{
  // A corner on the face, and one ulp above it, under rotations of fractions and of doubles.
  Random random(3);
  int wrong = 0;
  for (int k = 0; k < 400; ++k) {
    const Three t = {{{1, 0, 0}, {1, 3, 0}, {1, 0, 3}}};
    const bool above = k % 2 == 1;
    const Three tip = {{{above ? std::nextafter(1.0, 2.0) : 1.0, 1, 1}, {2, 1, 1}, {2, 2, 1}}};
    const Pose rational = random_rotation(random, 6), pose = k % 3 == 0 ? rounded(rational) : rational;
    wrong += meet<Adaptive>(t, tip, pose, pose) == above;
    wrong += meet<Adaptive>(tip, t, pose, pose) == above;
  }
  BOOST_TEST(wrong == 0);
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
