#include "verify/proofs/adaptive_proofs.h"

#include "verify/test/support/proofs.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_adaptive_proofs)

using namespace tetracone::verify::proofs;

BOOST_AUTO_TEST_CASE(every_constant_of_the_adaptive_kernel_is_proved)
{
  if (skipped_without_gappa()) return;
  check_proved(adaptive_proofs(), 2.1);
}

BOOST_AUTO_TEST_SUITE_END()
