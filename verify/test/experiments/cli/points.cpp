#include "verify/test/support/program.h"

#include <boost/test/unit_test.hpp>

#include <string>

BOOST_AUTO_TEST_SUITE(test_points)

using tetracone::verify::check_refused;
using tetracone::verify::in_quotes;
using tetracone::verify::run;
using tetracone::verify::Temporary_file;

namespace {

const std::string models = TETRACONE_SOURCE_DIR "/verify/test/models/";
const std::string cube = in_quotes(models + "cube.off"), frame = in_quotes(models + "frame.poly"),
                  open = in_quotes(models + "open.stl");

}  // namespace

BOOST_AUTO_TEST_CASE(points_have_a_line_each)
{
  const Temporary_file points("points.txt", "0.5 0.5 0.5\n1 1/3 1/7\n2 0 0\n1.0000000000000002 0.5 0.5\n");
  BOOST_TEST(run("inside " + cube + " " + in_quotes(points.path())).out == "1\n0\n-1\n-1\n");
  const std::string csv = "inside " + cube + " " + in_quotes(points.path()) + " --csv /dev/stdout";
  BOOST_TEST(run(csv).out == "point,answer\n0,1\n1,0\n2,-1\n3,-1\n");
  BOOST_TEST(run(csv + " --time").out.starts_with("point,answer,ns\n0,1,"));
  check_refused("inside " + open + " " + in_quotes(points.path()), "an open surface has no solid");
  check_refused("inside " + cube + " " + in_quotes(points.path()) + " --time", "--time: expected --csv");
}

BOOST_AUTO_TEST_CASE(rays_have_a_line_each)
{
  const Temporary_file rays("rays.txt", "-1 0.5 0.5 3 0 0\n5 5 5 1 0 0\n0.5 0.5 0.5 0 0 1\n");
  const std::string ask = "ray " + cube + " " + in_quotes(rays.path());
  BOOST_TEST(run(ask).out == "5 0.3333333333333333\n-\n1 0.5\n");
  BOOST_TEST(run(ask + " --all").out == "5 0.3333333333333333 3 0.6666666666666666\n-\n1 0.5\n");
  BOOST_TEST(run(ask + " --all --csv /dev/stdout").out ==
             "ray,face,t\n0,5,0.3333333333333333\n0,3,0.6666666666666666\n1,-,\n2,1,0.5\n");
  BOOST_TEST(run("ray " + open + " " + in_quotes(rays.path())).status == 0);
  const Temporary_file none("rays.txt", "0 0 0 0 0 0\n");
  check_refused("ray " + cube + " " + in_quotes(none.path()), ":1: the direction is 0");
}

BOOST_AUTO_TEST_SUITE_END()
