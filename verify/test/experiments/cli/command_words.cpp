#include "experiments/cli/command_words.h"

#include "verify/test/support/program.h"

#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <set>
#include <sstream>

BOOST_AUTO_TEST_SUITE(test_command_words)

using namespace tetracone;
using namespace tetracone::experiments;
using verify::Run;
using verify::run;

namespace {

/// The fields of a line of a CSV, quotes taken off.
std::vector<std::string> fields(const std::string& line)
{
  std::vector<std::string> all(1);
  bool is_quoted = false;
  for (const char c : line) {
    if (c == '"')
      is_quoted = !is_quoted;
    else if (c == ',' && !is_quoted)
      all.emplace_back();
    else
      all.back() += c;
  }
  return all;
}

/// A CSV without these columns, and the words of its rows.
struct Table {
  std::string text;
  std::set<std::string> again;

  Table(const std::string& csv, const std::set<std::string>& timed)
  {
    std::istringstream lines(csv);
    std::vector<std::string> names;
    for (std::string line; std::getline(lines, line); text += '\n') {
      const auto values = fields(line);
      const bool is_header = names.empty();
      if (is_header) names = values;
      BOOST_TEST_REQUIRE(values.size() == names.size(), line);
      for (std::size_t k = 0; k < values.size(); ++k) {
        if (!timed.contains(names[k])) text += values[k] + '|';
        if (names[k] == "again" && !is_header) again.insert(values[k]);
      }
    }
  }
};

/// Runs words of a row from the project's folder, this program and `to` in the place of build/tetracone and `from`.
Run run_again(std::string words, const std::string& from, const std::filesystem::path& to)
{
  const std::string program = "build/tetracone ";
  BOOST_TEST_REQUIRE(words.starts_with(program), words);
  words.erase(0, program.size());
  const std::size_t at = words.find(from);
  BOOST_TEST_REQUIRE(at != std::string::npos, words);
  words.replace(at, from.size(), from.substr(0, from.find(' ') + 1) + to.native());
  return run(words, "cd '" TETRACONE_SOURCE_DIR "' && ");
}

/// Runs the experiment twice, the second time by the words in its rows alone: all but the timed columns are equal.
void check_experiment(const std::string& words, const std::string& file, const std::set<std::string>& timed,
                      const std::string& again)
{
  const verify::Temporary_folder first("first"), second("second");
  const Run made = run("experiment " + words + " --out " + first.path().native());
  BOOST_TEST_REQUIRE(made.status == 0, made.error);
  const Table rows(verify::contents(first.path() / file), timed);
  BOOST_TEST_REQUIRE((rows.again == std::set<std::string>{again}), *rows.again.begin());
  const Run made_again = run_again(again, "--out out", second.path());
  BOOST_TEST_REQUIRE(made_again.status == 0, made_again.error);
  BOOST_TEST(rows.text == Table(verify::contents(second.path() / file), timed).text);
}

}  // namespace

BOOST_AUTO_TEST_CASE(words_are_the_options_given_and_those_with_a_default_value)
{
  CLI::App app;
  int size = 3, count = 0;
  std::string name;
  std::vector<std::string> list;
  app.add_option("--size", size)->capture_default_str();
  app.add_option("--count", count);
  app.add_option("--name", name);
  app.add_option("--list", list)->allow_extra_args(false);
  app.add_flag("--full");
  const std::vector<std::string> all = {"--list", "--name", "--size", "--count", "--full"};
  const auto words = [&](const std::string& line, const std::vector<std::string>& options) {
    app.parse(line);
    return words_of(app, options);
  };
  BOOST_TEST(words("", all) == " --size 3");
  BOOST_TEST(words("--full --list b --list a --size=7", all) == " --size 7 --list b --list a --full");
  BOOST_TEST(words("--full --size 7", {"--full"}) == " --full");
  BOOST_TEST(words("--name \"" TETRACONE_SOURCE_DIR "/out/it's; 2\"", all) == " --size 3 --name 'out/it'\\''s; 2'");
}

BOOST_AUTO_TEST_CASE(the_words_of_an_experiments_rows_make_the_same_rows_again)
{
  check_experiment("motion --cases 1 --seed 5 --race-frames 7", "motion.csv", {"us"},
                   "build/tetracone experiment motion --out out --seed 5 --cases 1");
  check_experiment("distance --race-frames 3 --points 9", "distance.csv", {"mean_ns"},
                   "build/tetracone experiment distance --out out --race-frames 3 --seed 1");
  check_experiment("sign-maps --size 6", "sign_maps.csv", {},
                   "build/tetracone experiment sign-maps --out out --size 6");
}

BOOST_AUTO_TEST_CASE(the_words_of_a_campaign_ask_it_again_with_its_subjects_and_their_commands)
{
  const verify::Temporary_file first_db("first.db", ""), second_db("second.db", "");
  const verify::Temporary_file script("mine.py", R"(
import json, sys
for line in sys.stdin:
    m = json.loads(line)
    if "ask" in m: print(json.dumps({"ask": m["ask"], "answer": int(m["question"] == "solid")}), flush=True)
)");
  const std::string mine = "mine=" TETRACONE_PYTHON " " + script.path().native();
  const std::string first = first_db.path(), second = second_db.path();
  const Run asked = run("verify --db " + first + " --seed 5 --level object --cases 3 --frames 4 --family random" +
                        " --family sliver --subject 'double brute' --subject-command '" + mine + "'");
  BOOST_TEST_REQUIRE(asked.status == 0, asked.error);
  const Table runs(run("report " + first + " --table runs").out, {});
  BOOST_TEST_REQUIRE(runs.again.size() == 1u);
  BOOST_TEST(*runs.again.begin() ==
             "build/tetracone verify --cases 3 --seed 5 --family random --family sliver --subject 'double brute' "
             "--subject-command '" +
                 mine + "' --subject-limit 10 --level object --frames 4");
  std::string words = *runs.again.begin();
  words.replace(words.find("verify "), 7, "verify --db out/verify.db ");
  const Run asked_again = run_again(words, "--db out/verify.db", second);
  BOOST_TEST_REQUIRE(asked_again.status == 0, asked_again.error);
  for (const char* table : {"runs", "subjects", "errors", "wrong", "flips", "commands", "relations"}) {
    const std::string rows = run("report " + first + " --table " + table).out;
    BOOST_TEST(rows == run("report " + second + " --table " + table).out, table);
    BOOST_TEST(!rows.empty());
  }
}

BOOST_AUTO_TEST_SUITE_END()
