#include "tetracone/kernel/contact/convex_depth.h"

#include "tetracone/kernel/contact/rational_map.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_convex_depth)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

/// A bipyramid on the points of a circle about 0, roughly; coordinates are multiples of 1/1024.
Convex_solid bipyramid(std::uint32_t sides, double radius, double height)
{
  const auto grid = [](double x) { return std::round(1024 * x) / 1024; };
  Convex_solid solid;
  for (std::uint32_t k = 0; k < sides; ++k) {
    const double angle = 2 * M_PI * k / sides;
    solid.corners.push_back({grid(radius * std::cos(angle)), grid(radius * std::sin(angle)), 0});
  }
  solid.corners.push_back({0, 0, height});
  solid.corners.push_back({0, 0, -height});
  for (std::uint32_t k = 0; k < sides; ++k) {
    const std::uint32_t next = (k + 1) % sides, last = (k + sides - 1) % sides, top = sides, bottom = sides + 1;
    solid.faces.push_back({k, next, top});
    solid.faces.push_back({next, k, bottom});
    solid.edges.push_back({{k, next}, {2 * k, 2 * k + 1}});
    solid.edges.push_back({{k, top}, {2 * k, 2 * last}});
    solid.edges.push_back({{k, bottom}, {2 * k + 1, 2 * last + 1}});
  }
  return solid;
}

/// A prism over points of the unit circle, rounded. Its two ends are faces of many corners.
Convex_solid prism(std::uint32_t sides, double height)
{
  Convex_solid solid;
  for (const double z : {0.0, height})
    for (std::uint32_t k = 0; k < sides; ++k) {
      const double angle = 2 * M_PI * k / sides;
      solid.corners.push_back({std::cos(angle), std::sin(angle), z});
    }
  solid.faces = {{0, 2, 1}, {sides, sides + 1, sides + 2}};
  for (std::uint32_t k = 0; k < sides; ++k) {
    const std::uint32_t next = (k + 1) % sides, face = 2 + k, next_face = 2 + next;
    solid.faces.push_back({k, next, sides + k});
    solid.edges.push_back({{k, next}, {0, face}});
    solid.edges.push_back({{sides + k, sides + next}, {1, face}});
    solid.edges.push_back({{next, sides + next}, {face, next_face}});
  }
  return solid;
}

/// Returns the least over all directions, in fractions.
Rational square_of_all(const Convex_solid& a, const Pose& pose_a, const Convex_solid& b, const Pose& pose_b)
{
  const std::array<const Convex_solid*, 2> solid = {&a, &b};
  std::array<std::vector<Rational_point>, 2> corners, edges;
  std::vector<Rational_point> directions;
  for (std::size_t body = 0; body < 2; ++body) {
    const Rational_map map(body == 0 ? pose_a : pose_b);
    for (const Vertex& v : solid[body]->corners) corners[body].push_back(map(v));
    const auto step = [&](std::uint32_t from, std::uint32_t to) {
      return difference(corners[body][to], corners[body][from]);
    };
    for (const auto& t : solid[body]->faces) directions.push_back(cross(step(t[0], t[1]), step(t[0], t[2])));
    for (const auto& e : solid[body]->edges) edges[body].push_back(step(e.corners[0], e.corners[1]));
  }
  for (const Rational_point& e : edges[0])
    for (const Rational_point& f : edges[1]) directions.push_back(cross(e, f));
  std::optional<Rational> least;
  for (const Rational_point& n : directions) {
    if (is_zero(n)) continue;
    std::array<std::array<Rational, 2>, 2> range;
    for (std::size_t body = 0; body < 2; ++body) {
      range[body] = {dot(n, corners[body][0]), dot(n, corners[body][0])};
      for (const Rational_point& x : corners[body]) {
        const Rational at = dot(n, x);
        if (at < range[body][0]) range[body][0] = at;
        if (at > range[body][1]) range[body][1] = at;
      }
    }
    for (const Rational& width : {Rational(range[1][1] - range[0][0]), Rational(range[0][1] - range[1][0])}) {
      const Rational square = width * width / dot(n, n);
      if (!least || square < *least) least = square;
    }
  }
  return *least;
}

void check(const Convex_solid& a, const Pose& pose_a, const Convex_solid& b, const Pose& pose_b)
{
  const Convex_depth depth(a, pose_a, b, pose_b);
  BOOST_TEST((depth.square() == square_of_all(a, pose_a, b, pose_b)));
  BOOST_TEST((dot(depth.vector(), depth.vector()) == depth.square()));
}

BOOST_AUTO_TEST_CASE(the_depth_is_the_least_over_all_directions)
{
  Random random(6);
  for (int round = 0; round < 12; ++round) {
    const Convex_solid a = bipyramid(3 + std::uint32_t(round) % 4, 1, real(random, 0.5, 2)),
                       b = bipyramid(7, 1.5, real(random, 0.5, 2));
    check(a, random_rotation(random, 4), b,
          random_rotation(random, 4, {Rational(1, 6), Rational(round) / 60, Rational(1, 14)}));
    std::array<double, 12> sheared = random_affine(random).entries();
    for (const int k : {3, 7, 11}) sheared[std::size_t(k)] = 0.125;
    check(b, random_rotation(random, 4), a, Pose(sheared));
  }
}

BOOST_AUTO_TEST_CASE(parallel_faces_and_edges_and_many_nearest_planes_are_no_hindrance)
{
  for (const std::uint32_t sides : {3u, 4u, 6u}) {
    const Convex_solid a = bipyramid(sides, 1, 1);
    check(a, Pose(), a, Pose());
    check(a, Pose(), a, translation(0.25, 0, 0));
    check(a, Pose(), a, translation(0, 0, 1.5));
  }
}

BOOST_AUTO_TEST_CASE(prisms_have_the_least_over_all_directions)
{
  Random random(8);
  for (const std::uint32_t sides : {3u, 4u, 5u, 9u}) {
    const Convex_solid a = prism(sides, 1), b = prism(7, 0.5);
    for (const Pose& pose : {Pose(), translation(0.25, 0.125, 0.5), translation(0, 0, -0.375)})
      check(a, Pose(), a, pose);
    check(a, Pose(), b, translation(0.5, 0.25, 0.125));
    check(a, random_rotation(random, 4), b, random_rotation(random, 4, {Rational(1, 6), Rational(1, 7), 0}));
  }
}

BOOST_AUTO_TEST_CASE(prisms_over_polygons_of_many_corners_take_no_product_of_parallel_edges)
{
  // A product for each two edges of the ends would be a million planes, each of them compared in fractions.
  const Convex_solid a = prism(500, 1);
  const Convex_depth depth(a, Pose(), a, translation(0.5, 0.25, 0.125));
  BOOST_TEST((depth.square() == Rational(49, 64)));
}

BOOST_AUTO_TEST_CASE(numbers_that_double_cannot_bound_are_compared_in_fractions)
{
  const Convex_solid a = bipyramid(3, 1, 0.75);
  for (const Rational& scale : {Rational(0x1p300), Rational(0x1p-300), Rational(0x1p-1060)}) {
    const Pose large(std::array<Rational, 12>{scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, scale / 4}),
        other(std::array<Rational, 12>{scale, 0, 0, 0, 0, 0, scale, 0, 0, -scale, 0, 0});
    check(a, large, a, other);
  }
}

BOOST_AUTO_TEST_SUITE_END()
