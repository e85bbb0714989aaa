#include "verify/proofs/all_proofs.h"
#include "verify/test/support/proofs.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_separation_proofs)

using namespace tetracone::verify::proofs;

BOOST_AUTO_TEST_CASE(every_slack_of_separating_directions_and_of_containment_is_proved)
{
  if (skipped_without_gappa()) return;
  check_proved(proofs_of("separation"));
}

BOOST_AUTO_TEST_SUITE_END()
