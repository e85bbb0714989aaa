#include "verify/campaign/distance_campaign.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_distance_campaign)

using namespace tetracone::verify;

BOOST_AUTO_TEST_CASE(every_distance_of_every_family_is_exact)
{
  const Distance_tally tally = judge_distances(7, 0, 2, 24);
  BOOST_TEST(tally.cases > 40);
  BOOST_TEST(tally.answers > 20 * tally.cases);
  for (const std::string& wrong : tally.wrong) BOOST_ERROR(wrong);
}

BOOST_AUTO_TEST_SUITE_END()
