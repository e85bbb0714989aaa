#include "verify/campaign/motion_batch.h"

#include "verify/campaign/campaign.h"
#include "verify/test/support/database_number.h"
#include "verify/test/support/empty_campaign.h"
#include "verify/test/support/temporary_file.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>

BOOST_AUTO_TEST_SUITE(test_motion_batch)

using namespace tetracone::verify;
using tetracone::kernel::Question;

namespace {

/// The package's answers, except for one error.
class Spoils_contact : public Running_motion {
 public:
  using Spoil = void (*)(Told_contact& told);
  explicit Spoils_contact(Spoil spoil) : spoil_(spoil), right_(moving_bodies_subjects().front().make()) {}

  Told_contact first_contact(const Moving_bodies& bodies, Question question) override
  {
    Told_contact told = right_->first_contact(bodies, question);
    spoil_(told);
    return told;
  }

 private:
  Spoil spoil_;
  std::unique_ptr<Running_motion> right_;
};

Moving_bodies_subject spoiling(const char* name, Spoils_contact::Spoil spoil, bool is_exact = false)
{
  return {name, is_exact, "", [spoil] { return std::make_unique<Spoils_contact>(spoil); }};
}

Campaign of_motions()
{
  Campaign campaign = empty_campaign(3);
  campaign.feature_cases = 1;
  for (const Moving_body_family& family : moving_body_families()) campaign.motion_families.push_back(&family);
  const auto all = moving_bodies_subjects();
  campaign.motion_subjects = {
      all[0],
      all[1],
      spoiling("one of the doubles", [](Told_contact& told) { told.time.hi = told.time.lo; }),
      spoiling(
          "one, and promises both", [](Told_contact& told) { told.time.lo = told.time.hi; }, true),
      spoiling("late",
               [](Told_contact& told) { told.time.lo = told.time.hi = std::nextafter(told.time.hi, HUGE_VAL); }),
      spoiling("misses", [](Told_contact& told) { told = {Outcome::no}; }),
      spoiling("invents",
               [](Told_contact& told) {
                 told = {Outcome::yes, {0, 0}};
               }),
      spoiling("declines", [](Told_contact& told) { told = {Outcome::not_asked}; }),
      spoiling("fails", [](Told_contact& told) { told = {Outcome::failed}; })};
  return campaign;
}

}  // namespace

BOOST_AUTO_TEST_CASE(first_contacts_of_every_family_are_judged_in_a_campaign)
{
  const Temporary_file file("motion_campaign.db", "");
  Database database(file.path(), Database::Mode::write);
  std::uint64_t done = 0;
  run_campaign(database, of_motions(), [&](std::uint64_t cases) { done += cases; });
  BOOST_TEST(done == case_count(of_motions()));
  BOOST_TEST(done == moving_body_families().size());
  const auto sum = [&](const std::string& what, const std::string& subject, bool of_times) {
    return tally(database, what,
                 "subject = '" + subject + "' AND question " + (of_times ? "" : "NOT ") + "LIKE '% time'");
  };
  const std::string wrong = "false_positives + false_negatives + failures";
  const auto asked = std::int64_t(2 * done);
  const std::int64_t meet = number(database, "SELECT sum(positives) FROM truth WHERE level = 'motions'");
  BOOST_TEST(number(database, "SELECT sum(n) FROM truth") == asked);
  BOOST_TEST(number(database, "SELECT sum(by_construction) FROM truth") > asked / 4);
  BOOST_TEST(meet > asked / 4);
  BOOST_TEST(meet < asked);
  BOOST_TEST(sum("n", "adaptive tree", false) == asked);
  BOOST_TEST(sum("n", "adaptive tree", true) == meet);
  BOOST_TEST(sum(wrong, "adaptive tree", false) + sum(wrong, "adaptive tree", true) == 0);
  BOOST_TEST(sum(wrong, "one of the doubles", true) == 0);
  BOOST_TEST(sum("false_positives", "one, and promises both", true) > 0);
  BOOST_TEST(sum("false_positives", "static 10", false) == 0);
  BOOST_TEST(sum("false_positives", "static 10", true) > 0);
  BOOST_TEST(sum("false_negatives", "static 10", true) == 0);
  BOOST_TEST(sum(wrong, "late", false) == 0);
  BOOST_TEST(sum("false_positives", "late", true) == meet);
  BOOST_TEST(sum("false_negatives", "misses", false) == meet);
  BOOST_TEST(sum("n", "misses", true) == 0);
  BOOST_TEST(sum("false_positives", "invents", false) == asked - meet);
  BOOST_TEST(sum("false_negatives", "invents", true) > 0);
  BOOST_TEST(sum("not_asked", "declines", false) == asked);
  BOOST_TEST(sum("failures", "fails", false) == asked);
  BOOST_TEST(number(database, "SELECT count(*) FROM wrong WHERE subject = 'fails' AND answer IS NULL") == asked);
  BOOST_TEST(number(database, "SELECT sum(violated) FROM relation WHERE subject = 'adaptive tree'") == 0);
  BOOST_TEST(number(database, "SELECT sum(tried) FROM relation WHERE subject = 'adaptive tree'") >
             std::int64_t(done / 2));
  BOOST_TEST(number(database, "SELECT sum(tried) FROM relation WHERE subject = 'declines'") == 0);

  // Again with the same words: nothing is asked twice.
  run_campaign(database, of_motions(), [](std::uint64_t) {});
  BOOST_TEST(sum("n", "adaptive tree", false) == asked);
}

BOOST_AUTO_TEST_SUITE_END()
