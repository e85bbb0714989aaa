#include "experiments/speed/benchmark_workload.h"

#include "experiments/peers/peer.h"
#include "tetracone/covering/check.h"
#include "verify/cases/shape_generators.h"
#include "verify/truth/cgal_truth.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

BOOST_AUTO_TEST_SUITE(test_benchmark_workload)

using namespace tetracone;
using namespace tetracone::experiments;
using kernel::Pose;
using kernel::Question;

namespace {

std::size_t hits(const Race_course& course, Question question)
{
  const verify::Brute_body a(course.a), b(course.b);
  std::size_t found = 0;
  for (const Pose& pose : course.poses_b) found += verify::collide(a, Pose(), b, pose, question);
  return found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(poses_are_rigid_and_the_relative_size_is_in_the_vertices)
{
  const auto object = verify::blob(800, 1);
  for (const double ratio : {1.0, 8.0}) {
    const Race_course course = on_trajectory(object, "blob", "contour", ratio, 20, 3);
    BOOST_TEST(course.poses_b.size() == 20u);
    BOOST_TEST(verify::radius(course.a) == ratio * verify::radius(course.b));
    for (const Pose& pose : course.poses_b) BOOST_TEST(is_rigid(pose));
    const std::size_t found = hits(course, Question::surface);
    BOOST_TEST(found >= 1u);
    BOOST_TEST(found <= 2u);  // 5 to 10 %
  }
}

BOOST_AUTO_TEST_CASE(stacked_bodies_touch_exactly_and_an_ulp_parts_them)
{
  for (const Race_course& course : {stacked_boxes(8, 1), face_on_face(3, 8, 2)})
    BOOST_TEST(hits(course, Question::surface) == 8u);
  BOOST_TEST(hits(sliding_apart(3, 8, 2), Question::solid) == 0u);
}

BOOST_AUTO_TEST_CASE(the_inner_shell_touches_nothing_and_is_inside)
{
  const Race_course course = shell_in_shell(800, 6, 1);
  BOOST_TEST(hits(course, Question::surface) == 0u);
  BOOST_TEST(hits(course, Question::solid) == 6u);
}

BOOST_AUTO_TEST_CASE(only_a_star_shaped_body_has_all_its_faces_turned_away_from_its_centroid)
{
  BOOST_TEST(star_share(verify::unit_cube()) == 1);
  BOOST_TEST(star_share(verify::blob(800, 1)) == 1);
  const double knot = star_share(verify::torus_knot(800));
  BOOST_TEST(knot > 0.4);
  BOOST_TEST(knot < 0.9);
}

BOOST_AUTO_TEST_CASE(the_round_knot_is_one_closed_tube_of_about_the_number_of_triangles_asked)
{
  const auto volume = [](const covering::Polyhedron& body) { return covering::check(body).volume->get_d(); };
  double before = 0;
  for (const std::size_t triangles : {1000, 3162, 10000}) {
    const auto knot = verify::round_torus_knot(triangles);
    BOOST_TEST(covering::is_closed(knot));
    BOOST_TEST(2 * knot.vertices.size() == knot.face_count());  // genus 1
    BOOST_TEST(std::abs(double(knot.face_count()) / double(triangles) - 1) < 0.03);
    BOOST_TEST(std::abs(verify::radius(knot) - 1) < 0.05);
    BOOST_TEST(volume(knot) > before);  // rounder, and so fuller
    before = volume(knot);
  }
  BOOST_TEST(before < 1.2 * volume(verify::round_torus_knot(1000)));  // one geometry
}

BOOST_AUTO_TEST_SUITE_END()
