// Runs the program itself: exit status, output and errors of `tetracone check`.

#include "verify/test/support/program.h"

#include <boost/test/unit_test.hpp>

#include <string>

BOOST_AUTO_TEST_SUITE(test_check_command)

using namespace tetracone::verify;

BOOST_AUTO_TEST_CASE(help_and_version_succeed_and_show_an_example)
{
  BOOST_TEST(run("--version").out.starts_with("tetracone "));
  BOOST_TEST(run("--help").status == 0);
  BOOST_TEST(contains(run("--help").out, "check"));
  const Run help = run("check --help");
  BOOST_TEST(help.status == 0);
  BOOST_TEST(contains(help.out, "Example: tetracone check"));
}

BOOST_AUTO_TEST_CASE(a_closed_polyhedron_is_status_0)
{
  const Run r = run("check " + models + "cube.off " + models + "frame.poly");
  BOOST_TEST(r.status == 0);
  BOOST_TEST(r.error.empty());
  BOOST_TEST(contains(r.out, "closed              yes"));
  BOOST_TEST(contains(r.out, "genus 1, volume 8"));
  BOOST_TEST(contains(r.out, "2 hole loops turned against the outer loop"));
}

BOOST_AUTO_TEST_CASE(an_open_one_is_status_1_and_named)
{
  const Run r = run("check " + models + "open.stl");
  BOOST_TEST(r.status == 1);
  BOOST_TEST(r.error.empty());
  BOOST_TEST(contains(r.out, "NO: 3 directed edges without enough reverse"));
}

BOOST_AUTO_TEST_CASE(a_face_off_plane_is_status_1_only_with_strict)
{
  const Run r = run("check " + models + "lifted.obj");
  BOOST_TEST(r.status == 0);
  BOOST_TEST(contains(r.out, "NO: 1 face, at most 0.2425"));
  BOOST_TEST(run("check --strict " + models + "lifted.obj").status == 1);
  BOOST_TEST(run("check --strict " + models + "cube.off").status == 0);
}

BOOST_AUTO_TEST_CASE(json_is_one_array_with_exact_fractions)
{
  const Run r = run("check --json " + models + "lifted.obj " + models + "cube.off");
  BOOST_TEST(r.status == 0);
  BOOST_TEST(r.out.starts_with("["));
  BOOST_TEST(r.out.ends_with("]\n"));
  // (1/4)^2 / (1 + (1/4)^2)
  BOOST_TEST(contains(r.out, "\"squared_distance\": \"1/17\""));
  BOOST_TEST(contains(r.out, "\"volume\": \"1\""));
}

BOOST_AUTO_TEST_CASE(merge_and_orient_repair_what_they_can)
{
  // A tetrahedron with vertices per face, one face turned.
  const Temporary_file soup(
      "soup.off",
      "OFF\n12 4 0\n0 0 0\n0 1 0\n1 0 0\n0 0 0\n1 0 0\n0 0 1\n1 0 0\n0 1 0\n0 0 1\n0 1 0\n0 0 1\n0 0 0\n"
      "3 0 1 2\n3 3 4 5\n3 6 7 8\n3 9 10 11\n");
  const std::string file = "'" + soup.path().native() + "'";
  BOOST_TEST(run("check " + file).status == 1);
  BOOST_TEST(contains(run("check " + file).out, "--merge"));
  BOOST_TEST(contains(run("check --merge " + file).out, "consistent orientation would close it: --orient"));
  const Run r = run("check --merge --orient " + file);
  BOOST_TEST(r.status == 0);
  BOOST_TEST(contains(r.out, "8 vertices merged"));
  BOOST_TEST(contains(r.out, "1 face turned round"));
}

BOOST_AUTO_TEST_CASE(bad_use_and_bad_input_are_status_2_with_one_line_and_no_output)
{
  check_refused("");
  check_refused("chek");
  check_refused("check");
  check_refused("check --bogus " + models + "cube.off");
  check_refused("check no/such/file.off");
  check_refused("check " + models);
  check_refused("check /dev/zero");
  check_refused("check ''");
  // Nothing is printed of the good one either.
  check_refused("check " + models + "cube.off no/such/file.off");
  check_refused("check --json " + models + "cube.off no/such/file.off");
  const Temporary_file cut("cut.off", "OFF\n3 1 0\n0 0 0\n");
  check_refused("check '" + cut.path().native() + "'");
}

BOOST_AUTO_TEST_CASE(self_intersections_have_a_line_each_and_status_1)
{
  const Run none = run("check --self-intersections " + models + "frame.poly");
  BOOST_TEST(none.status == 0);
  BOOST_TEST(none.out == "");
  BOOST_TEST(run("check --self-intersections --json " + models + "open.stl").out == "[]\n");
  // Face 1 goes through face 0; faces 2 and 3, which are one, touch it in a point.
  const Temporary_file crossed("crossed.off",
                               "OFF\n12 4 0\n0 0 0\n4 0 0\n0 4 0\n1 1 -1\n1 1 1\n9 9 0\n3 0 0\n3 -1 0\n3 -1 1\n"
                               "3 0 0\n3 -1 0\n3 -1 1\n3 0 1 2\n3 3 4 5\n3 6 7 8\n3 9 10 11\n");
  const Run some = run("check --self-intersections " + in_quotes(crossed.path()));
  BOOST_TEST(some.status == 1);
  BOOST_TEST(some.out == "0 1 segment\n0 2 point\n0 3 point\n2 3 coplanar\n");
  const Run json = run("check --self-intersections --json " + in_quotes(crossed.path()));
  BOOST_TEST(json.status == 1);
  BOOST_TEST(contains(json.out, "\"faces\": ["));
  BOOST_TEST(contains(json.out, "\"kind\": \"coplanar\""));
  check_refused("check --self-intersections " + models + "cube.off " + models + "cube.off", "2 models; expected one");
}

BOOST_AUTO_TEST_SUITE_END()
