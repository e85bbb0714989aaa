#include "verify/proofs/all_proofs.h"
#include "verify/test/support/proofs.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_margin_proofs)

using namespace tetracone::verify::proofs;

BOOST_AUTO_TEST_CASE(every_margin_of_geometry_and_of_counted_roundings_is_derived)
{
  if (skipped_without_gappa()) return;
  check_proved(proofs_of("margin"));
}

BOOST_AUTO_TEST_SUITE_END()
