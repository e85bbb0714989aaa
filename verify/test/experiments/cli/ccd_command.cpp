#include "verify/test/support/program.h"

#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <fstream>
#include <string>

BOOST_AUTO_TEST_SUITE(test_ccd_command)

using namespace tetracone::verify;

namespace {

/// A vertex that falls from z = 1 to z = -2 through a face; with the answer behind each line, or without.
std::string falling(const std::string& answer)
{
  std::string text;
  for (const std::string end : {"1,1", "-2,1"})
    for (const std::string& point :
         {"1,4,1,4," + end, std::string("0,1,0,1,0,1"), std::string("1,1,0,1,0,1"), std::string("0,1,1,1,0,1")})
      text += point + answer + "\n";
  return text;
}

}  // namespace

BOOST_AUTO_TEST_CASE(answers_are_lines_and_the_kind_is_the_folders_or_named)
{
  const Temporary_folder folder("queries");
  std::filesystem::create_directories(folder.path() / "vertex-face");
  const auto file = folder.path() / "vertex-face" / "a.csv";
  std::ofstream(file) << falling(",1") << falling("");
  Run made = run("ccd " + in_quotes(file) + " --first");
  BOOST_TEST(made.status == 0);
  BOOST_TEST(made.out == "1 0.3333333333333333 0.33333333333333337\n1 0.3333333333333333 0.33333333333333337\n");
  // As two edges the four points meet nowhere.
  made = run("ccd " + in_quotes(file) + " --kind edge-edge");
  BOOST_TEST(made.status == 1);
  BOOST_TEST(made.out == "0\n0\n");
  BOOST_TEST(contains(made.error, "a.csv:1: the answer is not the file's, the first of 1 of 1"));
}

BOOST_AUTO_TEST_CASE(bad_queries_are_refused_with_their_line)
{
  const Temporary_file good("good.csv", falling(",1")), bad("bad.csv", falling(",1") + "1,2\n");
  check_refused("ccd " + in_quotes(good.path()), "its folder is not named after a kind");
  check_refused("ccd --kind vertex-face " + in_quotes(good.path()) + " " + in_quotes(bad.path()),
                "bad.csv:9: 2 fields");
  check_refused("ccd --kind faces " + in_quotes(good.path()), "--kind");
  check_refused("ccd", "QUERIES");
}

BOOST_AUTO_TEST_SUITE_END()
