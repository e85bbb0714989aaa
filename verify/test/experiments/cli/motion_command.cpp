#include "verify/test/support/program.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <string>

BOOST_AUTO_TEST_SUITE(test_motion_command)

using namespace tetracone::verify;

namespace {

std::string motion(const std::string& options) { return "motion " + cube + " " + cube + " " + options; }

std::string option(const std::string& name, const Temporary_file& file)
{
  return " --pose-" + name + " " + in_quotes(file.path());
}

std::string at(double x) { return "1 0 0 " + std::to_string(x) + " 0 1 0 0.25 0 0 1 0.25\n"; }

}  // namespace

BOOST_AUTO_TEST_CASE(a_line_a_motion)
{
  const Temporary_file from("from", at(3)), to("to", at(-3) + at(1) + at(2) + at(-1));
  Run made = run(motion(option("b0", from) + option("b1", to)));
  BOOST_TEST(made.status == 0, made.error);
  BOOST_TEST(made.out == "1 0.3333333333333333 0.33333333333333337\n1 1 1\n0\n1 0.5 0.5\n");
  made = run(motion(option("b0", to) + option("b1", from)));
  BOOST_TEST(made.out == "1 0.3333333333333333 0.33333333333333337\n1 0 0\n0\n1 0 0\n");
  made = run(motion("--features"));
  BOOST_TEST(made.out == "1 0 0\n");
  made = run(motion("--features" + option("b0", from) + option("b1", to)));
  BOOST_TEST(made.out.starts_with("1 0.3333333333333333 0.33333333333333337  "));
}

BOOST_AUTO_TEST_CASE(rigid_motions_and_tables)
{
  // By a quaternion twice as long, which turns nothing, against A; and by a turn beside it.
  const Temporary_file start("start", "1 0 0 0 3 0.25 0.25\n"), end("end", "2 0 0 0 1 0.25 0.25\n1 0 0 0.5 2.5 1 0\n"),
      csv("out.csv", "");
  const Run made = run(motion("--motion rigid --features --time" + option("b0", start) + option("b1", end) + " --csv " +
                              in_quotes(csv.path())));
  BOOST_TEST(made.status == 0, made.error);
  const std::string table = contents(csv.path());
  BOOST_TEST(table.starts_with(
      "motion,answer,lo,hi,feature_a,feature_b,ns,bounding_tests,primitive_tests,exact_fallbacks\n0,1,1,1,"));
  BOOST_TEST(contains(table, "\n1,0,,,,,"));
}

BOOST_AUTO_TEST_CASE(bad_motions_are_refused_with_their_line)
{
  const Temporary_file two("two", at(1) + at(2)), three("three", at(1) + at(2) + at(3)),
      flat("flat", "0 0 0 1 0 1 0 0 0 0 1 0\n"), back("back", "1 0 0 0 0 0 0\n-2 0 0 0 1 1 1\n");
  check_refused(motion(option("a0", two) + option("b1", three)), "2 poses; expected 3");
  check_refused(motion(option("a0", flat)), "flat:1: the 3x3 part has determinant 0");
  const Temporary_file five("five", "1 0 0 0 1\n"), large("large", "2 0 0 0 0 2 0 0 0 0 2 0\n");
  check_refused(motion("--motion rigid" + option("a0", five)), "five:1: 5 numbers; expected 7");
  check_refused(motion("--motion rigid" + option("a0", large)), "large:1: the 3x3 part is no rotation");
  check_refused(motion("--motion rigid" + option("b1", back)), "back:2: the quaternion is against");
  check_refused(motion("--motion rigid" + option("b0", back)), "back:2: the quaternion is against");
  check_refused(motion("--motion round"), "expected linear or rigid");
  check_refused(motion("--question both"), "expected solid or surface");
  check_refused(motion("--time"), "--csv");
  check_refused(motion(option("a1", two) + " --csv " + in_quotes(two.path())), "two");
}

BOOST_AUTO_TEST_CASE(a_path_is_a_motion_from_each_pose_to_the_next)
{
  // Comes near, passes by, comes back into contact, stays in it, goes through and away.
  const Temporary_file path("path", at(6) + at(3) + at(2) + at(-2) + at(-2) + at(-0.5) + at(-5)), csv("path.csv", "");
  const std::string words = motion("--path " + in_quotes(path.path()));
  BOOST_TEST(run(words).out == "0\n0\n1 0.25 0.25\n0\n1 0.6666666666666666 0.6666666666666667\n1 0 0\n");
  BOOST_TEST(run(words + " --first").out == "1 0.25 0.25 2\n");
  BOOST_TEST(run(words + " --first --features").out.starts_with("1 0.25 0.25 2  "));
  BOOST_TEST(run(words + " --first --csv /dev/stdout").out == "motion,answer,lo,hi\n2,1,0.25,0.25\n");
  BOOST_TEST(run(words + " --csv /dev/stdout").out.starts_with("motion,answer,lo,hi\n0,0,,\n1,0,,\n2,1,0.25,0.25\n"));
  BOOST_TEST(run("motion " + cube + " " + cube + " --path - --first", "cat " + in_quotes(path.path()) + " | ").out ==
             "1 0.25 0.25 2\n");
  // A stands elsewhere.
  const Temporary_file away("away", at(100)), far("far", at(-3) + at(-4)), two("two", at(1) + at(2));
  BOOST_TEST(run(words + option("a0", away)).out == "0\n0\n0\n0\n0\n0\n");
  BOOST_TEST(run(words + " --first" + option("a0", away)).out == "0\n");
  BOOST_TEST(run(motion("--path " + in_quotes(far.path()))).out == "0\n");
  check_refused(words + option("a0", two), "2 poses; expected one");
  check_refused(words + option("b0", away), "--pose-b0");
  check_refused(words + option("b1", away), "--pose-b1");
  check_refused(words + option("a1", away), "--pose-a1");
  check_refused(motion("--first"), "--path");
  check_refused(motion("--path " + in_quotes(away.path())), "holds one pose; expected two or more");
  check_refused(words + " --csv " + in_quotes(path.path()), "is an input too");
}

BOOST_AUTO_TEST_CASE(rotation_matrices_move_rigidly)
{
  // A quarter turn about z, exactly, rounded, and by quaternions.
  const Temporary_file start("start", "1 0 0 3 0 1 0 0.25 0 0 1 0.25\n"),
      quarter("quarter", "0 -1 0 1.25 1 0 0 0.25 0 0 1 0.25\n"),
      rounded("rounded", "6.1e-17 -1 0 1.25\n1 6.1e-17 0 0.25\n0 0 1 0.25\n0 0 0 1\n"),
      q0("q0", "1 0 0 0 3 0.25 0.25\n"), q1("q1", "0.7071067811865476 0 0 0.7071067811865476 1.25 0.25 0.25\n");
  const std::string rigid = "--motion rigid";
  const Run exact = run(motion(rigid + option("b0", start) + option("b1", quarter)));
  const Run near = run(motion(rigid + option("b0", start) + option("b1", rounded)));
  const Run quaternions = run(motion(rigid + option("b0", q0) + option("b1", q1)));
  BOOST_TEST(exact.status == 0, exact.error);
  BOOST_TEST(exact.error.empty());
  BOOST_TEST(exact.out.starts_with("1 0."));
  BOOST_TEST(exact.out.substr(0, 12) == quaternions.out.substr(0, 12));
  BOOST_TEST(near.out.substr(0, 12) == exact.out.substr(0, 12));
  BOOST_TEST(
      near.error.find(
          ": 1 matrix is no rotation exactly; the motion is that of quaternions whose rotations differ by at most ") !=
          std::string::npos,
      near.error);
  BOOST_TEST(near.error.find('\n') + 1 == near.error.size());
  const Temporary_file path("path",
                            "1 0 0 3 0 1 0 0.25 0 0 1 0.25\n0 -1 0 3 1 0 0 0.25 0 0 1 0.25\n-1 0 0 3 0 -1 0 0.25 0 0 1 "
                            "0.25\n0 1 0 2 -1 0 0 0.25 0 0 1 0.25\n");
  const Run turned = run(motion(rigid + " --path " + in_quotes(path.path())));
  BOOST_TEST(turned.status == 0, turned.error);
  BOOST_TEST(std::count(turned.out.begin(), turned.out.end(), '\n') == 3);
}

BOOST_AUTO_TEST_CASE(standard_input_is_read_once)
{
  const Temporary_file poses("poses", at(3) + at(0.5));
  const std::string cat = "cat " + in_quotes(poses.path()) + " | ";
  BOOST_TEST(run("collide " + cube + " " + cube + " --pose-b -", cat).out == "0\n1\n");
  BOOST_TEST(run("inside " + cube + " -", "printf '0.5,0.5,0.5\\n2 2 2\\n' | ").out == "1\n-1\n");
  BOOST_TEST(run("ray " + cube + " -", "echo '-1 0.5 0.25 1 0 0' | ").out == "5 1\n");
  const Run twice = run("collide " + cube + " " + cube + " --pose-a - --pose-b -", cat);
  BOOST_TEST(twice.status == 2);
  BOOST_TEST(twice.error == "standard input: is named twice; expected '-' once\n");
  const Run wrong = run("collide " + cube + " " + cube + " --pose-b -", "echo 1 2 3 | ");
  BOOST_TEST(wrong.status == 2);
  BOOST_TEST(wrong.error.starts_with("standard input:1: 3 numbers; expected 12 or 16"), wrong.error);
}

BOOST_AUTO_TEST_SUITE_END()
