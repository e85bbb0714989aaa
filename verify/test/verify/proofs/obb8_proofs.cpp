#include "verify/proofs/obb8_proofs.h"

#include "verify/proofs/gap_proofs.h"
#include "verify/proofs/obb8_distance_proofs.h"
#include "verify/test/support/proofs.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_obb8_proofs)

using namespace tetracone::verify::proofs;

BOOST_AUTO_TEST_CASE(every_slack_of_boxes_is_proved)
{
  if (skipped_without_gappa()) return;
  check_proved(obb8_proofs());
}

// Here, for they take what is proved of slacks.
BOOST_AUTO_TEST_CASE(every_constant_of_certified_gaps_is_proved)
{
  if (skipped_without_gappa()) return;
  check_proved(gap_proofs());
}

BOOST_AUTO_TEST_CASE(every_constant_of_distances_of_boxes_is_proved)
{
  if (skipped_without_gappa()) return;
  check_proved(obb8_distance_proofs());
}

BOOST_AUTO_TEST_SUITE_END()
