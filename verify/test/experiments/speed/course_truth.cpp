#include "experiments/speed/course_truth.h"

#include "tetracone/covering/io/input_error.h"
#include "verify/cases/shape_generators.h"
#include "verify/test/support/temporary_file.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <fstream>

BOOST_AUTO_TEST_SUITE(test_course_truth)

using namespace tetracone;
using namespace tetracone::experiments;
using kernel::Pose;

namespace {

/// A cube and a smaller one: apart, touching, crossing, inside, and an ulp apart.
Race_course five_poses()
{
  covering::Polyhedron small = verify::unit_cube();
  for (auto& vertex : small.vertices)
    for (double& x : vertex) x = 0.25 * x + 0.25;
  Race_course course{"line", "cube", 4, verify::unit_cube(), small, {}};
  for (const double x : {2.0, 0.75, 0.5, 0.0, std::nextafter(0.75, 1.0)})
    course.poses_b.push_back(Pose::translation(x, 0, 0));
  return course;
}

const std::vector<char> surface = {0, 1, 1, 0, 0}, solid = {0, 1, 1, 1, 0};

void write(const std::filesystem::path& file, const std::string& text) { std::ofstream(file) << text; }

}  // namespace

BOOST_AUTO_TEST_CASE(every_pose_has_an_answer_to_either_question)
{
  const Course_truth truth = course_truth(five_poses());
  BOOST_TEST(truth.surface == surface, boost::test_tools::per_element());
  BOOST_TEST(truth.solid == solid, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(what_is_kept_is_read_again_and_gone_on_with)
{
  const verify::Temporary_folder folder("course_truth");
  const Race_course course = five_poses();
  const auto file = folder.path() / truth_file(course);
  BOOST_TEST(kept_course_truth(course, folder.path()).solid == solid, boost::test_tools::per_element());
  BOOST_REQUIRE(std::filesystem::exists(file));
  // Another answer than the truth's, and so it is known to have been read.
  write(file, "surface,solid\n1,1\n");
  const Course_truth rest = kept_course_truth(course, folder.path());
  BOOST_TEST(rest.surface == (std::vector<char>{1, 1, 1, 0, 0}), boost::test_tools::per_element());
  BOOST_TEST(rest.solid == (std::vector<char>{1, 1, 1, 1, 0}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(another_body_or_pose_has_another_file)
{
  const Race_course course = five_poses();
  Race_course moved = course, larger = course, fewer = course;
  moved.poses_b[2] = Pose::translation(std::nextafter(0.5, 1.0), 0, 0);
  larger.b.vertices[0][1] = std::nextafter(larger.b.vertices[0][1], 0.0);
  fewer.poses_b.pop_back();
  for (const Race_course& other : {moved, larger, fewer}) BOOST_TEST(truth_file(other) != truth_file(course));
  BOOST_TEST(truth_file(five_poses()) == truth_file(course));
}

BOOST_AUTO_TEST_CASE(a_file_that_is_no_truth_of_the_course_is_refused_with_its_line)
{
  const verify::Temporary_folder folder("course_truth");
  const Race_course course = five_poses();
  const auto file = folder.path() / truth_file(course);
  std::filesystem::create_directories(folder.path());
  for (const std::string text :
       {"pose\n", "surface,solid\n0,0\n1,0\n", "surface,solid\n0,0\n0,0\n0,0\n0,0\n0,0\n0,0\n"}) {
    write(file, text);
    BOOST_CHECK_EXCEPTION(kept_course_truth(course, folder.path()), covering::Input_error,
                          [&](const auto& error) { return std::string(error.what()).find(file.native() + ":") == 0; });
  }
}

BOOST_AUTO_TEST_SUITE_END()
