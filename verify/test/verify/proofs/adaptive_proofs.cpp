#include "verify/proofs/adaptive_proofs.h"

#include "verify/proofs/range_number.h"
#include "verify/test/support/proofs.h"

#include <boost/test/unit_test.hpp>

#include <limits>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_adaptive_proofs)

using namespace tetracone::verify::proofs;
using namespace tetracone::kernel;
namespace bound = tetracone::kernel::adaptive_bound;
using tetracone::verify::proofs::detail::triple;

namespace {

const auto volume = [](const auto& in) {
  return determinant(difference(triple(in, 3), triple(in, 0)), difference(triple(in, 6), triple(in, 0)),
                     difference(triple(in, 9), triple(in, 0)));
};
const auto normal = [](const auto& in) {
  return cross_component(in[2] - in[0], in[3] - in[1], in[4] - in[0], in[5] - in[1]);
};
const auto placed = [](const auto& in) { return sum(placed_terms(in[0], in[1], in[2], in[3], triple(in, 4))); };
const auto determinant_of_entries = [](const auto& in) {
  return determinant(triple(in, 3), triple(in, 6), triple(in, 0));
};

// The bounds, of magnitudes and of the errors that points have within the gate.
const auto image_bound = [](const auto& in) { return bound::image_bound(in[0]); };
const auto double_double_image_bound = [](const auto& in) { return bound::double_double_image_bound(in[0]); };
const auto volume_bound = [](const auto& in) { return bound::volume_bound(in[0], in[1], in[2], in[3]); };
const auto normal_bound = [](const auto& in) { return bound::normal_bound(in[0], in[1], in[2]); };
const auto difference_bound = [](const auto& in) {
  return bound::difference_bound(bound::double_double_difference_error(in[0], in[1]));
};
const auto double_double_volume_bound = [](const auto& in) {
  const auto error = [&](int k) { return bound::double_double_difference_error(in[3], in[k]); };
  return bound::double_double_volume_bound(triple(in, 0), std::array{error(0), error(1), error(2)});
};
const auto double_double_normal_bound = [](const auto& in) {
  const auto error = [&](int k) { return bound::double_double_difference_error(in[2], in[k]); };
  return bound::double_double_normal_bound(in[0], in[1], error(0), error(1));
};
const auto determinant_bound = [](const auto& in) {
  return Pose::determinant_bound(permanent(triple(in, 3), triple(in, 6), triple(in, 0)));
};

template <class Expression>
void check_overflow(const std::string& name, const Expression& expression, std::size_t inputs, double most)
{
  const Rational finite(std::numeric_limits<double>::max());
  BOOST_TEST((largest_result<Ieee_64>(expression, std::vector<Range>(inputs, {-most, most})) <= finite), name);
  BOOST_TEST((range_of<Double_range>(expression, std::vector<double>(inputs, most)).largest <= finite), name);
}

/// The underflow of an expression of points within the gate, and of its bound, is within `underflow_slack`.
template <class Range, class Expression, class Bound>
void check_underflow(const std::string& name, const Expression& expression, std::size_t inputs, const Bound& its_bound,
                     std::size_t inputs_of_bound, double most)
{
  const Rational of_it = range_of<Range>(expression, std::vector<double>(inputs, most)).lost,
                 of_bound = range_of<Double_range>(its_bound, std::vector<double>(inputs_of_bound, 2 * most)).lost;
  BOOST_TEST(of_it > 0);
  BOOST_TEST((of_it + of_bound <= Rational(underflow_slack)), name);
}

}  // namespace

// `Adaptive_points` knows no error beyond the gate, of images or of the vertices that fractions place.
// `Pose::determinant_sign` knows no bound there. So the gate is asked for there, and is what is assumed here.
BOOST_AUTO_TEST_CASE(nothing_overflows_within_the_magnitude_gate)
{
  if (skipped_without_gappa()) return;
  check_overflow("placed", placed, 7, magnitude_gate);
  check_overflow("volume", volume, 12, magnitude_gate);
  check_overflow("normal", normal, 6, magnitude_gate);
  check_overflow("determinant", determinant_of_entries, 9, magnitude_gate);
  check_overflow("image_bound", image_bound, 1, magnitude_gate);
  check_overflow("double_double_image_bound", double_double_image_bound, 1, magnitude_gate);
  check_overflow("volume_bound", volume_bound, 4, 2 * magnitude_gate);
  check_overflow("normal_bound", normal_bound, 3, 2 * magnitude_gate);
  check_overflow("difference_bound", difference_bound, 2, 2 * magnitude_gate);
  check_overflow("double_double_volume_bound", double_double_volume_bound, 4, 2 * magnitude_gate);
  check_overflow("double_double_normal_bound", double_double_normal_bound, 3, 2 * magnitude_gate);
  check_overflow("determinant_bound", determinant_bound, 9, magnitude_gate);
  // The gate is what keeps it so.
  const Rational finite(std::numeric_limits<double>::max());
  BOOST_TEST((largest_result<Ieee_64>(volume, std::vector<Range>(12, {-0x1p400, 0x1p400})) > finite));
  BOOST_TEST((range_of<Double_range>(determinant_bound, std::vector<double>(9, 0x1p400)).largest > finite));
}

// Double-double has twice the digits of the same expressions: the high parts, which alone are large, are these numbers.
BOOST_AUTO_TEST_CASE(what_underflows_within_the_magnitude_gate_is_within_the_slack)
{
  check_underflow<Double_range>("placed", placed, 7, image_bound, 1, magnitude_gate);
  check_underflow<Double_double_range>("placed in double-double", placed, 7, double_double_image_bound, 1,
                                       magnitude_gate);
  check_underflow<Double_range>("volume", volume, 12, volume_bound, 4, magnitude_gate);
  check_underflow<Double_double_range>("volume in double-double", volume, 12, double_double_volume_bound, 4,
                                       magnitude_gate);
  check_underflow<Double_range>("normal", normal, 6, normal_bound, 3, magnitude_gate);
  check_underflow<Double_double_range>("normal in double-double", normal, 6, double_double_normal_bound, 3,
                                       magnitude_gate);
  check_underflow<Double_range>("determinant", determinant_of_entries, 9, determinant_bound, 9, magnitude_gate);
  // An entry that is rounded to a denormal, times a vertex, and of a determinant times two others.
  BOOST_TEST(0x1p-1074 * magnitude_gate * magnitude_gate * 18 < underflow_slack);
  // Far beyond the gate it is not.
  const Rational wide = range_of<Double_range>(volume, std::vector<double>(12, 0x1p300)).lost;
  BOOST_TEST((wide > Rational(underflow_slack)));
}

BOOST_AUTO_TEST_SUITE_END()
