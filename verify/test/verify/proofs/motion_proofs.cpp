#include "verify/proofs/all_proofs.h"
#include "verify/test/support/proofs.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_motion_proofs)

using namespace tetracone::verify::proofs;

BOOST_AUTO_TEST_CASE(every_constant_of_motions_is_proved) { check_proved(proofs_of("motion")); }

BOOST_AUTO_TEST_SUITE_END()
