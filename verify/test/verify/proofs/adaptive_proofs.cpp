#include "verify/proofs/adaptive_proofs.h"

#include "verify/test/support/proofs.h"

#include <boost/test/unit_test.hpp>

#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_adaptive_proofs)

using namespace tetracone::verify::proofs;

BOOST_AUTO_TEST_CASE(every_constant_of_the_adaptive_kernel_is_proved)
{
  if (skipped_without_gappa()) return;
  check_proved(adaptive_proofs(), 2.1);
}

BOOST_AUTO_TEST_CASE(nothing_overflows_within_the_magnitude_gate)
{
  if (skipped_without_gappa()) return;
  using namespace tetracone::kernel;
  const Rational most(std::numeric_limits<double>::max());
  const auto volume = [](const auto& in) {
    const auto a = detail::triple(in, 0);
    return determinant(difference(detail::triple(in, 3), a), difference(detail::triple(in, 6), a),
                       difference(detail::triple(in, 9), a));
  };
  const std::vector<Range> twelve(12, {-magnitude_gate, magnitude_gate});
  BOOST_TEST((largest_result<Ieee_64>(volume, twelve) <= most));
  // The gate is what keeps it so.
  BOOST_TEST((largest_result<Ieee_64>(volume, std::vector<Range>(12, {-0x1p400, 0x1p400})) > most));

  const auto bound = [](const auto& in) { return adaptive_bound::volume_bound(in[0], in[1], in[2], in[3]); };
  BOOST_TEST((largest_result<Ieee_64>(bound, std::vector<Range>(4, {0, 2 * magnitude_gate})) <= most));
  const auto placed = [](const auto& in) {
    return sum(placed_terms(in[0], in[1], in[2], in[3], detail::triple(in, 4)));
  };
  BOOST_TEST((largest_result<Ieee_64>(placed, std::vector<Range>(7, {-magnitude_gate, magnitude_gate})) <= most));
}

BOOST_AUTO_TEST_SUITE_END()
