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
  const auto subject = moving_bodies_subjects().front().make();
  for (const Moving_body_relation& relation : moving_body_relations()) {
    int held = 0;
    for (const Moving_body_family& family : moving_body_families())
      for (std::uint64_t k = 0; k < 3; ++k) {
        const Verdict verdict = relation.check(moving_bodies_case(family, 5, k), *subject, random);
        BOOST_TEST((verdict != Verdict::violated),
                   std::string(relation.name) + ", " + std::string(family.name) + " " + std::to_string(k));
        held += verdict == Verdict::holds;
      }
    BOOST_TEST(held > 30, std::string(relation.name));
  }
}

namespace {

/// Tells the same of every motion; nothing where it does not tell.
class Tells : public Running_motion {
 public:
  explicit Tells(Told_contact told) : told_(told) {}
  Told_contact first_contact(const Moving_bodies&, tetracone::kernel::Question) override { return told_; }

 private:
  Told_contact told_;
};

}  // namespace

BOOST_AUTO_TEST_CASE(wrong_answers_violate_relations_and_what_is_not_told_none)
{
  Tells late({Outcome::yes, {0.75, 0.75}}), declines({Outcome::not_asked}), fails({Outcome::failed});
  int violated = 0;
  for (const Moving_body_relation& relation : moving_body_relations())
    for (const Moving_body_family& family : moving_body_families()) {
      Random random(3);
      const Moving_bodies c = moving_bodies_case(family, 5, 0);
      violated += relation.check(c, late, random) == Verdict::violated;
      for (Tells* silent : {&declines, &fails})
        BOOST_TEST((relation.check(c, *silent, random) == Verdict::not_applicable), std::string(relation.name));
    }
  BOOST_TEST(violated > int(moving_body_families().size()));
}

BOOST_AUTO_TEST_SUITE_END()
