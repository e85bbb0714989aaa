// `tetracone verify`, `merge` and `report` as their users run them.

#include "verify/test/support/program.h"
#include "verify/test/support/temporary_file.h"

#include <boost/test/unit_test.hpp>

#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <random>
#include <string>
#include <thread>
#include <vector>

extern char** environ;

using namespace tetracone::verify;

namespace {

/// Starts the program and kills it after so long, if it is still running. Returns whether it was.
bool run_and_kill(std::vector<std::string> arguments, std::chrono::milliseconds after)
{
  arguments.insert(arguments.begin(), program);
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", 1, 0);  // O_WRONLY
  pid_t child;
  BOOST_TEST_REQUIRE(posix_spawn(&child, program.c_str(), &actions, nullptr, argv.data(), environ) == 0);
  posix_spawn_file_actions_destroy(&actions);
  std::this_thread::sleep_for(after);
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status);
}

/// All tables but that of times.
std::string tables(const std::string& db)
{
  std::string all;
  for (const char* name : {"errors", "rates", "subjects", "distance", "blame", "relations", "flips", "truth", "wrong", "runs"}) {
    const Run ran = run("report " + db + " --table " + name);
    BOOST_TEST_REQUIRE(ran.status == 0, ran.error);
    all += ran.out;
  }
  return all;
}

/// A database that is not there yet, removed with all that SQLite puts beside it.
struct Database_file {
  explicit Database_file(const std::string& name)
      : path((std::filesystem::temp_directory_path() / ("tetracone_verify_" + std::to_string(getpid()) + "_" + name + ".db")).native())
  {
    clear();
  }
  ~Database_file() { clear(); }
  void clear() const
  {
    for (const char* suffix : {"", "-wal", "-shm"}) std::filesystem::remove(path + suffix);
  }
  std::string path;
};

const std::string campaign = "--cases 60 --seed 9 --frames 5 --family stacked --family sliver --family vertex-on-face --subject double --subject adaptive";

}  // namespace

BOOST_AUTO_TEST_SUITE(test_verify)

BOOST_AUTO_TEST_CASE(killed_ten_times_it_ends_with_the_rows_of_an_undisturbed_run)
{
  const Database_file whole("whole"), disturbed("disturbed");
  const Run undisturbed = run("verify --db " + whole.path + " " + campaign);
  BOOST_TEST_REQUIRE(undisturbed.status == 0, undisturbed.error);

  std::vector<std::string> words = {"verify", "--db", disturbed.path};
  for (std::size_t at = 0; at < campaign.size();) {
    const std::size_t end = std::min(campaign.find(' ', at), campaign.size());
    words.push_back(campaign.substr(at, end - at));
    at = end + 1;
  }
  std::mt19937 random(3);
  int killed = 0;
  for (int k = 0; k < 10; ++k) killed += run_and_kill(words, std::chrono::milliseconds(30 + random() % 120));
  BOOST_TEST(killed > 0);
  BOOST_TEST_MESSAGE("killed while running: " << killed << " of 10");
  const Run last = run("verify --db " + disturbed.path + " " + campaign);
  BOOST_TEST(last.status == 0, last.error);
  BOOST_TEST((tables(disturbed.path) == tables(whole.path)));
  BOOST_TEST(last.out == undisturbed.out);
  BOOST_TEST(last.error == undisturbed.error);
}

BOOST_AUTO_TEST_CASE(shards_merge_to_the_whole)
{
  const Database_file whole("all"), first("first"), second("second"), merged("merged");
  BOOST_TEST(run("verify --db " + whole.path + " " + campaign).status == 0);
  BOOST_TEST(run("verify --shard 0/2 --db " + first.path + " " + campaign).status == 0);
  BOOST_TEST(run("verify --shard 1/2 --db " + second.path + " " + campaign).status == 0);
  BOOST_TEST(run("merge " + merged.path + " " + first.path + " " + second.path).status == 0);
  BOOST_TEST((tables(merged.path) == tables(whole.path)));
  check_refused("merge " + merged.path + " " + first.path, "already");
}

BOOST_AUTO_TEST_CASE(the_table_of_errors_has_the_columns_that_others_rely_on)
{
  const Database_file db("columns");
  BOOST_TEST(run("verify --db " + db.path + " --cases 4 --family random --subject double").status == 0);
  BOOST_TEST(run("report " + db.path + " --table errors").out.starts_with(
      "level,family,subject,question,n,false_positives,false_negatives,failures\nobject,random,double brute,solid,4,"));
}

BOOST_AUTO_TEST_CASE(bad_words_are_one_line_and_status_2)
{
  const Database_file db("bad");
  const Temporary_file text("bad.db", std::string(2000, 'x'));
  for (const std::string& arguments :
       {std::string("--family nonsense"), std::string("--subject nonsense"), std::string("--shard 2/2"), std::string("--shard 1"),
        std::string("--shard -1/2"), std::string("--cases 0"), std::string("--cases x"), std::string("--level nothing"), std::string("--seed -1")})
    check_refused("verify --db " + db.path + " " + arguments);
  BOOST_TEST(!std::filesystem::exists(db.path));
  for (const std::string& arguments : {"verify --db " + text.path().native(), "report " + text.path().native(), "report " + db.path,
                                       "report " + text.path().native() + " --table errors", "merge " + db.path + "2/none " + db.path})
    check_refused(arguments);
}

BOOST_AUTO_TEST_SUITE_END()
