#include "verify/proofs/all_proofs.h"
#include "verify/test/support/proofs.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_obb8_proofs)

using namespace tetracone::verify::proofs;

BOOST_AUTO_TEST_CASE(every_slack_of_boxes_is_proved)
{
  if (skipped_without_gappa()) return;
  check_proved(proofs_of("obb8"));
}

// Here, for they take what is proved of slacks.
BOOST_AUTO_TEST_CASE(every_constant_of_certified_gaps_is_proved)
{
  if (skipped_without_gappa()) return;
  check_proved(proofs_of("gap"));
}

BOOST_AUTO_TEST_CASE(every_constant_of_distances_of_boxes_is_proved)
{
  if (skipped_without_gappa()) return;
  check_proved(proofs_of("obb8_distance"));
}

BOOST_AUTO_TEST_SUITE_END()
