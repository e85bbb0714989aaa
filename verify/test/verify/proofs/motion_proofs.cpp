#include "verify/proofs/motion_proofs.h"

#include "verify/test/support/proofs.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_motion_proofs)

using namespace tetracone::verify::proofs;

// By counts of roundings, which ask no Gappa.
BOOST_AUTO_TEST_CASE(every_constant_of_motions_is_proved) { check_proved(motion_proofs()); }

BOOST_AUTO_TEST_SUITE_END()
