#include "verify/proofs/all_proofs.h"
#include "verify/test/support/proofs.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_obb8_ray_proofs)

using namespace tetracone::verify::proofs;

BOOST_AUTO_TEST_CASE(the_slack_of_rays_against_boxes_is_proved)
{
  if (skipped_without_gappa()) return;
  check_proved(proofs_of("obb8_ray"));
}

BOOST_AUTO_TEST_SUITE_END()
