// The corpus. Each file's truth equals the exact answer of today, and exact subjects are right about it. The subjects
// that the file names are still wrong in the recorded way, except for exact ones, which have been mended.

#include "verify/cases/case_file.h"
#include "verify/integer_truth/integer_truth.h"
#include "verify/shrink/shrink.h"
#include "verify/shrink/wrong_answers.h"
#include "verify/truth/predicate_truth.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_corpus)

using namespace tetracone;
using verify::Case_file;
using verify::Case_kind;

namespace {

std::vector<std::filesystem::path> corpus()
{
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(TETRACONE_SOURCE_DIR "/verify/corpus"))
    if (verify::is_case_name(entry.path())) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// The wrong answers of today.
std::vector<verify::Wrong> wrong_now(const Case_file& file)
{
  return file.level == Case_kind::object ? verify::wrong_answers(*file.object, file.question, file.truth)
                                         : verify::wrong_answers(*file.points, *file.predicate, file.truth);
}

bool is_exact(const std::string& subject)
{
  const auto has = [&](const auto& each) { return each.is_exact && each.name == subject; };
  return std::ranges::any_of(verify::object_subjects(), has) || std::ranges::any_of(verify::predicate_subjects(), has);
}

}  // namespace

BOOST_AUTO_TEST_CASE(there_are_cases_of_both_levels_each_a_page)
{
  const auto files = corpus();
  BOOST_TEST(files.size() >= 20u);
  std::set<Case_kind> levels;
  for (const auto& path : files) {
    levels.insert(verify::read_case(path).level);
    std::ifstream in(path);
    BOOST_TEST(std::count(std::istreambuf_iterator<char>(in), {}, '\n') < 80, path);
  }
  BOOST_TEST(levels.size() == 2u);
}

BOOST_AUTO_TEST_CASE(files_are_as_the_program_writes_them)
{
  for (const auto& path : corpus()) {
    std::ifstream in(path);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    BOOST_TEST(verify::to_json(verify::parse_case(text, path.native())) == text, path);
  }
}

BOOST_AUTO_TEST_CASE(both_truths_are_what_the_files_say)
{
  for (const auto& path : corpus()) {
    const Case_file file = verify::read_case(path);
    if (file.level == Case_kind::predicate) {
      BOOST_TEST((verify::true_answer(*file.predicate, *file.points) == file.truth), path);
      BOOST_TEST((verify::integer_truth::answer(*file.predicate, *file.points) == file.truth), path);
      continue;
    }
    for (const auto question : {kernel::Question::surface, kernel::Question::solid}) {
      const auto known = file.object->known(question);
      if (!known) continue;
      BOOST_TEST(verify::true_answer(*file.object, question) == *known, path);
      BOOST_TEST(verify::integer_truth::collide(*file.object, question) == *known, path);
    }
  }
}

BOOST_AUTO_TEST_CASE(exact_subjects_are_right_and_who_was_wrong_is_wrong_in_the_same_way)
{
  for (const auto& path : corpus()) {
    const Case_file file = verify::read_case(path);
    BOOST_TEST(!file.wrong.empty(), path);
    const std::vector<verify::Wrong> now = wrong_now(file);
    for (const verify::Wrong& each : now) BOOST_TEST(!is_exact(each.subject), path << ": " << each.subject);
    for (const verify::Wrong& each : file.wrong) {
      BOOST_TEST((each.answer != file.truth), path << ": " << each.subject);
      BOOST_TEST((is_exact(each.subject) || std::ranges::find(now, each) != now.end()), path << ": " << each.subject);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
