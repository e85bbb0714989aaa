#include "experiments/cli/command_words.h"

#include <boost/test/unit_test.hpp>

#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_command_words)

using namespace tetracone;
using namespace tetracone::experiments;

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

BOOST_AUTO_TEST_SUITE_END()
