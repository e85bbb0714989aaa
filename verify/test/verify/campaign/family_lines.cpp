#include "verify/campaign/family_lines.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

BOOST_AUTO_TEST_SUITE(test_family_lines)

using namespace tetracone::verify;

BOOST_AUTO_TEST_CASE(every_family_has_its_line_and_is_described)
{
  std::set<std::string_view> names;
  for (const Family_line& line : family_lines()) {
    BOOST_TEST(names.insert(line.name).second, line.name);
    BOOST_TEST(!line.levels.empty(), line.name);
    BOOST_TEST(line.what.size() >= 6, line.name);
    BOOST_TEST(line.parameter.empty() == line.sweep.empty(), line.name);
  }
  for (const auto& [name, levels] :
       {std::pair{"sliver", "predicate object features contacts distances relations exits"},
        {"parallel", "distances"},
        {"ray-in-plane", "rays"},
        {"motion-rolling", "motions"}}) {
    const auto lines = family_lines();
    const auto found = std::ranges::find(lines, name, &Family_line::name);
    BOOST_REQUIRE_MESSAGE(found != lines.end(), name);
    BOOST_TEST(found->levels == levels, name);
  }
}

BOOST_AUTO_TEST_CASE(a_sweep_names_each_value_once)
{
  BOOST_TEST(sweep_text({"object", "f", "what", "p", {1, 0.5, 1, HUGE_VAL, 0.5}}) == "1 0.5 inf");
  BOOST_TEST(sweep_text({"motions", "f", "what", "", {}}).empty());
}

BOOST_AUTO_TEST_SUITE_END()
