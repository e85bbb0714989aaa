#include "verify/campaign/database.h"

#include "tetracone/covering/io/input_error.h"
#include "verify/test/support/temporary_file.h"

#include <boost/test/unit_test.hpp>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

BOOST_AUTO_TEST_SUITE(test_database)

using namespace tetracone::verify;
using tetracone::covering::Input_error;
using Mode = Database::Mode;

namespace {

struct Fresh {
  Temporary_file file{"database.db", ""};
};

}  // namespace

BOOST_FIXTURE_TEST_CASE(values_come_back_as_they_went_in, Fresh)
{
  Database database(file.path(), Mode::write);
  database.run("CREATE TABLE t (a INTEGER, b REAL, c TEXT)");
  Database::Statement insert(database, "INSERT INTO t VALUES (?1, ?2, ?3)");
  insert.run(std::int64_t(-5), 0.1, "it's, \"so\"");
  insert.run(std::uint64_t(1) << 62, -std::numeric_limits<double>::infinity(), std::string());
  insert.run(true, 5e-324, "");
  Database::Statement rows(database, "SELECT a, b, c FROM t ORDER BY rowid");
  rows.with();
  BOOST_TEST(rows.columns() == 3);
  BOOST_TEST(rows.name(2) == "c");
  BOOST_TEST_REQUIRE(rows.next());
  BOOST_TEST(rows.integer(0) == -5);
  BOOST_TEST(rows.real(1) == 0.1);
  BOOST_TEST(rows.text(2) == "it's, \"so\"");
  BOOST_TEST_REQUIRE(rows.next());
  BOOST_TEST(rows.integer(0) == std::int64_t(1) << 62);
  BOOST_TEST(std::isinf(rows.real(1)));
  BOOST_TEST_REQUIRE(rows.next());
  BOOST_TEST(rows.real(1) == 5e-324);
  BOOST_TEST(!rows.next());
}

BOOST_FIXTURE_TEST_CASE(a_transaction_without_commit_leaves_nothing, Fresh)
{
  Database database(file.path(), Mode::write);
  database.run("CREATE TABLE t (a)");
  {
    Database::Transaction transaction(database);
    database.run("INSERT INTO t VALUES (1)");
  }
  {
    Database::Transaction transaction(database);
    database.run("INSERT INTO t VALUES (2)");
    transaction.commit();
  }
  Database::Statement rows(database, "SELECT a FROM t");
  BOOST_TEST_REQUIRE(rows.with().next());
  BOOST_TEST(rows.integer(0) == 2);
  BOOST_TEST(!rows.next());
}

BOOST_FIXTURE_TEST_CASE(what_is_no_database_is_refused_with_its_name, Fresh)
{
  const auto names_the_file = [](const std::filesystem::path& path) {
    return [path](const Input_error& error) { return std::string(error.what()).starts_with(path.native() + ": "); };
  };
  const Temporary_file text("text.db", std::string(4096, 'x'));
  BOOST_CHECK_EXCEPTION(Database(text.path(), Mode::write), Input_error, names_the_file(text.path()));
  const auto missing = file.path().parent_path() / "tetracone_no_such_folder" / "a.db";
  BOOST_CHECK_EXCEPTION(Database(missing, Mode::write), Input_error, names_the_file(missing));
  BOOST_CHECK_EXCEPTION(Database(missing, Mode::read), Input_error, names_the_file(missing));
  Database database(file.path(), Mode::write);
  BOOST_CHECK_EXCEPTION(Database::Statement(database, "SELECT * FROM nothing"), Input_error,
                        names_the_file(file.path()));
  BOOST_CHECK_EXCEPTION(database.run("no SQL"), Input_error, names_the_file(file.path()));
}

BOOST_FIXTURE_TEST_CASE(an_archived_database_is_read_where_nothing_may_be_written, Fresh)
{
  const Temporary_folder folder("archive ?#%");
  std::filesystem::create_directory(folder.path());
  const auto path = folder.path() / "a b%3f.db";
  Database(path, Mode::write).run("CREATE TABLE t (a); INSERT INTO t VALUES (7)");
  BOOST_TEST(!std::filesystem::exists(path.native() + "-wal"));
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0555));
  // The superuser may write anywhere.
  const bool super = ::geteuid() == 0;
  if (super) BOOST_TEST_REQUIRE(::seteuid(65534) == 0);
  std::string read;
  try {
    Database database(path, Mode::read);
    Database::Statement rows(database, "SELECT a FROM t");
    if (rows.with().next()) read = rows.text(0);
  } catch (const Input_error& error) {
    read = error.what();
  }
  if (super) BOOST_TEST_REQUIRE(::seteuid(0) == 0);
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
  BOOST_TEST(read == "7");
}

BOOST_AUTO_TEST_SUITE_END()
