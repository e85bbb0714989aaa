#include "tetracone/kernel/contact/convex_hull.h"

#include "verify/cases/random.h"
#include "verify/test/support/suite.h"

#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_convex_hull)

using namespace tetracone::kernel;
using tetracone::verify::Random;

namespace {

Rational_point exact(const Vertex& v) { return {Rational(v[0]), Rational(v[1]), Rational(v[2])}; }

Rational determinant(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d)
{
  const Rational_point o = exact(a);
  return dot(cross(difference(exact(b), o), difference(exact(c), o)), difference(exact(d), o));
}

/// True when no point is beyond a triangle, each edge has two triangles, and Euler's formula holds.
bool is_hull(const std::vector<Vertex>& points, const std::vector<std::array<std::uint32_t, 3>>& triangles)
{
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::set<std::uint32_t> corners;
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      corners.insert(t[k]);
      if (!edges.emplace(t[k], t[(k + 1) % 3]).second) return false;
    }
  for (const auto& [p, q] : edges)
    if (!edges.contains({q, p})) return false;
  for (const auto& t : triangles) {
    bool has_area = false;
    for (const Vertex& p : points) {
      const int side = sgn(determinant(points[t[0]], points[t[1]], points[t[2]], p));
      if (side > 0) return false;
      has_area = has_area || side < 0;
    }
    if (!has_area) return false;
  }
  return corners.size() + triangles.size() == edges.size() / 2 + 2;
}

}  // namespace

BOOST_AUTO_TEST_CASE(no_point_is_beyond_the_hull)
{
  Random random(3);
  int found = 0;
  for (int n = 0; n < 300; ++n) {
    const int count = 4 + int(15 * (1 + random.symmetric()));
    std::vector<Vertex> points;
    for (int k = 0; k < count; ++k) {
      Vertex v = {random.symmetric(), random.symmetric(), random.symmetric()};
      // Grids have many points in a plane, on a line, and equal ones; spheres none inside; small steps nearly so.
      if (n % 5 == 1)
        for (double& x : v) x = std::round(2 * x);
      if (n % 5 == 2) {
        const double length = std::sqrt(dot(v, v));
        for (double& x : v) x /= length;
      }
      if (n % 5 == 3)
        for (double& x : v) x = std::round(x) + 0x1p-52 * std::round(2 * random.symmetric());
      if (n % 5 == 4)
        for (double& x : v) x = std::ldexp(std::round(3 * x), n % 2 == 0 ? 900 : -900);
      points.push_back(v);
    }
    const auto hull = Convex_hull::of(points);
    if (!hull) continue;
    ++found;
    BOOST_TEST(is_hull(points, hull->triangles()));
  }
  BOOST_TEST(found > 200);
}

BOOST_AUTO_TEST_CASE(points_in_a_plane_have_no_hull)
{
  BOOST_TEST(!Convex_hull::of({}).has_value());
  std::vector<Vertex> points(4, Vertex{1, 2, 3});
  BOOST_TEST(!Convex_hull::of(points).has_value());
  points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {7, 0, 0}};
  BOOST_TEST(!Convex_hull::of(points).has_value());
  points = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {3, 3, 1}, {-1, 2, 1}};
  BOOST_TEST(!Convex_hull::of(points).has_value());
  points.push_back({0, 0, 1 + 0x1p-52});
  BOOST_REQUIRE(Convex_hull::of(points).has_value());
  BOOST_TEST(is_hull(points, Convex_hull::of(points)->triangles()));
}

BOOST_AUTO_TEST_SUITE_END()
