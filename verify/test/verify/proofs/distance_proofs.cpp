#include "verify/proofs/all_proofs.h"
#include "verify/test/support/proofs.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_distance_proofs)

using namespace tetracone::verify::proofs;

BOOST_AUTO_TEST_CASE(every_constant_of_distances_of_triangles_and_of_signs_in_cones_is_proved)
{
  if (skipped_without_gappa()) return;
  check_proved(proofs_of("distance"));
}

BOOST_AUTO_TEST_SUITE_END()
