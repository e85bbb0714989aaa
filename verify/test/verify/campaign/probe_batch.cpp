#include "verify/campaign/probe_batch.h"

#include "verify/campaign/campaign.h"
#include "verify/test/support/database_number.h"
#include "verify/test/support/empty_campaign.h"
#include "verify/test/support/temporary_file.h"

#include <boost/test/unit_test.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

BOOST_AUTO_TEST_SUITE(test_probe_batch)

using namespace tetracone::verify;

namespace {

class Always_outside : public Running_probe {
 public:
  std::optional<int> where(const Probe_case&) override { return -1; }
  std::optional<Told_hits> hits(const Probe_case&) override { return Told_hits{}; }
};
class Fails_at_all : public Running_probe {};

Probe_subject misses{"misses", false, [] { return std::make_unique<Always_outside>(); }};
Probe_subject fails_at_all{"fails", false, [] { return std::make_unique<Fails_at_all>(); }};

Campaign of_probes()
{
  Campaign campaign = empty_campaign(3);
  campaign.probe_cases = 12;
  for (const Probe_family& family : point_families()) campaign.point_families.push_back(&family);
  for (const Probe_family& family : ray_families()) campaign.ray_families.push_back(&family);
  campaign.point_subjects = {point_subjects()[0], misses, fails_at_all};
  campaign.ray_subjects = {ray_subjects()[0], misses, fails_at_all};
  return campaign;
}

}  // namespace

BOOST_AUTO_TEST_CASE(points_and_rays_are_judged_in_a_campaign)
{
  const Temporary_file file("probe_campaign.db", "");
  Database database(file.path(), Database::Mode::write);
  std::uint64_t done = 0;
  run_campaign(database, of_probes(), [&](std::uint64_t cases) { done += cases; });
  BOOST_TEST(done == case_count(of_probes()));
  BOOST_TEST(done == 12 * (point_families().size() + ray_families().size()));
  const auto sum = [&](const std::string& what, const std::string& where) { return tally(database, what, where); };
  const auto points = std::int64_t(12 * point_families().size()), rays = std::int64_t(12 * ray_families().size());
  BOOST_TEST(sum("n", "subject = 'adaptive locator'") == points);
  BOOST_TEST(sum("n", "subject = 'adaptive tree'") == 3 * rays);
  BOOST_TEST(sum("false_positives + false_negatives + failures", "subject LIKE 'adaptive %'") == 0);
  BOOST_TEST(sum("failures", "subject = 'fails'") == points + 3 * rays);
  const std::int64_t inside = number(database, "SELECT sum(positives) FROM truth WHERE level = 'points'"),
                     met = number(database, "SELECT sum(positives) FROM truth WHERE question = 'hits'");
  BOOST_TEST(inside > points / 20);
  BOOST_TEST(met > rays / 3);
  BOOST_TEST(sum("false_negatives", "subject = 'misses' AND level = 'rays'") == 3 * met);
  BOOST_TEST(sum("false_negatives", "subject = 'misses' AND level = 'points'") > inside);  // what is on the surface too
  BOOST_TEST(sum("false_positives", "subject = 'misses'") == 0);
  BOOST_TEST(number(database, "SELECT sum(violated) FROM relation WHERE subject LIKE 'adaptive %'") == 0);
  BOOST_TEST(number(database, "SELECT sum(tried) FROM relation WHERE subject LIKE 'adaptive %'") > done / 6);
  BOOST_TEST(number(database, "SELECT count(*) FROM wrong WHERE subject = 'fails' AND answer IS NULL") ==
             points + 3 * rays);

  // Again with the same words: nothing is asked twice.
  run_campaign(database, of_probes(), [](std::uint64_t) {});
  BOOST_TEST(sum("n", "subject = 'adaptive locator'") == points);
  Campaign more = of_probes();
  more.probe_cases = 20;
  run_campaign(database, more, [](std::uint64_t) {});
  BOOST_TEST(sum("n", "subject = 'adaptive locator'") == points / 12 * 20);
}

BOOST_AUTO_TEST_SUITE_END()
