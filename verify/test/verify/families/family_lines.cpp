#include "verify/families/family_lines.h"

#include "verify/families/distance_families.h"
#include "verify/families/families.h"
#include "verify/families/moving_body_families.h"
#include "verify/families/probe_families.h"
#include "verify/families/scene_families.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <set>
#include <string_view>

BOOST_AUTO_TEST_SUITE(test_family_lines)

using namespace tetracone::verify;

BOOST_AUTO_TEST_CASE(every_family_has_its_line_and_is_described)
{
  const auto lines = family_lines();
  std::set<std::string_view> names;
  for (const Family_line& line : lines) {
    BOOST_TEST(names.insert(line.name).second, line.name);
    BOOST_TEST(!line.levels.empty(), line.name);
    BOOST_TEST(line.what.size() >= 6, line.name);
    BOOST_TEST(line.parameter.empty() == line.sweep.empty(), line.name);
    const bool is_known = find_family(line.name) || find_distance_family(line.name) || find_probe_family(line.name) ||
                          find_scene_family(line.name) || find_moving_body_family(line.name);
    BOOST_TEST(is_known, line.name);
  }
  BOOST_TEST(names.size() == families().size() + distance_families().size() + point_families().size() +
                                 ray_families().size() + scene_families().size() + moving_body_families().size());
}

BOOST_AUTO_TEST_CASE(a_sweep_names_each_value_once)
{
  BOOST_TEST(sweep_text({"object", "f", "what", "p", {1, 0.5, 1, HUGE_VAL, 0.5}}) == "1 0.5 inf");
  BOOST_TEST(sweep_text({"motions", "f", "what", "", {}}).empty());
}

BOOST_AUTO_TEST_SUITE_END()
