#include "tetracone/tetratree/penetration/inner_balls.h"

#include "tetracone/covering/star_faces.h"
#include "tetracone/kernel/contact/direction_view.h"
#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"
#include "verify/truth/nearest_truth.h"
#include "verify/truth/point_truth.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_inner_balls)

namespace scenes = tetracone::verify::scenes;
namespace verify = tetracone::verify;
using namespace tetracone::tetratree;
using tetracone::covering::Polyhedron;
using tetracone::covering::Vertex;
using tetracone::kernel::Pose;
using tetracone::kernel::Rational;

namespace {

/// A body, and balls inside it.
struct Filled {
  explicit Filled(const Polyhedron& body)
      : tree(body, tetracone::covering::star_faces(body)), locator(tree.model()), balls(tree, locator, true)
  {}

  const std::vector<Ball>& seen(const Pose& pose)
  {
    balls.see(tetracone::kernel::rows_of(pose));
    return balls.seen();
  }

  Bvh8 tree;
  Point_locator locator;
  Inner_balls balls;
};

/// Returns how many of the balls have a point of the placed surface inside, or a centre that is not inside.
int count_wrong(const std::vector<Ball>& balls, const Polyhedron& placed)
{
  const verify::Point_truth inside(placed);
  const verify::Nearest_truth nearest(placed);
  int wrong = 0;
  for (const Ball& ball : balls) {
    const auto& [x, y, z] = ball.centre;
    const Rational radius = ball.radius;
    wrong += inside(Vertex{x, y, z}) <= 0 || nearest({x, y, z}).first < radius * radius;
  }
  return wrong;
}

/// Returns the body moved by a pose under which its vertices are doubles.
Polyhedron placed(Polyhedron body, const Pose& pose)
{
  for (Vertex& v : body.vertices) {
    const auto [x, y, z] = verify::rationals::image(pose, verify::rationals::exactly(v));
    v = {x.get_d(), y.get_d(), z.get_d()};
  }
  return body;
}

}  // namespace

BOOST_AUTO_TEST_CASE(balls_are_inside_the_solid)
{
  for (const auto& [name, body] : scenes::closed_bodies()) {
    BOOST_TEST_INFO_SCOPE(name);
    Filled filled(body);
    BOOST_TEST(count_wrong(filled.seen(Pose()), body) == 0);
  }
  for (const Polyhedron& body : {scenes::cube_with_cavity(), scenes::cube_with_tunnel(), scenes::torus(8, 6)})
    BOOST_TEST(Filled(body).seen(Pose()).size() > 4U);
  BOOST_TEST(Filled(scenes::cube(2)).seen(Pose())[0].radius > 1.8);
  // Far away the grid is finer than the doubles.
  const Polyhedron far = scenes::box({0x1p55, 0, 0}, {0x1p55 + 16, 16, 16});
  BOOST_TEST(count_wrong(Filled(far).seen(Pose()), far) == 0);
}

BOOST_AUTO_TEST_CASE(views_keep_balls_inside)
{
  const Polyhedron body = scenes::cube_with_tunnel();
  Filled filled(body);
  const std::size_t count = filled.seen(Pose()).size();
  const Pose poses[] = {Pose(std::array<double, 12>{0.25, 0, 0, 5, 0, 0.25, 0, -3, 0, 0, 0.25, 1}),
                        Pose(std::array<double, 12>{1, 0.25, 0, 0, 0, 1, -0.125, 2, 0.125, 0, 0.5, 0}),
                        Pose(std::array<double, 12>{1, 1, 1, 0, 0, 1, 1, 0, 0, 0, 1, 0}),
                        Pose(std::array<double, 12>{0, -4, 0, 0, 4, 0, 0, 0, 0, 0, 2, 1 << 20})};
  scenes::Random random(5);
  for (const Pose& pose : poses) {
    const Polyhedron there = placed(body, pose);
    BOOST_TEST(filled.seen(pose).size() == count);
    BOOST_TEST(count_wrong(filled.seen(pose), there) == 0);
    // Balls about any points.
    const verify::Nearest_truth nearest(there);
    std::vector<Ball> about;
    int outside = 0, too_near = 0, far = 0;
    for (int round = 0; round < 200; ++round) {
      const Vertex x = scenes::real_vertex(random, 3.5);
      Ball ball;
      const auto at = verify::rationals::image(pose, verify::rationals::exactly(x));
      for (std::size_t k = 0; k < 3; ++k) ball.centre[k] = at[k].get_d();
      ball.radius = filled.balls.radius_about(ball.centre);
      const Rational square = nearest({ball.centre[0], ball.centre[1], ball.centre[2]}).first, bound = ball.radius;
      if (ball.radius > 0) {
        about.push_back(ball);
      } else {
        ++outside;
        too_near += bound * bound < square;
        far += bound * bound > 64 * square;
      }
    }
    BOOST_TEST(too_near == 0);
    BOOST_TEST(far < outside / 4);
    BOOST_TEST(outside > 20);
    BOOST_TEST(about.size() > 50U);
    BOOST_TEST(count_wrong(about, there) == 0);
  }
  for (const double wrong : {std::nan(""), std::numeric_limits<double>::infinity(), 0x1p300})
    BOOST_TEST(!(filled.balls.radius_about({wrong, 0, 0}) > 0));
  // These numbers are too small.
  BOOST_TEST(filled.seen(Pose(std::array<double, 12>{0x1p-300, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0})).empty());
  BOOST_TEST(!(filled.balls.radius_about({0, 0, 0}) > 0));
}

BOOST_AUTO_TEST_CASE(balls_that_barely_stick_out_are_left_out)
{
  const std::vector<Ball> kept = largest_balls(
      {{{0, 0, 0}, 1}, {{0.5, 0, 0}, 0.5}, {{3, 0, 0}, 2}, {{0.5, 0, 0}, 0.625}, {{9, 0, 0}, 0.25}}, 3, 0.1);
  BOOST_TEST(kept.size() == 3U);
  BOOST_TEST(kept[0].radius == 2);
  BOOST_TEST(kept[1].radius == 1);
  BOOST_TEST(kept[2].radius == 0.625);
}

BOOST_AUTO_TEST_SUITE_END()
