#include "verify/searches/searches.h"

#include "verify/proofs/all_proofs.h"
#include "verify/test/support/proofs.h"

#include <boost/test/unit_test.hpp>

#include <set>

BOOST_AUTO_TEST_SUITE(test_searches)

using namespace tetracone::verify::proofs;

BOOST_AUTO_TEST_CASE(no_search_finds_more_than_is_proved_and_each_finds_something)
{
  if (skipped_without_gappa()) return;
  std::set<std::string> names;
  int searched = 0;
  for (const Proved_bound& bound : all_proofs()) {
    BOOST_TEST(names.insert(bound.name).second, bound.name << " stands twice");
    const double found = worst_found(bound.name, 500, 1), proved = bound.proved.get_d() / bound.unit;
    // Each is searched for, or it is said why not.
    BOOST_TEST((found < 0) == !why_not_searched(bound.name).empty(), bound.name);
    if (found < 0) continue;
    ++searched;
    BOOST_TEST(found > 0, bound.name);
    BOOST_TEST(found <= proved, bound.name << ": found " << found << ", proved " << proved);
  }
  BOOST_TEST(searched == 64);
}

BOOST_AUTO_TEST_SUITE_END()
