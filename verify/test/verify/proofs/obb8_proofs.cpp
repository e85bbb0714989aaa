#include "verify/proofs/obb8_proofs.h"

#include "verify/test/support/proofs.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_obb8_proofs)

using namespace tetracone::verify::proofs;

BOOST_AUTO_TEST_CASE(every_slack_of_boxes_is_proved)
{
  if (skipped_without_gappa()) return;
  check_proved(obb8_proofs());
}

BOOST_AUTO_TEST_SUITE_END()
