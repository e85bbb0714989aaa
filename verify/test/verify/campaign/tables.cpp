#include "verify/campaign/tables.h"

#include "tetracone/covering/io/input_error.h"
#include "verify/campaign/campaign_schema.h"
#include "verify/test/support/temporary_file.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <string>

BOOST_AUTO_TEST_SUITE(test_tables)

using namespace tetracone::verify;

namespace {

/// A database with a campaign's tables, one run and these rows.
struct Filled {
  explicit Filled(const std::string& rows)
  {
    database.run(campaign_schema);
    database.run(
        "INSERT INTO run VALUES (1, '1', 'c,d', 'f \"g\"', 'p', 7, 0, 'build/tetracone verify --subject "
        "double,brute')");
    database.run(rows);
  }

  Temporary_file file{"tables.db", ""};
  Database database{file.path(), Database::Mode::write};
};

}  // namespace

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

BOOST_AUTO_TEST_CASE(tables_add_up_and_quote)
{
  Filled filled(R"(
    INSERT INTO tally VALUES (1, 'object', 'f', 's', 'solid', 'doubles', 'rho', 0, 10, 1, 2, 1, 0);
    INSERT INTO tally VALUES (1, 'object', 'f', 's', 'solid', 'fractions', 'rho', 1, 5, 0, 0, 0, 3);
    INSERT INTO tally VALUES (1, 'object', 'f', 's', 'solid', 'doubles', 'ulps', 1, 15, 1, 2, 1, 3);
  )");
  BOOST_TEST(table_as_csv(filled.database, "errors") ==
             "level,family,subject,question,n,false_positives,false_negatives,failures\nobject,f,s,solid,15,1,2,1\n");
  BOOST_TEST(table_as_csv(filled.database, "poses") ==
             "level,family,subject,question,poses,n,false_positives,false_negatives,failures,not_asked\n"
             "object,f,s,solid,doubles,10,1,2,1,0\nobject,f,s,solid,fractions,5,0,0,0,3\n");
  BOOST_TEST(
      table_as_csv(filled.database, "distance")
          .starts_with("level,subject,question,poses,axis,bin,n,rate,low,high\nobject,s,solid,doubles,rho,0,10,0.4,"));
  const std::string families = table_as_csv(filled.database, "families");
  BOOST_TEST(families.starts_with("levels,family,what,parameter,sweep\n"));
  BOOST_TEST(families.find("\ndistances,parallel,cubes with parallel faces and edges,") != std::string::npos);
  BOOST_TEST(table_as_csv(filled.database, "families") == families);
  BOOST_TEST(table_as_csv(filled.database, "runs") ==
             "run,version,compiler,flags,processor,seed,real_meshes,again\n1,1,\"c,d\",\"f "
             "\"\"g\"\"\",p,7,0,\"build/tetracone verify --subject double,brute\"\n");
  BOOST_TEST(
      table_as_csv(filled.database, "rates")
          .starts_with(
              "level,family,subject,question,n,not_asked,rate,low,high\nobject,f,s,solid,15,3,0.26666666666666666,"));
  for (const auto& [name, what] : tables()) BOOST_TEST(!table_as_csv(filled.database, name).empty(), name);
}

BOOST_AUTO_TEST_CASE(a_sweep_has_all_cases_of_each_parameter)
{
  // The family edge-in-face-plane sweeps 0, 1, 2, 3: of six cases two have 0, two have 1, one has 2, one has 3.
  Filled filled(R"(
    INSERT INTO done VALUES (7, 'object', 'edge-in-face-plane', 0, 's', 4), (7, 'object', 'edge-in-face-plane', 1, 's', 2);
    INSERT INTO tally VALUES (1, 'object', 'edge-in-face-plane', 's', 'solid', 'doubles', 'rho', 0, 4, 1, 0, 0, 0);
    INSERT INTO tally VALUES (1, 'object', 'edge-in-face-plane', 's', 'solid', 'doubles', 'rho', 1, 2, 0, 0, 0, 0);
    INSERT INTO wrong VALUES (1, 'object', 'edge-in-face-plane', 5, 1, 's', 'solid', 0, 1, -3, 2, NULL);
  )");
  const std::string sweep = table_as_csv(filled.database, "sweeps"), start = "object,edge-in-face-plane,";
  BOOST_TEST(sweep.starts_with("level,family,parameter,subject,question,n,rate,low,high\n"));
  BOOST_TEST(sweep.find(start + "0.0,s,solid,2,0,0,") != std::string::npos);
  BOOST_TEST(sweep.find(start + "1.0,s,solid,2,0.5,") != std::string::npos);
  BOOST_TEST(sweep.find(start + "2.0,s,solid,1,0,0,") != std::string::npos);
  BOOST_TEST(sweep.find(start + "3.0,s,solid,1,0,0,") != std::string::npos);
  BOOST_TEST(std::count(sweep.begin(), sweep.end(), '\n') == 5);
}

BOOST_AUTO_TEST_CASE(a_sweep_leaves_out_what_was_not_asked_whole)
{
  // Family t lacks a shard, and two cases of u were not asked: their parameters are unknown.
  Filled filled(R"(
    INSERT INTO done VALUES (7, 'object', 'edge-in-face-plane', 1, 't', 4), (7, 'object', 'edge-in-face-plane', 0, 'u', 4);
    INSERT INTO tally VALUES (1, 'object', 'edge-in-face-plane', 't', 'solid', 'doubles', 'rho', 0, 4, 1, 0, 0, 0);
    INSERT INTO tally VALUES (1, 'object', 'edge-in-face-plane', 'u', 'solid', 'doubles', 'rho', 0, 2, 0, 0, 0, 2);
  )");
  BOOST_TEST(table_as_csv(filled.database, "sweeps") == "level,family,parameter,subject,question,n,rate,low,high\n");
}

BOOST_AUTO_TEST_CASE(needs_count_each_case_once)
{
  // A peer that was not asked everything says nothing of the cases.
  Filled filled(R"(
    INSERT INTO tally VALUES (1, 'object', 'f', 's', 'solid', 'doubles', 'rho', -9999, 10, 1, 2, 1, 0);
    INSERT INTO tally VALUES (2, 'object', 'f', 's', 'solid', 'doubles', 'rho', -9999, 3, 0, 0, 0, 0);
    INSERT INTO tally VALUES (1, 'object', 'f', 'peer', 'solid', 'doubles', 'rho', -9999, 7, 0, 0, 0, 3);
    INSERT INTO tally VALUES (1, 'object', 'f', 's', 'solid', 'doubles', 'ulps', -9999, 99, 0, 0, 0, 0);
  )");
  BOOST_TEST(table_as_csv(filled.database, "needs") == "level,family,question,bin,n\nobject,f,solid,-9999,13\n");
}

BOOST_AUTO_TEST_CASE(another_database_is_refused)
{
  const Temporary_file file("other.db", "");
  Database database(file.path(), Database::Mode::write);
  BOOST_CHECK_THROW(table_as_csv(database, "errors"), tetracone::covering::Input_error);
}

BOOST_AUTO_TEST_SUITE_END()
