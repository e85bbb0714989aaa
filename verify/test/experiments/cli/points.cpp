#include "verify/test/support/program.h"

#include <boost/test/unit_test.hpp>

#include <string>

BOOST_AUTO_TEST_SUITE(test_points)

using namespace tetracone::verify;

namespace {

const std::string open = models + "open.stl";

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

BOOST_AUTO_TEST_CASE(nearest_points_have_a_line_each)
{
  const Temporary_file points("points.txt", "0.25 0.5 0.5\n2 2 2\n1/3 1/2 4/3\n0.5 0.5 0.5\n1 0.5 1\n");
  const std::string ask = "nearest " + cube + " " + in_quotes(points.path());
  const auto lines = run(ask).out;
  BOOST_TEST(contains(lines, "-0.25 0 0.5 0.5 face "));
  BOOST_TEST(contains(lines, "1.7320508075688772 1 1 1 vertex "));
  BOOST_TEST(contains(lines, "0.3333333333333333 0.3333333333333333 0.5 1 face "));
  BOOST_TEST(contains(lines, "-0.5 "));
  BOOST_TEST(contains(lines, " tied\n0 1 0.5 1 edge "));
  BOOST_TEST(contains(run(ask + " --exact").out, "1/9 1/3 1/2 1 face "));
  BOOST_TEST(
      run(ask + " --csv /dev/stdout").out.starts_with("point,distance,x,y,z,holder,ties\n0,-0.25,0,0.5,0.5,face "));
  BOOST_TEST(run(ask + " --csv /dev/stdout --time").out.starts_with("point,distance,x,y,z,holder,ties,ns\n"));
  check_refused("nearest " + open + " " + in_quotes(points.path()), "an open surface has no solid");
  check_refused("nearest " + cube + " " + in_quotes(points.path()) + " --time", "--time: expected --csv");
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

BOOST_AUTO_TEST_CASE(a_face_that_is_not_planar_is_named_at_each_crossing)
{
  // A saddle over its short diagonal from vertex 0 to 2: z = abs(x) / 2.
  const Temporary_file saddle("saddle.off",
                              "OFF\n7 2 0\n0 -1 0\n2 0 1\n0 1 0\n-2 0 1\n0 0 9\n1 0 9\n0 1 9\n4 0 1 2 3\n3 4 5 6\n");
  const auto all = [&](const std::string& ray) {
    const Temporary_file rays("rays.txt", ray + "\n");
    return run("ray " + in_quotes(saddle.path()) + " " + in_quotes(rays.path()) + " --all").out;
  };
  BOOST_TEST(all("-5 0 0.25 1 0 0") == "0 4.5 0 5.5\n");
  // The diagonal, in a point of it, at its end and along it, and a corner of one triangle.
  BOOST_TEST(all("0 0 -1 0 0 1") == "0 1 1 10\n");
  BOOST_TEST(all("-5 0.25 0 1 0 0") == "0 5\n");
  BOOST_TEST(all("0 -1 -1 0 0 1") == "0 1\n");
  BOOST_TEST(all("0 -5 0 0 1 0") == "0 4\n");
  BOOST_TEST(all("2 0 -1 0 0 1") == "0 2\n");
  // In the plane of one triangle, from the diagonal on.
  BOOST_TEST(all("-4 0 -2 2 0 1") == "0 2\n");
  // Two crossings whose t round to one double.
  BOOST_TEST(all("-5 0 8.673617379884035e-19 1 0 0") == "0 5 0 5\n");
}

BOOST_AUTO_TEST_CASE(t_beyond_the_largest_double_is_rounded_as_ieee_754_does)
{
  const std::string largest = "1.7976931348623157e308";
  const Temporary_file wall("wall.off",
                            "OFF\n3 1 0\n" + largest + " -1 -1\n" + largest + " 3 -1\n" + largest + " -1 3\n3 0 1 2\n");
  // 2^969, 2^970: with the largest double below half a step, and half a step.
  const Temporary_file rays("rays.txt", "-4.9896007738368e291 0 0 1 0 0\n-9.9792015476736e291 0 0 1 0 0\n");
  BOOST_TEST(run("ray " + in_quotes(wall.path()) + " " + in_quotes(rays.path())).out ==
             "0 1.7976931348623157e+308\n0 inf\n");
}

BOOST_AUTO_TEST_CASE(an_open_surface_is_refused_with_what_would_close_it)
{
  // A tetrahedron with vertices of their own in each face.
  const std::string vertices =
      "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 0\nv 1 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 1 0\nv 0 0 0\nv 0 0 1\n";
  const Temporary_file points("points.txt", "0.1 0.1 0.1\n");
  const auto refused = [&](const std::string& faces, const std::string& says) {
    const Temporary_file soup("soup.obj", vertices + faces);
    check_refused("inside " + in_quotes(soup.path()) + " " + in_quotes(points.path()), says);
    check_refused("collide " + cube + " " + in_quotes(soup.path()), says);
    BOOST_TEST(run("check " + in_quotes(soup.path())).out.find(says) != std::string::npos, says);
  };
  refused("f 1 2 3\nf 4 5 6\nf 7 8 9\nf 10 11 12\n", "merging equal vertices would: --merge");
  refused("f 1 2 3\nf 4 5 6\nf 7 8 9\nf 10 12 11\n", "merging equal vertices first would: --merge --orient");
  refused("f 1 2 3\nf 4 5 6\nf 7 8 9\n", "consistent orientation alone would not close it");
}

BOOST_AUTO_TEST_CASE(what_a_reader_leaves_out_is_told_by_every_command)
{
  const Temporary_file points("points.txt", "0.5 0.5 0.5\n");
  const Temporary_file more("more.off", contents(cube) + "the end\n");
  const auto r = run("inside " + in_quotes(more.path()) + " " + in_quotes(points.path()));
  BOOST_TEST(r.out == "1\n");
  BOOST_TEST(contains(r.error, "lines behind the last face are left out: 1"), r.error);
}

BOOST_AUTO_TEST_SUITE_END()
