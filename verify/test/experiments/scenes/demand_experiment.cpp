// Runs `tetracone experiment demand` itself, of three frames.

#include "verify/test/support/csv_rows.h"
#include "verify/test/support/program.h"

#include <boost/test/unit_test.hpp>

#include <string>

BOOST_AUTO_TEST_SUITE(test_demand_experiment)

using namespace tetracone::verify;

BOOST_AUTO_TEST_CASE(what_is_asked_is_part_of_what_could_be_made_and_grows)
{
  const Temporary_folder folder("demand");
  const Run r = run("experiment demand --race-frames 30 --out " + in_quotes(folder.path()));
  BOOST_TEST_REQUIRE(r.status == 0, r.error);
  const auto rows = csv_rows(folder.path() / "demand.csv");
  BOOST_TEST_REQUIRE(rows.size() == 3u);
  unsigned long long nodes_before = 0, signs_before = 0;
  for (const auto& row : rows) {
    const auto count = [&row](const std::string& name) { return std::stoull(row.at(name)); };
    BOOST_TEST(count("differ") == 0u);
    BOOST_TEST(count("trees") <= count("bodies"));
    BOOST_TEST(count("nodes") < count("nodes_of_whole_trees"));
    BOOST_TEST(count("bytes_of_trees") < count("bytes_of_whole_trees"));
    BOOST_TEST(count("signs_beyond_doubles") <= count("signs"));
    BOOST_TEST(count("nodes") >= nodes_before);
    BOOST_TEST(count("signs") >= signs_before);
    nodes_before = count("nodes");
    signs_before = count("signs");
  }
  BOOST_TEST(nodes_before > 0u);
}

BOOST_AUTO_TEST_SUITE_END()
