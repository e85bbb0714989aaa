// Runs the program as the transcripts of this folder say. A transcript is a text of commands, and of what each prints:
//
//   $ A command of the shell, in a temporary folder of the transcript.
//   > More lines of it.
//   The lines of its standard output. Three dots are any text, and a line of them is any lines.
//   [2] Its status, which is 0 without this line, and a part of its standard error; that of status 2 is one line.
//
// Lines that begin with # are comments. Empty lines have no meaning; dots stand for output that would look like either.
// The shell knows the program as tetracone, and the paths $program, $cube, $models, $source and $python. The function
// of refused.sh prints words that the program does not refuse.

#include "verify/test/support/program.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_transcripts)

using namespace tetracone::verify;
namespace fs = std::filesystem;

namespace {

struct Step {
  int line;
  std::string command, out;
  int status;
  std::string error;
};

std::vector<Step> steps_of(const fs::path& transcript)
{
  std::vector<Step> steps;
  std::ifstream in(transcript);
  std::string text;
  for (int line = 1; std::getline(in, text); ++line) {
    if (text.empty() || text.starts_with("#")) continue;
    if (text.starts_with("$ ")) {
      steps.push_back({line, text.substr(2) + "\n", "", 0, ""});
      continue;
    }
    BOOST_TEST_REQUIRE(!steps.empty(), transcript << ":" << line);
    Step& step = steps.back();
    if (text.starts_with("> ") || text == ">") {
      step.command += text.substr(std::min<std::size_t>(2, text.size())) + "\n";
    } else if (text.size() > 2 && text[0] == '[' && std::isdigit(static_cast<unsigned char>(text[1])) &&
               text[2] == ']') {
      step.status = text[1] - '0';
      step.error = text.substr(std::min<std::size_t>(4, text.size()));
    } else {
      step.out += text == "..." ? text : text + "\n";
    }
  }
  return steps;
}

/// True when the text is the pattern, in which ... stands for any text.
bool matches(const std::string& text, const std::string& pattern)
{
  std::size_t at = 0;
  for (std::size_t begin = 0;;) {
    const std::size_t end = pattern.find("...", begin);
    const std::string piece = pattern.substr(begin, end == std::string::npos ? end : end - begin);
    if (begin == 0 && !text.starts_with(piece)) return false;
    if (end == std::string::npos)
      return begin == 0 ? text == piece : text.size() >= at + piece.size() && text.ends_with(piece);
    at = text.find(piece, at);
    if (at == std::string::npos) return false;
    at += piece.size();
    begin = end + 3;
  }
}

Run run_in(const fs::path& folder, const std::string& command)
{
  return run_shell("cd " + in_quotes(folder) + "\nprogram=" + in_quotes(program) + " cube='" + cube + "' models='" +
                   models + "' source='" + source + "' python='" TETRACONE_PYTHON "'\n" +
                   "tetracone() { \"$program\" \"$@\"; }\n. \"$source\"/verify/test/experiments/cli/refused.sh\n" +
                   command);
}

}  // namespace

BOOST_AUTO_TEST_CASE(dots_are_any_text)
{
  BOOST_TEST(matches("", ""));
  BOOST_TEST(matches("abc\n", "a...\n"));
  BOOST_TEST(matches("a b c", "...b..."));
  BOOST_TEST(!matches("abc\n", "ab\n"));
  BOOST_TEST(!matches("abc", "...b"));
  BOOST_TEST(!matches("aba", "a...b...b"));
}

BOOST_AUTO_TEST_CASE(commands_print_what_their_transcripts_say)
{
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(source + "/verify/test/experiments/cli")) {
    if (entry.path().extension() != ".txt") continue;
    const Temporary_folder folder("transcript");
    fs::create_directory(folder.path());
    for (const Step& step : steps_of(entry.path())) {
      const Run r = run_in(folder.path(), step.command);
      BOOST_TEST_INFO_SCOPE(entry.path().filename().native() << ":" << step.line << ": " << step.command << r.error);
      BOOST_TEST(matches(r.out, step.out), r.out);
      BOOST_TEST(r.status == step.status);
      if (step.status == 2) BOOST_TEST((r.error.size() > 10 && r.error.find('\n') + 1 == r.error.size()));
      BOOST_TEST(contains(r.error, step.error));
      ++count;
    }
  }
  BOOST_TEST(count > 200u);
}

BOOST_AUTO_TEST_SUITE_END()
