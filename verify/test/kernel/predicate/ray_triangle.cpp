#include "tetracone/kernel/predicate/ray_triangle.h"

#include "tetracone/kernel/number/products.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_ray_triangle)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

struct Scene {
  Vertex origin, direction;
  std::array<Vertex, 3> triangle;
};

/// A ray through a point of the triangle, or by some units in the last place beside it. The point is inside, on an
/// edge, a corner, or one behind the origin. A fourth of the origins are within rounding of the triangle's plane, most
/// of these in the triangle. Their directions are out of the plane or nearly in it. All but the direction times a power
/// of two.
Scene near_scene(Random& random, int exponent)
{
  Scene scene;
  const bool grid = integer(random, 0, 1);
  const auto vertex = [&] { return grid ? grid_vertex(random, 8) : real_vertex(random, 1); };
  for (Vertex& corner : scene.triangle) corner = vertex();
  scene.origin = vertex();
  if (integer(random, 0, 3) == 0) {
    const double s = real(random, 0, 0.6), t = real(random, 0, 0.6);
    const auto& [a, b, c] = scene.triangle;
    for (int k = 0; k < 3; ++k) scene.origin[k] = a[k] + s * (b[k] - a[k]) + t * (c[k] - a[k]);
  }
  const bool anywhere = integer(random, 0, 3) == 0;
  const Vertex any = real_vertex(random, 1);
  std::array<double, 3> weight{};
  const int kind = integer(random, 0, 3);
  for (int k = 0; k < (kind == 3 ? 3 : kind + 1); ++k) weight[k] = real(random, 0, 1);
  const double sum = weight[0] + weight[1] + weight[2], sense = integer(random, 0, 4) ? 1 : -1;
  const int off = integer(random, -2, 2), power = integer(random, -30, 30);
  for (int k = 0; k < 3; ++k) {
    double target = 0;
    for (int c = 0; c < 3; ++c) target += scene.triangle[c][k] * (weight[c] / sum);
    const double along = sense * (target - scene.origin[k]);
    scene.direction[k] = std::ldexp(anywhere ? any[k] : along + off * (k == 1) * std::abs(along) * 0x1p-52, power);
  }
  for (Vertex* const vertex : {&scene.origin, &scene.triangle[0], &scene.triangle[1], &scene.triangle[2]})
    for (double& x : *vertex) x = std::ldexp(x, exponent);
  return scene;
}

/// `t` tells where the ray meets the plane, for the direction as given, if in one point. `meets_line` tells whether the
/// line meets the closed triangle there. It takes signs past the edges, none of the library's.
struct Truth {
  std::optional<Rational> t;
  bool meets_line = false;
};

Truth truth(const Scene& scene)
{
  using namespace rationals;
  std::array<rationals::Vector, 3> corner;
  for (int k = 0; k < 3; ++k) corner[k] = minus(exactly(scene.triangle[k]), exactly(scene.origin));
  const rationals::Vector d = exactly(scene.direction),
                          n = outer(minus(corner[1], corner[0]), minus(corner[2], corner[0]));
  const Rational along = inner(n, d);
  Truth result;
  if (along == 0) return result;
  result.t = Rational(inner(n, corner[0]) / along);
  bool left = false, right = false;
  for (int k = 0; k < 3; ++k) {
    const int side = sign(determinant(d, corner[k], corner[(k + 1) % 3]));
    left = left || side > 0;
    right = right || side < 0;
  }
  result.meets_line = !(left && right);
  return result;
}

BOOST_AUTO_TEST_CASE(what_is_decided_and_rounded_is_what_rationals_say)
{
  Random random(7);
  int yes = 0, no = 0, uncertain = 0, rounded = 0;
  for (const int exponent : {0, -80, 80, -240, 240})
    for (int k = 0; k < 4000; ++k) {
      const Scene scene = near_scene(random, exponent);
      if (scene.direction == Vertex{0, 0, 0}) continue;
      const auto& [a, b, c] = scene.triangle;
      const Ray_triangle ray(scene.origin, scene.direction);
      const Ray_triangle::Decision decision = ray(a, b, c);
      const Truth right = truth(scene);
      const bool meets = right.t && right.meets_line && *right.t >= 0;
      if (decision.meets == Ray_triangle::Meets::yes) {
        ++yes;
        BOOST_TEST_REQUIRE(meets);
        const Rational scale = Rational(std::ldexp(1, ray.exponent())), t = Rational(*right.t * scale);
        BOOST_TEST(Rational(decision.low) <= t);
        BOOST_TEST(Rational(decision.high) >= t);
      } else if (decision.meets == Ray_triangle::Meets::no) {
        ++no;
        BOOST_TEST(!meets);
      } else {
        ++uncertain;
      }
      if (!right.t) continue;
      if (const auto t = ray.rounded(a, b, c)) {
        ++rounded;
        BOOST_TEST(*t == nearest_double(*right.t));
      }
    }
  BOOST_TEST(yes > 1000);
  BOOST_TEST(no > 1000);
  BOOST_TEST(uncertain > 1000);
  BOOST_TEST(rounded > 10000);
}

BOOST_AUTO_TEST_CASE(where_a_ray_nearly_in_the_plane_meets_it_is_rounded_as_rationals_say)
{
  // The less it leaves the plane, the larger are errors of D, as shares of it.
  Random random(17);
  int rounded = 0, not_rounded = 0;
  for (int k = 0; k < 3000; ++k) {
    Scene scene;
    for (Vertex& corner : scene.triangle) corner = real_vertex(random, 1);
    scene.origin = real_vertex(random, 1);
    const auto& [a, b, c] = scene.triangle;
    const Vertex p = difference(b, a), q = difference(c, a), normal = cross(p, q);
    const double s = real(random, -1, 1), t = real(random, -1, 1), leaves = std::ldexp(1, -integer(random, 34, 50));
    for (std::size_t i = 0; i < 3; ++i) scene.direction[i] = s * p[i] + t * q[i] + leaves * normal[i];
    const Truth right = truth(scene);
    if (!right.t) continue;
    const auto found = Ray_triangle(scene.origin, scene.direction).rounded(a, b, c);
    ++(found ? rounded : not_rounded);
    if (found) BOOST_TEST(*found == nearest_double(*right.t));
  }
  BOOST_TEST(rounded > 1000);
  BOOST_TEST(not_rounded > 100);
}

BOOST_AUTO_TEST_CASE(what_degenerates_or_is_out_of_range_is_uncertain)
{
  const Vertex a = {0, 0, 0}, b = {1, 0, 0}, c = {0, 1, 0};
  const auto meets = [](const Vertex& origin, const Vertex& direction, const Vertex& p, const Vertex& q,
                        const Vertex& r) { return Ray_triangle(origin, direction)(p, q, r).meets; };
  const auto uncertain = Ray_triangle::Meets::uncertain;
  BOOST_TEST((meets({0, 0, 1}, {0, 0, -1}, a, b, c) == uncertain));                              // a corner
  BOOST_TEST((meets({0.5, 0.5, 1}, {0, 0, -1}, a, b, c) == uncertain));                          // an edge
  BOOST_TEST((meets({-1, 0.25, 0}, {1, 0, 0}, a, b, c) == uncertain));                           // in the plane
  BOOST_TEST((meets({0.25, 0.25, 0}, {0, 0, 1}, a, b, c) == uncertain));                         // from the triangle
  BOOST_TEST((meets({0.5, 0.25, 1}, {0, 0, -1}, a, b, {2, 0, 0}) != Ray_triangle::Meets::yes));  // no plane
  BOOST_TEST((meets({0x1p260, 0.25, 1}, {0, 0, -1}, a, b, c) == uncertain));
  const double tiny = 0x1p-310;
  BOOST_TEST((meets({tiny / 4, tiny / 4, tiny}, {0, 0, -1}, a, {tiny, 0, 0}, {0, tiny, 0}) == uncertain));
}

BOOST_AUTO_TEST_SUITE_END()
