#include "verify/relations/moving_body_relations.h"

#include "verify/families/moving_body_families.h"

#include <boost/test/unit_test.hpp>

#include <cstdint>
#include <string>

BOOST_AUTO_TEST_SUITE(test_moving_body_relations)

using namespace tetracone::verify;

BOOST_AUTO_TEST_CASE(relations_hold_on_every_family)
{
  Random random(3);
  for (const Moving_body_relation& relation : moving_body_relations()) {
    int held = 0;
    for (const Moving_body_family& family : moving_body_families())
      for (std::uint64_t k = 0; k < 3; ++k) {
        const Verdict verdict = relation.check(moving_bodies_case(family, 5, k), random);
        BOOST_TEST((verdict != Verdict::violated),
                   std::string(relation.name) + ", " + std::string(family.name) + " " + std::to_string(k));
        held += verdict == Verdict::holds;
      }
    BOOST_TEST(held > 30, std::string(relation.name));
  }
}

BOOST_AUTO_TEST_SUITE_END()
