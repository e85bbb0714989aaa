#include "verify/campaign/distance_batch.h"

#include "verify/campaign/campaign.h"
#include "verify/families/distance_families.h"
#include "verify/test/support/database_number.h"
#include "verify/test/support/empty_campaign.h"
#include "verify/test/support/temporary_file.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_distance_batch)

using namespace tetracone::verify;
using tetracone::kernel::Question;

namespace {

/// The adaptive tree's answers, except for one statement.
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

/// The rows of a campaign of distances alone: a case of each of these families, and as many of those of distances.
class Rows {
 public:
  Rows(const std::vector<const char*>& families, std::size_t distance_family_count,
       std::vector<Object_subject> subjects)
  {
    Campaign campaign = empty_campaign(7);
    campaign.feature_cases = 1;
    for (const char* name : families) campaign.families.push_back(find_family(name));
    for (std::size_t k = 0; k < distance_family_count; ++k)
      campaign.distance_families.push_back(&distance_families()[k]);
    campaign.distance_subjects = std::move(subjects);
    run_campaign(database_, campaign, [](std::uint64_t) {});
  }

  std::int64_t number(const std::string& query) { return tetracone::verify::number(database_, query); }
  std::int64_t sum(const std::string& what, const std::string& subject)
  {
    return tally(database_, what, "subject = '" + subject + "'");
  }
  std::int64_t asked() { return number("SELECT sum(n) FROM truth"); }
  std::int64_t zero() { return number("SELECT sum(positives) FROM truth"); }

 private:
  Temporary_file file_{"distance_campaign.db", ""};
  Database database_{file_.path(), Database::Mode::write};
};

}  // namespace

BOOST_AUTO_TEST_CASE(every_distance_of_every_family_is_exact)
{
  Rows rows({"random", "voxels", "sliver", "wild", "nested", "degenerate-face"}, distance_families().size(),
            distance_subjects());
  const std::int64_t asked = rows.asked(), zero = rows.zero();
  BOOST_TEST(asked > 20);
  BOOST_TEST(zero > 0);
  BOOST_TEST(asked - zero > 12);
  for (const Object_subject& subject : distance_subjects()) {
    BOOST_TEST(rows.sum("n + not_asked", subject.name) == asked, subject.name);
    BOOST_TEST(rows.sum("n", subject.name) > asked / 3, subject.name);
    BOOST_TEST(rows.sum("false_positives + false_negatives + failures", subject.name) == 0, subject.name);
  }
  BOOST_TEST(rows.number("SELECT sum(violated) FROM relation WHERE subject LIKE 'adaptive%'") == 0);
  BOOST_TEST(rows.number("SELECT sum(tried) FROM relation WHERE subject LIKE 'adaptive%'") > asked / 4);
}

BOOST_AUTO_TEST_CASE(each_wrong_statement_is_counted)
{
  Rows rows({"random", "nested", "degenerate-face"}, 4,
            {spoiling("root",
                      [](Told_distance& told) {
                        told.alone = told.nearest.distance = std::nextafter(told.nearest.distance, HUGE_VAL);
                      }),
             spoiling("square", [](Told_distance& told) { told.nearest.squared = "7/3"; }),
             spoiling("points", [](Told_distance& told) { std::swap(told.nearest.point[0], told.nearest.point[1]); }),
             spoiling("always within", nullptr),
             {"nothing", false, "", {}, [] { return std::make_unique<Tells_nothing>(); }}});
  const std::int64_t asked = rows.asked(), zero = rows.zero();
  BOOST_TEST(zero > 0);
  BOOST_TEST(asked - zero > 6);
  for (const char* subject : {"root", "square", "points", "always within"}) {
    BOOST_TEST(rows.sum("n", subject) == asked, subject);
    BOOST_TEST(rows.sum("false_positives", subject) == 0, subject);
    BOOST_TEST(rows.sum("false_negatives", subject) >= asked - zero - 2, subject);
  }
  BOOST_TEST(rows.sum("not_asked", "nothing") == asked);
}

BOOST_AUTO_TEST_SUITE_END()
