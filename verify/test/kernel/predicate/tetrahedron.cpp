#include "tetracone/kernel/predicate/tetrahedron.h"

#include "tetracone/kernel/predicate/frame.h"
#include "verify/test/support/kernel_test_case.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <tuple>

BOOST_AUTO_TEST_SUITE(test_tetrahedron)

using namespace tetracone::kernel;

namespace {

using Kernels = std::tuple<Float, Double, Tolerant, Epick, Epeck, Rational_kernel, Adaptive>;
using Grid_point = std::array<std::int64_t, 3>;
using Corners = std::array<Grid_point, 4>;

template <class K>
Point<K> on_grid(const Grid_point& g)
{
  return point<K>(Vertex{double(g[0]), double(g[1]), double(g[2])});
}

template <class K>
Barycentric_signs signs_of(const Grid_point& p, const Corners& v)
{
  return barycentric_signs<K>(on_grid<K>(p), on_grid<K>(v[0]), on_grid<K>(v[1]), on_grid<K>(v[2]), on_grid<K>(v[3]));
}

template <class K>
bool in_cone(const Grid_point& p, const Corners& v)
{
  return is_in_tetra_cone<K>(on_grid<K>(p), on_grid<K>(v[0]), on_grid<K>(v[1]), on_grid<K>(v[2]), on_grid<K>(v[3]));
}

Grid_point operator-(const Grid_point& a, const Grid_point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Grid_point cross(const Grid_point& a, const Grid_point& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

std::int64_t dot(const Grid_point& a, const Grid_point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The barycentric coordinates times the volume: p - v0 over the edges at v0 by the dual basis, and what is left to 1.
std::array<std::int64_t, 4> coordinates(const Grid_point& p, const Corners& v)
{
  const Grid_point x = p - v[0], a = v[1] - v[0], b = v[2] - v[0], c = v[3] - v[0];
  const std::int64_t at_a = dot(x, cross(b, c)), at_b = dot(x, cross(c, a)), at_c = dot(x, cross(a, b));
  return {dot(a, cross(b, c)) - at_a - at_b - at_c, at_a, at_b, at_c};
}

std::int64_t volume(const Corners& v) { return dot(v[1] - v[0], cross(v[2] - v[0], v[3] - v[0])); }

bool is_between(const Grid_point& p, const Grid_point& a, const Grid_point& b)
{
  return cross(p - a, b - a) == Grid_point{} && dot(p - a, b - a) >= 0 && dot(p - b, a - b) >= 0;
}

/// The element by what it is, from the lowest dimension up.
In_tetrahedron feature_by_elements(const Grid_point& p, const Corners& v)
{
  if (volume(v) == 0) return In_tetrahedron::flat;
  for (const Grid_point& corner : v)
    if (p == corner) return In_tetrahedron::vertex;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      if (is_between(p, v[i], v[j])) return In_tetrahedron::edge;
  int on_planes = 0;
  for (int i = 0; i < 4; ++i) {  // the plane of the face without corner i, with its normal towards that corner
    const Grid_point &a = v[(i + 1) % 4], &b = v[(i + 2) % 4], &c = v[(i + 3) % 4];
    const Grid_point normal = cross(b - a, c - a);
    const std::int64_t height = dot(p - a, normal), inward = dot(v[i] - a, normal);
    if ((height > 0 && inward < 0) || (height < 0 && inward > 0)) return In_tetrahedron::outside;
    on_planes += height == 0;
  }
  return on_planes > 0 ? In_tetrahedron::face : In_tetrahedron::inside;
}

class Random_points {
 public:
  explicit Random_points(int seed) : random_(seed) {}
  Grid_point operator()() { return {coordinate_(random_), coordinate_(random_), coordinate_(random_)}; }
  Corners corners() { return {(*this)(), (*this)(), (*this)(), (*this)()}; }

 private:
  std::mt19937 random_;
  std::uniform_int_distribution<int> coordinate_{-2, 2};
};

}  // namespace

KERNEL_TEST_CASE(each_element_of_a_corner_is_named, K, Kernels)
{
  const Corners corner = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}};
  const auto feature = [&](const Grid_point& p) { return signs_of<K>(p, corner).feature(); };
  BOOST_TEST((feature({1, 1, 1}) == In_tetrahedron::inside));
  BOOST_TEST((feature({1, 1, 2}) == In_tetrahedron::face));
  BOOST_TEST((feature({1, 1, 0}) == In_tetrahedron::face));
  BOOST_TEST((feature({2, 2, 0}) == In_tetrahedron::edge));
  BOOST_TEST((feature({0, 0, 3}) == In_tetrahedron::edge));
  BOOST_TEST((feature({0, 0, 0}) == In_tetrahedron::vertex));
  BOOST_TEST((feature({0, 4, 0}) == In_tetrahedron::vertex));
  BOOST_TEST((feature({2, 2, 1}) == In_tetrahedron::outside));
  BOOST_TEST((feature({0, 0, 5}) == In_tetrahedron::outside));
  BOOST_TEST((feature({-1, 0, 0}) == In_tetrahedron::outside));
}

KERNEL_TEST_CASE(coordinates_and_feature_are_those_of_the_integers, K, Kernels)
{
  Random_points random(1);
  std::array<int, 6> seen{};
  int wrong = 0;
  for (int n = 0; n < 40'000; ++n) {
    const Corners v = random.corners();
    const Grid_point p = random();
    const Barycentric_signs signs = signs_of<K>(p, v);
    const std::int64_t six_volumes = volume(v);
    wrong += signs.volume != CGAL::sign(six_volumes);
    const auto exact = coordinates(p, v);
    for (int i = 0; i < 4; ++i) wrong += signs.coordinate[i] != CGAL::sign(exact[i]) * CGAL::sign(six_volumes);
    wrong += signs.feature() != feature_by_elements(p, v);
    ++seen[int(signs.feature())];
  }
  BOOST_TEST(wrong == 0);
  for (const int count : seen) BOOST_TEST(count > 20);
}

KERNEL_TEST_CASE(the_order_of_the_corners_permutes_the_coordinates_and_keeps_the_feature, K, Kernels)
{
  Random_points random(2);
  int wrong = 0;
  for (int n = 0; n < 1'000; ++n) {
    const Corners v = random.corners();
    const Grid_point p = random();
    const Barycentric_signs signs = signs_of<K>(p, v);
    std::array<int, 4> order = {0, 1, 2, 3};
    do {
      const Barycentric_signs permuted = signs_of<K>(p, {v[order[0]], v[order[1]], v[order[2]], v[order[3]]});
      for (int i = 0; i < 4; ++i) wrong += permuted.coordinate[i] != signs.coordinate[order[i]];
      wrong += permuted.feature() != signs.feature() || (permuted.volume == ZERO) != (signs.volume == ZERO);
    } while (std::next_permutation(order.begin(), order.end()));
  }
  BOOST_TEST(wrong == 0);
}

KERNEL_TEST_CASE(the_tetra_cone_is_closed_and_open_at_its_far_end, K, Kernels)
{
  Random_points random(3);
  int wrong = 0, inside = 0, outside = 0, beyond = 0;
  while (inside + outside < 20'000) {
    const Corners v = random.corners();
    if (volume(v) <= 0) continue;  // a tetra-cone is positively oriented
    const Grid_point p = random();
    const auto exact = coordinates(p, v);
    const bool truth = exact[1] >= 0 && exact[2] >= 0 && exact[3] >= 0;
    wrong += in_cone<K>(p, v) != truth;
    // Twice as far from the apex is in the same cone.
    const Grid_point twice = {2 * p[0] - v[0][0], 2 * p[1] - v[0][1], 2 * p[2] - v[0][2]};
    wrong += in_cone<K>(twice, v) != truth;
    for (const Grid_point& corner : v) wrong += !in_cone<K>(corner, v);
    ++(truth ? inside : outside);
    beyond += truth && exact[0] < 0;
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(inside > 1'000);
  BOOST_TEST(beyond > 100);
}

// Errors planted in the header by hand, each seen to fail, and by which test:
//   one coordinate given twice        coordinates_and_feature, each_element, the_order_of_the_corners
//   the cone open at one of its sides  the_tetra_cone

BOOST_AUTO_TEST_SUITE_END()
