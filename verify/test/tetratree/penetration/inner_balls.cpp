#include "tetracone/tetratree/penetration/inner_balls.h"

#include "tetracone/covering/star_faces.h"
#include "tetracone/tetratree/door/tetracone.h"
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
using tetracone::kernel::Translation_box;

namespace {

std::vector<Ball> balls_in(const Polyhedron& body)
{
  const Bvh8 tree(body, tetracone::covering::star_faces(body));
  return inner_balls(tree, Point_locator(tree.model()));
}

std::array<Rational, 12> rows_of(const Pose& pose)
{
  std::array<Rational, 12> rows;
  for (int k = 0; k < 12; ++k) rows[std::size_t(k)] = pose.exact(k);
  return rows;
}

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
    const Vertex old = v;
    for (int k = 0; k < 3; ++k) {
      Rational x = pose.exact(4 * k + 3);
      for (int i = 0; i < 3; ++i) x += pose.exact(4 * k + i) * Rational(old[std::size_t(i)]);
      v[std::size_t(k)] = x.get_d();
    }
  }
  return body;
}

}  // namespace

BOOST_AUTO_TEST_CASE(balls_are_inside_the_solid)
{
  for (const auto& [name, body] : scenes::closed_bodies()) {
    BOOST_TEST_INFO_SCOPE(name);
    BOOST_TEST(count_wrong(balls_in(body), body) == 0);
  }
  for (const Polyhedron& body : {scenes::cube_with_cavity(), scenes::cube_with_tunnel(), scenes::torus(8, 6)})
    BOOST_TEST(balls_in(body).size() > 10U);
  BOOST_TEST(balls_in(scenes::cube(2))[0].radius > 1.8);
}

BOOST_AUTO_TEST_CASE(views_keep_balls_inside)
{
  const Polyhedron body = scenes::cube_with_tunnel();
  const std::vector<Ball> balls = balls_in(body);
  const Pose poses[] = {Pose(std::array<double, 12>{0.25, 0, 0, 5, 0, 0.25, 0, -3, 0, 0, 0.25, 1}),
                        Pose(std::array<double, 12>{1, 0.25, 0, 0, 0, 1, -0.125, 2, 0.125, 0, 0.5, 0}),
                        Pose(std::array<double, 12>{0, -4, 0, 0, 4, 0, 0, 0, 0, 0, 2, 1 << 20})};
  for (const Pose& pose : poses) {
    const std::vector<Ball> seen = seen_balls(balls, rows_of(pose));
    BOOST_TEST(seen.size() == balls.size());
    BOOST_TEST(count_wrong(seen, placed(body, pose)) == 0);
  }
  // The rows of this map are too near to one another for any bound, and these numbers are too large or none.
  BOOST_TEST(seen_balls(balls, rows_of(Pose(std::array<double, 12>{1, 1, 1, 0, 0, 1, 1, 0, 0, 0, 1, 0}))).empty());
  BOOST_TEST(
      seen_balls(balls, rows_of(Pose(std::array<double, 12>{0x1p300, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}))).empty());
  for (const double radius : {std::nan(""), std::numeric_limits<double>::infinity(), -1.0, 0.0})
    BOOST_TEST(seen_balls({{{0, 0, 0}, radius}}, rows_of(Pose())).empty());
}

BOOST_AUTO_TEST_CASE(translations_within_a_ball_keep_the_interiors_together)
{
  scenes::Random random(3);
  const Polyhedron a = scenes::triangulated(scenes::torus(8, 6)), b = scenes::cube_with_cavity();
  tetracone::Query query{tetracone::Body(a), tetracone::Body(b)};
  const Pose pose = scenes::rounded(scenes::random_rotation(random));
  const double most = 16;
  const Translation_balls balls(seen_balls(balls_in(a), rows_of(pose)), seen_balls(balls_in(b), rows_of(Pose())), most);
  int held = 0, apart = 0;
  for (int round = 0; round < 2000; ++round) {
    const double half = scenes::real(random, 0, 1);
    const Translation_box box{scenes::real_vertex(random, most - 1), {half, half, half}};
    if (!balls.hold(box)) continue;
    ++held;
    for (int corner = 0; corner < 8; ++corner) {
      tetracone::kernel::Rational_point v;
      for (std::size_t k = 0; k < 3; ++k) v[k] = Rational(box.centre[k]) + ((corner >> k) & 1 ? half : -half);
      const auto [moved, unmoved] = tetracone::kernel::moved_along(pose, Pose(), v, 1);
      const auto relation = query.solid_relation_alone(moved, unmoved);
      apart += relation == tetracone::Solid_relation::disjoint || relation == tetracone::Solid_relation::meet;
    }
  }
  BOOST_TEST(held > 20);
  BOOST_TEST(apart == 0);
  BOOST_TEST(!balls.hold({{std::nan(""), 0, 0}, {0, 0, 0}}));
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
