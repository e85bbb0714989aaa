#include "verify/relations/motion_relations.h"

#include "verify/families/motion_families.h"

#include <boost/test/unit_test.hpp>

#include <cstdint>
#include <string>

BOOST_AUTO_TEST_SUITE(test_motion_relations)

using namespace tetracone::verify;

BOOST_AUTO_TEST_CASE(relations_hold_and_apply_on_every_family)
{
  Random random(3);
  for (const Motion_relation& relation : motion_relations()) {
    int held = 0;
    for (const Motion_family& family : motion_families())
      for (std::uint64_t k = 0; k < 20; ++k) {
        const Verdict verdict = relation.check(motion_case(family, 11, k), random);
        BOOST_TEST((verdict != Verdict::violated),
                   std::string(relation.name) + ", " + std::string(family.name) + " " + std::to_string(k));
        held += verdict == Verdict::holds;
      }
    BOOST_TEST(held > 100, std::string(relation.name));
  }
}

BOOST_AUTO_TEST_SUITE_END()
