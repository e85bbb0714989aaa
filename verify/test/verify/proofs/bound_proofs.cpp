#include "verify/proofs/bound_proofs.h"

#include "verify/test/support/proofs.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_bound_proofs)

using namespace tetracone::verify::proofs;

BOOST_AUTO_TEST_CASE(every_constant_of_bounding_volumes_and_of_coordinates_in_cones_is_proved)
{
  if (skipped_without_gappa()) return;
  check_proved(bound_proofs(), 120);
}

BOOST_AUTO_TEST_SUITE_END()
