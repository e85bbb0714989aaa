// Runs the program itself. What `tetracone fuzz` finds is replayed by `tetracone collide`: wrong with the kernel that
// was wrong and right with the exact one.

#include "verify/cases/case_file.h"
#include "verify/test/support/program.h"

#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_fuzz)

using namespace tetracone;
using verify::check_refused;
using verify::contains;
using verify::in_quotes;
using verify::Run;
using verify::run;
using verify::Temporary_file;
using verify::Temporary_folder;
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> files_of(const fs::path& folder)
{
  std::vector<fs::path> files;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  return files;
}

/// A case of the folder of the level and with a wrong subject of this name.
std::optional<fs::path> case_with(const fs::path& folder, verify::Case_kind level, const std::string& subject)
{
  for (const auto& path : files_of(folder)) {
    const auto file = verify::read_case(path);
    if (file.level != level) continue;
    for (const auto& wrong : file.wrong)
      if (wrong.subject == subject && wrong.answer) return path;
  }
  return std::nullopt;
}

}  // namespace

BOOST_AUTO_TEST_CASE(double_is_found_wrong_and_its_cases_replay)
{
  const Temporary_folder folder("fuzz_double");
  const Run r = run("fuzz --seconds 6 --seed 3 --subject 'double brute' --out " + in_quotes(folder.path()));
  BOOST_TEST(r.status == 0, r.error);
  BOOST_TEST(contains(r.out, "double brute"));
  const auto files = files_of(folder.path());
  BOOST_REQUIRE(!files.empty());
  int of_features = 0;
  for (const auto& path : files) {
    BOOST_TEST(verify::is_case_name(path), path);
    BOOST_TEST(path.filename().native().starts_with("double-brute-"), path);
    const auto file = verify::read_case(path);
    if (path.native().find("-features-") != std::string::npos) {
      ++of_features;
      const auto features = [&](const std::string& how) {
        return run("collide --features --kernel " + how + " " + in_quotes(path)).out;
      };
      BOOST_TEST(features("double --method brute") != features("rational"), path);
      BOOST_TEST(features("adaptive") == features("rational"), path);
      continue;
    }
    const std::string truth = std::to_string(file.truth) + "\n", wrong = std::to_string(1 - file.truth) + "\n";
    BOOST_TEST(run("collide " + in_quotes(path)).out == truth, path);
    BOOST_TEST(run("collide --kernel rational --method brute " + in_quotes(path)).out == truth, path);
    BOOST_TEST(run("collide --kernel double --method brute " + in_quotes(path)).out == wrong, path);
  }
  BOOST_TEST(of_features > 0);
  // The other ways of asking.
  const std::string first = in_quotes(files.front());
  BOOST_TEST(contains(run("collide --json " + first).out, "\"answer\""));
  BOOST_TEST(run("collide --features " + first).status == 0);
  BOOST_TEST(run("collide --question surface " + first).status == 0);
  BOOST_TEST(contains(run("collide --json --time --repeat 2 " + first).out, "\"ns\""));
  check_refused("collide " + first + " --pose-a " + first, "expected without a case file");
  check_refused("collide " + first + " " + first, "expected without a case file");
  check_refused("collide --strict " + first, "expected without a case file");
  check_refused("collide --kernel foo " + first, "expected adaptive");
}

BOOST_AUTO_TEST_CASE(predicates_are_found_wrong_and_replay_by_the_subjects_name)
{
  const Temporary_folder folder("fuzz_predicate");
  const Run r = run("fuzz --seconds 4 --subject float --out " + in_quotes(folder.path()));
  BOOST_TEST(r.status == 0, r.error);
  const auto path = case_with(folder.path(), verify::Case_kind::predicate, "float");
  BOOST_REQUIRE(path.has_value());
  const auto file = verify::read_case(*path);
  std::string wrong;
  for (const auto& each : file.wrong)
    if (each.subject == "float") wrong = std::to_string(*each.answer) + "\n";
  BOOST_TEST(run("collide " + in_quotes(*path)).out == std::to_string(file.truth) + "\n");
  BOOST_TEST(run("collide --kernel float " + in_quotes(*path)).out == wrong);
  check_refused("collide --features " + in_quotes(*path), "asks a predicate");
  check_refused("collide --question solid " + in_quotes(*path), "asks a predicate");
  check_refused("collide --method brute " + in_quotes(*path), "asks a predicate");
  check_refused("collide --kernel foo " + in_quotes(*path), "expected a subject of predicates");
}

BOOST_AUTO_TEST_CASE(exact_subjects_find_nothing)
{
  const Temporary_folder folder("fuzz_exact");
  const Run r = run("fuzz --seconds 3 --subject adaptive --out " + in_quotes(folder.path()));
  BOOST_TEST(r.status == 0, r.out << r.error);
  BOOST_TEST(files_of(folder.path()).empty());
  BOOST_TEST(contains(r.out, "exact"));
}

BOOST_AUTO_TEST_CASE(somebody_elses_program_is_found_wrong)
{
  const Temporary_folder folder("fuzz_command");
  const Temporary_file script("no.py", R"(
import json, sys
for line in sys.stdin:
    m = json.loads(line)
    if "ask" in m: print(json.dumps({"ask": m["ask"], "answer": 0}), flush=True)
)");
  const Run r = run("fuzz --seconds 4 --subject mine --subject-command 'mine=" TETRACONE_PYTHON " " +
                    script.path().native() + "' --out " + in_quotes(folder.path()));
  BOOST_TEST(r.status == 0, r.error);
  const auto path = case_with(folder.path(), verify::Case_kind::object, "mine");
  BOOST_REQUIRE(path.has_value());
  BOOST_TEST(path->filename().native().starts_with("mine-"));
  BOOST_TEST(run("collide " + in_quotes(*path)).out == "1\n");
}

BOOST_AUTO_TEST_CASE(one_family_is_fuzzed_alone_and_other_names_are_refused)
{
  const Temporary_folder folder("fuzz_family");
  const std::string words = "fuzz --seconds 3 --subject double --out " + in_quotes(folder.path()) + " --family ";
  const Run r = run(words + "vertex-on-face --family stacked");
  BOOST_TEST(r.status == 0, r.error);
  BOOST_REQUIRE(!files_of(folder.path()).empty());
  for (const auto& path : files_of(folder.path())) {
    const std::string family = verify::read_case(path).object ? verify::read_case(path).object->origin.family
                                                              : verify::read_case(path).points->origin.family;
    BOOST_TEST((family == "vertex-on-face" || family == "stacked"), path << ": " << family);
  }
  check_refused(words + "vertex-on-fase", "expected one of random, ");
  check_refused(words + "point-on-face", "--family point-on-face");
}

BOOST_AUTO_TEST_SUITE_END()
