#ifndef TETRACONE_VERIFY_TEST_SUPPORT_PROOFS_H
#define TETRACONE_VERIFY_TEST_SUPPORT_PROOFS_H

#include "verify/proofs/gappa_script.h"
#include "verify/proofs/proved_bound.h"

#include <boost/test/unit_test.hpp>

#include <iostream>

namespace tetracone::verify::proofs {

/// True, with a message, when Gappa is not installed; ctest takes the message for a skipped test.
inline bool skipped_without_gappa()
{
  if (gappa_is_there()) return false;
  std::cout << "SKIPPED: no gappa to prove bounds with\n";
  return true;
}

/// Checks that each constant is at least the proved value, and at most the recorded factor above it. That factor must
/// be less than 2 % above the present one.
inline void check_proved(const Proved_bounds& bounds)
{
  BOOST_TEST(!bounds.empty());
  for (const Proved_bound& bound : bounds) {
    const double proved = bound.proved.get_d() / bound.unit, in_code = bound.in_code.get_d() / bound.unit;
    BOOST_TEST_MESSAGE(bound.name << ": " << in_code << " in the code, " << proved << " proved");
    BOOST_TEST((bound.proved <= bound.in_code), bound.file << ": " << bound.name << " is " << in_code
                                                           << " in the code, less than the " << proved << " that "
                                                           << bound.by << " proves to be enough");
    BOOST_TEST(proved > 0);
    BOOST_TEST(in_code <= bound.loosest * proved, bound.name << " is loose: " << in_code << ", proved " << proved);
    // The recorded factor must be within a fiftieth of the present one, else it limits nothing.
    BOOST_TEST(bound.loosest * proved < 1.02 * in_code, bound.name << " may be " << bound.loosest * proved);
  }
}

}  // namespace tetracone::verify::proofs

#endif
