#include "verify/test/support/program.h"
#include "verify/test/support/temporary_file.h"

#include <boost/test/unit_test.hpp>

#include <fstream>
#include <iterator>
#include <string>

BOOST_AUTO_TEST_SUITE(test_motion_command)

using namespace tetracone::verify;

namespace {

const std::string cube = in_quotes(TETRACONE_SOURCE_DIR "/verify/test/models/cube.off");

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
  std::ifstream in(csv.path());
  const std::string table{std::istreambuf_iterator<char>(in), {}};
  BOOST_TEST(
      table.starts_with("motion,answer,lo,hi,feature_a,feature_b,ns,bounding_tests,primitive_tests,"
                        "exact_fallbacks\n0,1,1,1,"));
  BOOST_TEST(table.find("\n1,0,,,,,") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(bad_motions_are_refused_with_their_line)
{
  const Temporary_file two("two", at(1) + at(2)), three("three", at(1) + at(2) + at(3)),
      flat("flat", "0 0 0 1 0 1 0 0 0 0 1 0\n"), back("back", "1 0 0 0 0 0 0\n-2 0 0 0 1 1 1\n");
  check_refused(motion(option("a0", two) + option("b1", three)), "2 poses; expected 3");
  check_refused(motion(option("a0", flat)), "flat:1: the 3x3 part has determinant 0");
  check_refused(motion("--motion rigid" + option("a0", two)), "two:1: 12 numbers; expected 7");
  check_refused(motion("--motion rigid" + option("b1", back)), "back:2: the quaternion is against");
  check_refused(motion("--motion rigid" + option("b0", back)), "back:2: the quaternion is against");
  check_refused(motion("--motion round"), "expected linear or rigid");
  check_refused(motion("--question both"), "expected solid or surface");
  check_refused(motion("--time"), "--csv");
  check_refused(motion(option("a1", two) + " --csv " + in_quotes(two.path())), "two");
}

BOOST_AUTO_TEST_SUITE_END()
