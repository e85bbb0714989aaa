#include "verify/truth/edge_face.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <random>

BOOST_AUTO_TEST_SUITE(test_edge_face)

using namespace tetracone::verify;
using tetracone::kernel::Rational;
using tetracone::kernel::to_string;

namespace {

using Point = Exact::Point_3;

using Vector = std::array<int, 3>;

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector outer(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
long inner(const Vector& a, const Vector& b) { return long(a[0]) * b[0] + long(a[1]) * b[1] + long(a[2]) * b[2]; }

/// The kind by clipping the edge with the five half-spaces whose intersection the triangle is; whole numbers and
/// fractions.
Contact by_clipping(const Vector& from, const Vector& to, const std::array<Vector, 3>& triangle)
{
  const Vector normal = outer(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0]));
  const Vector back = {-normal[0], -normal[1], -normal[2]};
  std::array<std::array<Vector, 2>, 5> half_spaces = {{{normal, triangle[0]}, {back, triangle[0]}}};
  for (int i = 0; i < 3; ++i)
    half_spaces[2 + i] = {outer(normal, minus(triangle[(i + 1) % 3], triangle[i])), triangle[i]};
  Rational low = 0, high = 1;
  for (const auto& [n, origin] : half_spaces) {  // n (x - origin) >= 0
    const long start = inner(n, minus(from, origin)), slope = inner(n, minus(to, from));
    if (slope == 0) {
      if (start < 0) return Contact::none;
      continue;
    }
    const Rational t = Rational(-start) / Rational(slope);
    if (slope > 0) low = std::max(low, t);
    if (slope < 0) high = std::min(high, t);
  }
  if (from == to) high = low;
  if (low > high) return Contact::none;
  if (low < high) return Contact::coplanar_overlap;
  int borders = 0;
  for (int i = 2; i < 5; ++i) {
    const auto& [n, origin] = half_spaces[i];
    if (Rational(inner(n, minus(from, origin))) + low * Rational(inner(n, minus(to, from))) == 0) ++borders;
  }
  const bool end = from == to || low == 0 || low == 1;
  if (borders == 2) return end ? Contact::vertex_vertex : Contact::vertex_edge;
  if (borders == 1) return end ? Contact::vertex_edge : Contact::edge_edge;
  return end ? Contact::vertex_face : Contact::edge_face;
}

}  // namespace

BOOST_AUTO_TEST_CASE(random_small_triangles_agree_with_clipping)
{
  std::mt19937 random(3);
  std::uniform_int_distribution<int> coordinate(-2, 2);
  const auto corner = [&] { return Vector{coordinate(random), coordinate(random), coordinate(random)}; };
  const auto exact = [](const Vector& v) { return Point(v[0], v[1], v[2]); };
  std::map<Contact, int> seen;
  for (int round = 0; round < 30000; ++round) {
    std::array<Vector, 3> triangle = {corner(), corner(), corner()};
    if (round % 3 == 0)
      for (Vector& v : triangle) v[2] = 0;  // more that lies in one plane
    Vector from = corner(), to = round % 50 == 0 ? from : corner();
    if (round % 9 == 0) from[2] = to[2] = 0;
    const Vector normal = outer(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0]));
    if (normal == Vector{0, 0, 0}) continue;
    const Contact expected = by_clipping(from, to, triangle);
    ++seen[expected];
    const Planar_face face({{exact(triangle[0]), exact(triangle[1]), exact(triangle[2])}});
    BOOST_TEST_INFO_SCOPE("round " << round);
    BOOST_TEST(to_string(edge_face(exact(from), exact(to), face)) == to_string(expected));
  }
  BOOST_TEST(seen.size() == 7u);
  for (const auto& [kind, count] : seen) BOOST_TEST(count > 100, to_string(kind) << " came only " << count << " times");
}

BOOST_AUTO_TEST_SUITE_END()
