#include "verify/tables.h"

#include "kernel/input_error.h"
#include "verify/campaign_schema.h"
#include "verify/test/temporary_file.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <string>

using namespace tetracone::verify;

BOOST_AUTO_TEST_CASE(wilson_is_the_interval_of_the_textbook)
{
  // By hand: 10 of 100: (0.0552, 0.1744); 0 of 10: (0, 0.2775); 5 of 10: (0.2366, 0.7634).
  BOOST_TEST(std::abs(wilson(10, 100).low - 0.05522914) < 1e-6);
  BOOST_TEST(std::abs(wilson(10, 100).high - 0.17436566) < 1e-6);
  BOOST_TEST(wilson(0, 10).low == 0);
  BOOST_TEST(std::abs(wilson(0, 10).high - 3.841458820694124 / (10 + 3.841458820694124)) < 1e-12);
  BOOST_TEST(std::abs(wilson(5, 10).low - 0.2365931) < 1e-6);
  BOOST_TEST(std::abs(wilson(5, 10).high - 0.7634069) < 1e-6);
}

BOOST_AUTO_TEST_CASE(wilson_is_symmetric_and_narrows)
{
  for (const int n : {1, 2, 7, 100, 100000})
    for (const int hits : {0, 1, n / 2, n - 1, n}) {
      const Interval here = wilson(hits, n), mirrored = wilson(n - hits, n), more = wilson(4 * hits, 4 * n);
      BOOST_TEST(std::abs(here.low - (1 - mirrored.high)) < 1e-12);
      BOOST_TEST(here.low <= double(hits) / n);
      BOOST_TEST(here.high >= double(hits) / n);
      BOOST_TEST(more.high - more.low < here.high - here.low);
    }
  BOOST_TEST(wilson(0, 0).low == 0);
  BOOST_TEST(wilson(0, 0).high == 1);
}

BOOST_AUTO_TEST_CASE(tables_add_up_and_quote)
{
  const Temporary_file file("tables.db", "");
  Database database(file.path(), Database::Mode::write);
  database.run(campaign_schema);
  database.run(R"(
    INSERT INTO run VALUES (1, '1', 'c,d', 'f "g"', 'p', 7, 0);
    INSERT INTO tally VALUES (1, 'object', 'f', 's', 'solid', 'rho', 0, 10, 1, 2, 1, 0);
    INSERT INTO tally VALUES (1, 'object', 'f', 's', 'solid', 'rho', 1, 5, 0, 0, 0, 3);
    INSERT INTO tally VALUES (1, 'object', 'f', 's', 'solid', 'ulps', 1, 15, 1, 2, 1, 3);
  )");
  BOOST_TEST(table_as_csv(database, "errors") ==
             "level,family,subject,question,n,false_positives,false_negatives,failures\nobject,f,s,solid,15,1,2,1\n");
  BOOST_TEST(table_as_csv(database, "runs") ==
             "run,version,compiler,flags,processor,seed,real_meshes\n1,1,\"c,d\",\"f \"\"g\"\"\",p,7,0\n");
  BOOST_TEST(table_as_csv(database, "rates").starts_with(
      "level,family,subject,question,n,not_asked,rate,low,high\nobject,f,s,solid,15,3,0.26666666666666666,"));
  for (const auto& [name, what] : tables()) BOOST_TEST(!table_as_csv(database, name).empty(), name);
}

BOOST_AUTO_TEST_CASE(another_database_is_refused)
{
  const Temporary_file file("other.db", "");
  Database database(file.path(), Database::Mode::write);
  BOOST_CHECK_THROW(table_as_csv(database, "errors"), tetracone::kernel::Input_error);
}
