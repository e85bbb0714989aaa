#include "verify/relations/contact_relations.h"

#include "verify/families/families.h"

#include <boost/test/unit_test.hpp>

#include <map>
#include <string_view>

BOOST_AUTO_TEST_SUITE(test_contact_relations)

using namespace tetracone::verify;

BOOST_AUTO_TEST_CASE(relations_of_contacts_hold)
{
  const auto ask = contact_subjects()[0].make();
  std::map<std::string_view, int> applied;
  for (const char* family : {"face-on-face", "edge-across-edge", "swept-contact", "random"})
    for (std::uint64_t k = 0; k < 4; ++k) {
      const Object_case c = find_family(family)->object_case(9, k);
      const Listed_contacts given = ask->contacts(c);
      for (const Contact_relation& relation : contact_relations()) {
        const Verdict verdict = relation.check(c, *ask, given.forms);
        BOOST_TEST((verdict != Verdict::violated), relation.name << ", " << family << ' ' << k);
        applied[relation.name] += verdict == Verdict::holds;
        if (given.forms.empty()) continue;
        Contact_forms fewer = given.forms;
        fewer.pop_back();
        if (relation.name == "R5 swap") BOOST_TEST((relation.check(c, *ask, fewer) == Verdict::violated));
      }
    }
  for (const Contact_relation& relation : contact_relations()) BOOST_TEST(applied[relation.name] > 0, relation.name);
}

BOOST_AUTO_TEST_SUITE_END()
