#include "verify/campaign/distance_batch.h"

#include "verify/campaign/campaign.h"
#include "verify/families/distance_families.h"
#include "verify/test/support/database_number.h"
#include "verify/test/support/temporary_file.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

BOOST_AUTO_TEST_SUITE(test_distance_batch)

using namespace tetracone::verify;
using tetracone::kernel::Question;

namespace {

/// What the adaptive tree tells, but for one statement.
class Spoils : public Running_subject {
 public:
  using Spoil = void (*)(Told_distance& told);
  explicit Spoils(Spoil spoil) : spoil_(spoil), right_(distance_subjects()[0].make()) {}

  Outcome operator()(const Object_case& c, Question question) override { return (*right_)(c, question); }
  Told_distance distance(const Object_case& c, Question question) override
  {
    Told_distance told = right_->distance(c, question);
    if (spoil_) spoil_(told);
    return told;
  }
  Outcome within(const Object_case& c, Question question, const std::string& limit) override
  {
    return spoil_ ? right_->within(c, question, limit) : Outcome::yes;
  }

 private:
  Spoil spoil_;
  std::unique_ptr<Running_subject> right_;
};

Object_subject spoiling(const char* name, Spoils::Spoil spoil)
{
  return {name, false, "", {}, [spoil] { return std::make_unique<Spoils>(spoil); }};
}

class Tells_nothing : public Running_subject {
 public:
  Outcome operator()(const Object_case&, Question) override { return Outcome::no; }
};

}  // namespace

BOOST_AUTO_TEST_CASE(every_distance_of_every_family_is_exact_and_each_wrong_statement_is_counted)
{
  Campaign campaign;
  campaign.seed = 7;
  campaign.predicate_cases = campaign.object_cases = 0;
  campaign.sequence_frames = 0;
  campaign.lists_features = false;
  campaign.feature_cases = 1;
  for (const char* name : {"random", "voxels", "sliver", "wild", "nested", "degenerate-face"})
    campaign.families.push_back(find_family(name));
  for (const Family& family : distance_families()) campaign.distance_families.push_back(&family);
  campaign.distance_subjects = distance_subjects();
  campaign.distance_subjects.push_back(spoiling("root", [](Told_distance& told) {
    told.alone = told.nearest.distance = std::nextafter(told.nearest.distance, HUGE_VAL);
  }));
  campaign.distance_subjects.push_back(spoiling("square", [](Told_distance& told) { told.nearest.squared = "7/3"; }));
  campaign.distance_subjects.push_back(
      spoiling("points", [](Told_distance& told) { std::swap(told.nearest.point[0], told.nearest.point[1]); }));
  campaign.distance_subjects.push_back(spoiling("always within", nullptr));
  campaign.distance_subjects.push_back({"nothing", false, "", {}, [] { return std::make_unique<Tells_nothing>(); }});
  campaign.made_by = {"0", "compiler", "flags", "processor"};

  const Temporary_file file("distance_campaign.db", "");
  Database database(file.path(), Database::Mode::write);
  run_campaign(database, campaign, [](std::uint64_t) {});
  const auto sum = [&](const std::string& what, const std::string& subject) {
    return number(database, "SELECT sum(" + what + ") FROM tally WHERE axis = 'rho' AND subject = '" + subject + "'");
  };
  const std::int64_t asked = number(database, "SELECT sum(n) FROM truth"),
                     zero = number(database, "SELECT sum(positives) FROM truth");
  BOOST_TEST(asked > 20);
  BOOST_TEST(zero > 0);
  BOOST_TEST(asked - zero > 12);
  for (const Object_subject& subject : distance_subjects()) {
    BOOST_TEST(sum("n + not_asked", subject.name) == asked, subject.name);
    BOOST_TEST(sum("n", subject.name) > asked / 3, subject.name);
    BOOST_TEST(sum("false_positives + false_negatives + failures", subject.name) == 0, subject.name);
  }
  for (const char* subject : {"root", "square", "points", "always within"}) {
    BOOST_TEST(sum("n", subject) == asked, subject);
    BOOST_TEST(sum("false_positives", subject) == 0, subject);
    BOOST_TEST(sum("false_negatives", subject) >= asked - zero - 2, subject);
  }
  BOOST_TEST(sum("not_asked", "nothing") == asked);
  BOOST_TEST(number(database, "SELECT sum(violated) FROM relation WHERE subject LIKE 'adaptive%'") == 0);
  BOOST_TEST(number(database, "SELECT sum(tried) FROM relation WHERE subject LIKE 'adaptive%'") > asked / 4);
}

BOOST_AUTO_TEST_SUITE_END()
