// Runs `tetracone experiment budget` itself, of two frames.

#include "verify/test/support/csv_rows.h"
#include "verify/test/support/program.h"

#include <boost/test/unit_test.hpp>

#include <string>

BOOST_AUTO_TEST_SUITE(test_budget_experiment)

using namespace tetracone::verify;

BOOST_AUTO_TEST_CASE(every_pair_is_decided_rightly_or_undecided)
{
  const Temporary_folder folder("budget");
  const Run r = run("experiment budget --race-frames 40 --out " + in_quotes(folder.path()));
  BOOST_TEST_REQUIRE(r.status == 0, r.error);
  const auto rows = csv_rows(folder.path() / "budget.csv");
  BOOST_TEST_REQUIRE(rows.size() == 30u);
  for (const auto& row : rows) {
    const auto count = [&row](const std::string& name) { return std::stoull(row.at(name)); };
    BOOST_TEST(count("decided") + count("undecided") == count("candidates"));
    BOOST_TEST(count("candidates") > 0u);
    BOOST_TEST(count("wrong") == 0u);
    BOOST_TEST(count("farther_than_said") == 0u);
  }
}

BOOST_AUTO_TEST_SUITE_END()
