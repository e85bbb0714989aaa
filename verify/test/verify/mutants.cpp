#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_mutants)

// The list of planted errors (verify/mutants) is not run here, which takes many minutes, but it must not go stale.

namespace {

std::string text_of(const std::string& file)
{
  std::ifstream in(std::string(TETRACONE_SOURCE_DIR) + "/" + file);
  BOOST_TEST_REQUIRE(in.good(), file);
  return {std::istreambuf_iterator<char>(in), {}};
}

int count(const std::string& text, const std::string& part)
{
  int found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_planted_error_has_its_one_place_in_the_source)
{
  const auto mutants = nlohmann::json::parse(text_of("verify/mutants/mutants.json"));
  BOOST_TEST(mutants.size() >= 15u);
  std::set<std::string> names;
  for (const auto& mutant : mutants) {
    const std::string name = mutant.at("name"), file = mutant.at("file"), old_text = mutant.at("old"),
                      new_text = mutant.at("new");
    BOOST_TEST_INFO_SCOPE(name);
    BOOST_TEST(names.insert(name).second);
    BOOST_TEST(old_text != new_text);
    BOOST_TEST(count(text_of(file), old_text) == 1, file << " has the old text not once");
    BOOST_TEST(!text_of("verify/test/" + std::string(mutant.at("test")) + ".cpp").empty());
    if (mutant.contains("harmless")) BOOST_TEST(!std::string(mutant.at("harmless")).empty());
    for (const std::string& unit : mutant.value("units", std::vector<std::string>()))
      BOOST_TEST(!text_of(unit).empty());
  }
}

BOOST_AUTO_TEST_SUITE_END()
