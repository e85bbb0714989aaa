#include "verify/proofs/all_proofs.h"
#include "verify/test/support/proofs.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_frame_proofs)

using namespace tetracone::verify::proofs;

BOOST_AUTO_TEST_CASE(every_constant_of_relative_frames_and_of_their_offsets_is_proved)
{
  if (skipped_without_gappa()) return;
  check_proved(proofs_of("frame"));
}

BOOST_AUTO_TEST_SUITE_END()
