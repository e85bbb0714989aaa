// `tetracone verify`, `merge` and `report` as their users run them.

#include "verify/campaign/database.h"
#include "verify/test/support/program.h"

#include <boost/test/unit_test.hpp>

#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_verify)

using namespace tetracone::verify;

namespace {

/// Starts the program and kills it after so long, if it is still running. Returns whether it was.
bool run_and_kill(std::vector<std::string> arguments, std::chrono::milliseconds after)
{
  arguments.insert(arguments.begin(), program);
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
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
  for (const char* name :
       {"errors", "rates", "subjects", "distance", "blame", "relations", "flips", "truth", "wrong", "runs"}) {
    const Run ran = run("report " + db + " --table " + name);
    BOOST_TEST_REQUIRE(ran.status == 0, ran.error);
    all += ran.out;
  }
  return all;
}

/// A database that is not there yet, removed with all that SQLite puts beside it.
struct Database_file {
  explicit Database_file(const std::string& name)
      : path((std::filesystem::temp_directory_path() /
              ("tetracone_verify_" + std::to_string(getpid()) + "_" + name + ".db"))
                 .native())
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

const std::string campaign =
    "--cases 20 --seed 9 --frames 5 --family stacked --family sliver --family vertex-on-face --subject double "
    "--subject adaptive";

/// The campaign, run to its end once for all that compare with it.
struct Undisturbed {
  Database_file db{"undisturbed"};
  Run ran = run("verify --db " + db.path + " " + campaign);
  std::string all = ran.status == 0 ? tables(db.path) : "";
};

const Undisturbed& undisturbed()
{
  static const Undisturbed once;
  BOOST_TEST_REQUIRE(once.ran.status == 0, once.ran.error);
  return once;
}

}  // namespace

BOOST_AUTO_TEST_CASE(killed_ten_times_it_ends_with_the_rows_of_an_undisturbed_run)
{
  const Database_file disturbed("disturbed");
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
  BOOST_TEST((tables(disturbed.path) == undisturbed().all));
  BOOST_TEST(last.out == undisturbed().ran.out);
  BOOST_TEST(last.error == undisturbed().ran.error);
}

BOOST_AUTO_TEST_CASE(shards_merge_to_the_whole)
{
  const Database_file first("first"), second("second"), merged("merged");
  const std::string& whole = undisturbed().db.path;
  BOOST_TEST(run("verify --shard 0/2 --db " + first.path + " " + campaign).status == 0);
  BOOST_TEST(run("verify --shard 1/2 --db " + second.path + " " + campaign).status == 0);
  BOOST_TEST(run("merge " + merged.path + " " + first.path + " " + second.path).status == 0);
  BOOST_TEST((tables(merged.path) == undisturbed().all));
  // A repeated merge changes nothing; a merge with other words is refused.
  BOOST_TEST(run("merge " + merged.path + " " + first.path).status == 0);
  BOOST_TEST((tables(merged.path) == undisturbed().all));
  check_refused("merge " + merged.path + " " + whole, "shards: 1 instead of 2");
  check_refused("merge " + first.path + " " + whole, first.path);
  const Run both = run("report --progress " + first.path + " " + second.path);
  BOOST_TEST(both.status == 0);
  BOOST_TEST(contains(both.out, ": shard 1 of 2, "), both.out);
  BOOST_TEST(contains(both.out, "all: 2 of 2 shards begun, "), both.out);
  const Run half = run("report --progress " + first.path);
  BOOST_TEST(half.status == 1);
  BOOST_TEST(contains(half.out, "all: 1 of 2 shards begun, "), half.out);
  BOOST_TEST(run("report --progress " + merged.path).status == 0);
  check_refused("report " + first.path + " " + second.path, "expected one database");
}

BOOST_AUTO_TEST_CASE(somebody_elses_program_is_a_subject_and_is_remembered)
{
  // Says no, and dies where a pose is turned.
  const Temporary_file script("mine.py", R"(
import json, sys
for line in sys.stdin:
    m = json.loads(line)
    if "ask" not in m: continue
    if m["pose_b"][1] != 0:
        print("no turned pose is taken", file=sys.stderr)
        sys.exit(1)
    print(json.dumps({"ask": m["ask"], "answer": 0 if m["question"] == "surface" else None}), flush=True)
)");
  const std::string command = TETRACONE_PYTHON " " + script.path().native();
  const Database_file db("mine");
  const std::string words = "verify --db " + db.path +
                            " --cases 16 --frames 0 --level object --family random --family special-poses "
                            "--family vertex-on-face --subject mine --subject-command ";
  const Run first = run(words + "'mine=" + command + "'");
  BOOST_TEST(first.status == 0, first.error);
  Database database(db.path, Database::Mode::read);
  Database::Statement sums(database,
                           "SELECT sum(n), sum(false_negatives), sum(failures), sum(not_asked) FROM tally WHERE axis = "
                           "'rho' AND subject = 'mine'");
  BOOST_TEST_REQUIRE(sums.with().next());
  for (int k = 0; k < 4; ++k) BOOST_TEST(sums.integer(k) > 0, k);
  BOOST_TEST(sums.integer(0) + sums.integer(3) == 2 * 3 * 16);
  // A crash is told with its last words, under the table and in one of its own.
  BOOST_TEST(first.out.find("\nobject mine failed " + std::to_string(sums.integer(2)) +
                            " times, status 1: no turned pose is taken\n") != std::string::npos,
             first.out);
  const std::string failures = run("report " + db.path + " --table failures").out;
  BOOST_TEST(failures.starts_with("level,family,subject,question,how,n,said\nobject,"), failures);
  BOOST_TEST(contains(failures, ",mine,surface,status 1,"), failures);
  BOOST_TEST(contains(failures, ",no turned pose is taken\n"), failures);
  BOOST_TEST(contains(run("report " + db.path + " --table relations").out, ",mine,"));
  BOOST_TEST(run("report " + db.path + " --table commands").out == "subject,command\nmine," + command + "\n");
  const std::string before = tables(db.path);
  BOOST_TEST(run(words + "'mine=" + command + "'").status == 0);
  BOOST_TEST((tables(db.path) == before));
  check_refused(words + "'mine=" + command + " --other'", "expected the same command, or another name");
  BOOST_TEST((tables(db.path) == before));
  for (const std::string wrong : {"mine", "mine=", "'mine= '", "=x", "'my name=x'", "adaptive=x", "CGAL=x", "truth=x"})
    check_refused(words + wrong);
  check_refused(words + "mine=true --subject-command mine=true", "another subject's");
  check_refused(words + "mine=/nowhere/program", "expected a program that the shell can run");
  const Run check = run("verify --check-subject '" + command + "'");
  BOOST_TEST(check.status == 1);
  BOOST_TEST(contains(check.out, "does not follow the protocol"), check.out);
}

BOOST_AUTO_TEST_CASE(the_table_of_errors_has_the_columns_that_others_rely_on)
{
  const Database_file db("columns");
  BOOST_TEST(run("verify --db " + db.path + " --cases 4 --family random --subject double").status == 0);
  const std::string table = run("report " + db.path + " --table errors").out;
  BOOST_TEST(
      table.starts_with("level,family,subject,question,n,false_positives,false_negatives,failures\nfeatures,"
                        "random,double brute,features,4,"));
  BOOST_TEST(contains(table, "\nobject,random,double brute,solid,4,"));
}

BOOST_AUTO_TEST_CASE(a_program_is_asked_of_triangles_and_its_shards_merge_to_the_whole)
{
  const Database_file whole("triangles"), first("triangles_0"), second("triangles_1"), merged("triangles_merged");
  const std::string words =
      " --level predicate --cases 300 --family face-on-face --family random --subject mine --subject-command "
      "'mine=" TETRACONE_PYTHON " " TETRACONE_SOURCE_DIR "/experiments/subjects/triangles.py'";
  for (const auto& [db, shard] : {std::pair(&whole, "0/1"), {&first, "0/2"}, {&second, "1/2"}}) {
    const Run ran = run("verify --db " + db->path + words + " --shard " + shard);
    BOOST_TEST(ran.status == 0, ran.error);
  }
  BOOST_TEST(run("merge " + merged.path + " " + first.path + " " + second.path).status == 0);
  BOOST_TEST((tables(merged.path) == tables(whole.path)));
  // It rounds: it is right where nothing is degenerate, and wrong about faces in one plane. It is asked nothing else.
  const std::string table = run("report " + whole.path + " --table errors").out;
  BOOST_TEST(contains(table, "\npredicate,face-on-face,mine,triangle-triangle,300,"), table);
  BOOST_TEST(!contains(table, "face-on-face,mine,triangle-triangle,300,0,0,"), table);
  BOOST_TEST(contains(table, "\npredicate,random,mine,triangle-triangle,300,0,0,0\n"), table);
  BOOST_TEST(std::ranges::count(table, '\n') == 3, table);
}

BOOST_AUTO_TEST_CASE(families_are_described_where_they_are_named)
{
  const Run list = run("verify --list");
  BOOST_TEST(list.status == 0, list.error);
  for (const std::string line :
       {"Families of predicate object features contacts distances relations exits:", "Families of motions:",
        "  sliver                  triangles of a tiny height", "parameter: height 2^-h: h (2 10 20 30 40 50)",
        "  motion-rolling          a cube turns about an edge above a plate"})
    BOOST_TEST(list.out.find(line) != std::string::npos, line);
  BOOST_TEST(contains(run("verify --help").out, "--list"));
}

BOOST_AUTO_TEST_CASE(a_report_of_another_versions_database_is_refused_in_a_line)
{
  const Database_file db("older");
  BOOST_TEST(run("verify --db " + db.path + " --cases 4 --family random --subject double").status == 0);
  Database(db.path, Database::Mode::write).run("ALTER TABLE tally DROP COLUMN not_asked");
  check_refused("report " + db.path, "no such column");
  const Database_file times("older_times");
  BOOST_TEST(run("verify --db " + times.path + " --cases 4 --family random --subject double").status == 0);
  Database(times.path, Database::Mode::write).run("ALTER TABLE time DROP COLUMN making");
  check_refused("report " + times.path, "another version of tetracone wrote it: table time (");
}

BOOST_AUTO_TEST_CASE(bad_words_are_one_line_and_status_2)
{
  const Database_file db("bad");
  const Temporary_file text("bad.db", std::string(2000, 'x'));
  for (const std::string& arguments :
       {std::string("--family nonsense"), std::string("--subject nonsense"), std::string("--shard 2/2"),
        std::string("--shard 1"), std::string("--shard -1/2"), std::string("--cases 0"), std::string("--cases x"),
        std::string("--level nothing"), std::string("--seed -1")})
    check_refused("verify --db " + db.path + " " + arguments);
  // Command lines of which the whole, or a named part, would ask nothing.
  const std::string mine = "--subject-command 'mine=cat'";
  for (const std::string& arguments :
       {"--level predicate " + mine, "--level predicate --subject mine " + mine, "--level rays --cases 3 " + mine,
        std::string("--level points --family sliver"), std::string("--level object --family scene-grid"),
        std::string("--level scenes --family sliver"), std::string("--level predicate --subject 'double paper'"),
        std::string("--level contacts --subject float")})
    check_refused("verify --db " + db.path + " " + arguments);
  check_refused("verify --db " + db.path + " --level predicate " + mine,
                "level predicate asks no such subject; expected another level, family or subject");
  BOOST_TEST(!std::filesystem::exists(db.path));
  for (const std::string& arguments :
       {"verify --db " + text.path().native(), "report " + text.path().native(), "report " + db.path,
        "report " + text.path().native() + " --table errors", "merge " + db.path + "2/none " + db.path})
    check_refused(arguments);
}

BOOST_AUTO_TEST_CASE(two_that_start_together_on_a_new_database_share_the_work)
{
  const Database_file whole("whole"), shared("shared");
  const std::string words = "--cases 20 --frames 0 --family sliver --subject double";
  BOOST_TEST(run("verify --db " + whole.path + " " + words).status == 0);
  for (int round = 0; round < 4; ++round) {
    shared.clear();
    // Each adds its own shard to one file.
    const auto shard = [&](int k) {
      return " verify --shard " + std::to_string(k) + "/4 --db " + shared.path + " " + words;
    };
    std::string others;
    for (int k = 1; k < 4; ++k) others += in_quotes(program) + shard(k) + " >/dev/null 2>&1 & ";
    run(shard(0) + "; wait", others);
    BOOST_TEST((tables(shared.path) == tables(whole.path)));
  }
}

BOOST_AUTO_TEST_CASE(a_database_is_not_merged_into_itself)
{
  const Database_file db("self"), link("link");
  BOOST_TEST(run("verify --db " + db.path + " --cases 4 --family random --subject double").status == 0);
  const std::string before = tables(db.path);
  std::filesystem::create_symlink(db.path, link.path);
  check_refused("merge " + db.path + " " + db.path, "is an input too");
  check_refused("merge " + db.path + " " + link.path, "is an input too");
  check_refused("merge " + link.path + " " + db.path, "is an input too");
  BOOST_TEST(tables(db.path) == before);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_merged_leaves_no_target)
{
  const Database_file db("source"), target("target");
  const Temporary_file empty("empty.db", "");
  BOOST_TEST(run("verify --db " + db.path + " --cases 4 --family random --subject double").status == 0);
  for (const std::string& sources :
       {target.path + ".missing", db.path + " " + target.path + ".missing", empty.path().native()}) {
    check_refused("merge " + target.path + " " + sources, "verify");
    BOOST_TEST(!std::filesystem::exists(target.path), sources);
  }
}

BOOST_AUTO_TEST_CASE(another_programs_database_is_refused_and_left_as_it_is)
{
  const Database_file theirs("theirs"), ours("ours");
  Database(theirs.path, Database::Mode::write)
      .run("PRAGMA journal_mode = DELETE; CREATE TABLE done (what TEXT); INSERT INTO done VALUES ('dishes')");
  BOOST_TEST(run("verify --db " + ours.path + " --cases 4 --family random --subject double").status == 0);
  const std::string before = contents(theirs.path);
  for (const std::string& words :
       {"verify --cases 4 --family random --subject double --db " + theirs.path,
        "merge " + theirs.path + " " + ours.path, "merge " + ours.path + " " + theirs.path, "report " + theirs.path})
    check_refused(words, theirs.path + ": no such table: ");
  BOOST_TEST(contents(theirs.path) == before);
}

BOOST_AUTO_TEST_CASE(a_report_without_memory_is_one_line)
{
  const Database_file db("memory");
  const Temporary_folder out("memory_report");
  BOOST_TEST(run("verify --db " + db.path + " --cases 4 --family random --subject double").status == 0);
  const std::string report = "report " + db.path + " --out " + in_quotes(out.path());
  const Run whole = run(report);
  BOOST_TEST(whole.status == 0, whole.error);  // the page is drawn from the columns that the tables really have
  // A stand-in for matplotlib fails as modules do under a limit of memory. A real limit can leave CPython hanging.
  const Temporary_folder modules("memory_modules");
  std::filesystem::create_directory(modules.path());
  for (const std::string failure :
       {"raise MemoryError", "raise ImportError('failed to map segment from shared object')",
        "import os, signal; os.kill(os.getpid(), signal.SIGKILL)"}) {
    std::ofstream(modules.path() / "matplotlib.py") << failure << '\n';
    const Run r = run(report, "PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=" + in_quotes(modules.path()) + " ");
    BOOST_TEST(r.status == 2, failure);
    BOOST_TEST(r.error.find('\n') + 1 == r.error.size(), failure << ": " << r.error);
    BOOST_TEST(!contains(r.error, "Traceback"), r.error);
    BOOST_TEST(contains(r.error, "enough memory"), r.error);
  }
}

BOOST_AUTO_TEST_SUITE_END()
