#include "verify/proofs/all_proofs.h"

#include "verify/test/support/proofs.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_all_proofs)

using namespace tetracone::verify::proofs;

BOOST_AUTO_TEST_CASE(every_constant_is_what_is_proved_to_be_enough)
{
  if (skipped_without_gappa()) return;
  check_proved(all_proofs());
}

BOOST_AUTO_TEST_SUITE_END()
