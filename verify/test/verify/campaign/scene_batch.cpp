#include "verify/campaign/scene_batch.h"

#include "verify/campaign/campaign.h"
#include "verify/families/scene_families.h"
#include "verify/test/support/database_number.h"
#include "verify/test/support/empty_campaign.h"
#include "verify/test/support/temporary_file.h"

#include <boost/test/unit_test.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

BOOST_AUTO_TEST_SUITE(test_scene_batch)

using namespace tetracone::verify;

namespace {

/// The answers of the library's scene, except for one error.
class Spoils : public Running_scene {
 public:
  using Spoil = void (*)(Frames_of_pairs& told);
  explicit Spoils(Spoil spoil) : spoil_(spoil), right_(scene_subjects()[0].make()) {}

  std::optional<Frames_of_pairs> play(const Scene_case& c) override
  {
    auto told = right_->play(c);
    if (told) spoil_(*told);
    return told;
  }

 private:
  Spoil spoil_;
  std::unique_ptr<Running_scene> right_;
};

Scene_subject spoiling(const char* name, Spoils::Spoil spoil)
{
  return {name, false, [spoil] { return std::make_unique<Spoils>(spoil); }};
}

class Fails : public Running_scene {
 public:
  std::optional<Frames_of_pairs> play(const Scene_case&) override { return std::nullopt; }
};

}  // namespace

BOOST_AUTO_TEST_CASE(every_frame_of_every_family_is_exact_and_each_wrong_list_is_counted)
{
  Campaign campaign = empty_campaign(7);
  campaign.feature_cases = 1;
  for (const Scene_family& family : scene_families()) campaign.scene_families.push_back(&family);
  campaign.scene_subjects = scene_subjects();
  campaign.scene_subjects.push_back(spoiling("as the frame before", [](Frames_of_pairs& told) {
    for (std::size_t f = told.size(); f-- > 1;) told[f] = told[f - 1];
  }));
  campaign.scene_subjects.push_back(spoiling("one too many", [](Frames_of_pairs& told) {
    for (auto& pairs : told) pairs.push_back({98, 99});
  }));
  campaign.scene_subjects.push_back(spoiling("one too few", [](Frames_of_pairs& told) {
    for (auto& pairs : told)
      if (!pairs.empty()) pairs.pop_back();
  }));
  campaign.scene_subjects.push_back({"nothing", false, [] { return std::make_unique<Fails>(); }});

  const Temporary_file file("scene_campaign.db", "");
  Database database(file.path(), Database::Mode::write);
  run_campaign(database, campaign, [](std::uint64_t) {});
  const auto sum = [&](const std::string& what, const std::string& subject) {
    return tally(database, what, "subject = '" + subject + "'");
  };
  const std::int64_t frames = number(database, "SELECT sum(n) FROM truth"),
                     meet = number(database, "SELECT sum(positives) FROM truth");
  BOOST_TEST(frames == std::int64_t(8 * scene_families().size()));
  BOOST_TEST(meet > frames / 2);
  for (const Scene_subject& subject : scene_subjects()) {
    BOOST_TEST(sum("n", subject.name) == frames, subject.name);
    if (subject.is_exact)
      BOOST_TEST(sum("false_positives + false_negatives + failures", subject.name) == 0, subject.name);
  }
  BOOST_TEST(sum("false_positives + false_negatives", "as the frame before") > frames / 4);
  BOOST_TEST(sum("false_positives", "one too many") == frames);
  BOOST_TEST(sum("false_negatives", "one too few") == meet);
  BOOST_TEST(sum("failures", "nothing") == frames);
  BOOST_TEST(number(database, "SELECT count(*) FROM wrong WHERE subject = 'one too many'") ==
             std::int64_t(scene_families().size()));
  BOOST_TEST(number(database, "SELECT sum(violated) FROM relation WHERE subject LIKE 'adaptive%'") == 0);
  BOOST_TEST(number(database, "SELECT sum(tried) FROM relation WHERE subject LIKE 'adaptive%'") > frames);
  BOOST_TEST(number(database, "SELECT sum(violated) FROM relation WHERE subject = 'as the frame before'") > 0);
}

BOOST_AUTO_TEST_SUITE_END()
