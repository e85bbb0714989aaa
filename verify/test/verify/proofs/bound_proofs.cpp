#include "verify/proofs/bound_proofs.h"

#include "verify/proofs/range_number.h"
#include "verify/test/support/proofs.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <initializer_list>
#include <limits>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_bound_proofs)

using namespace tetracone::verify::proofs;
using namespace tetracone::kernel;
using tetracone::verify::proofs::detail::triple;

namespace {

const auto placed = [](const auto& in) { return sum(placed_terms(in[0], in[1], in[2], in[3], triple(in, 4))); };

/// The squared distance of centres, and that at which balls of these radii touch.
const auto distance = [](const auto& in) { return squared_length(difference(triple(in, 0), triple(in, 3))); };
const auto touching = [](const auto& in) { return touching_distance_2(in[0], in[1]); };

/// Two points along the cross product of two edges, and the slack along it: corners a, b, c of one body, d, e of both.
const auto axis_of = [](const auto& in) {
  return cross(difference(triple(in, 3), triple(in, 0)), difference(triple(in, 6), triple(in, 0)));
};
const auto along_an_axis = [](const auto& in) {
  const auto axis = axis_of(in);
  return dot(axis, triple(in, 9)) - dot(axis, triple(in, 12));
};
const auto slack_along_an_axis = [](const auto& in) { return in[15] * norm_1(axis_of(in)); };

/// A row of cofactors by a unit normal, along which a point lies; inputs p, q, n, point, origin.
const auto beyond_a_half_space = [](const auto& in) {
  const auto component = determinant(triple(in, 0), triple(in, 3), triple(in, 6));
  return dot(std::array{component, component, component}, difference(triple(in, 9), triple(in, 12)));
};
/// Inputs three rows, the normal, the offset and the frame's magnitude.
const auto threshold = [](const auto& in) {
  const auto volume = determinant(triple(in, 0), triple(in, 3), triple(in, 6));
  const auto terms = permanent(triple(in, 0), triple(in, 3), triple(in, 6));
  const auto row = permanent(triple(in, 0), triple(in, 3), triple(in, 9));
  using Half_space = Placed_half_space<double, true>;
  return Half_space::sound_threshold(abs(volume), terms, in[12], row + row + row, in[13],
                                     Half_space::absolute_error(in[0], norm_1(triple(in, 9)), in[12], in[13]));
};

/// Inputs of these magnitudes, one after the other.
std::vector<double> magnitudes(std::initializer_list<std::pair<int, double>> parts)
{
  std::vector<double> all;
  for (const auto& [count, most] : parts) all.insert(all.end(), std::size_t(count), most);
  return all;
}

constexpr double gate = separation_gate;

template <class Expression>
void check(const std::string& name, const Expression& expression, const std::vector<double>& most)
{
  const Rational finite(std::numeric_limits<double>::max());
  const Range_found found = range_of<Double_range>(expression, most);
  BOOST_TEST((found.largest <= finite), name << " overflows");
  BOOST_TEST((found.lost <= Rational(underflow_slack)), name << " underflows");
  std::vector<Range> ranges;
  for (const double x : most) ranges.push_back({-x, x});
  BOOST_TEST((largest_result<Ieee_64>(expression, ranges) <= finite), name << " overflows, says Gappa");
}

}  // namespace

// `Bound_frame` has no finite error where the reach of the body or of its image is beyond the gate. Nothing without a
// finite error is ever separated (the tests of kernel/bound/bounds.h). That is assumed here. A pose's entry may be
// larger where the body is small. Its products with coordinates are not, and where products of entries alone overflow,
// thresholds do before.
BOOST_AUTO_TEST_CASE(nothing_overflows_or_underflows_within_the_separation_gate)
{
  if (skipped_without_gappa()) return;
  check("placed", placed, magnitudes({{3, 1}, {1, gate}, {3, gate}}));
  check("placed, of a large pose", placed, magnitudes({{3, gate}, {1, gate}, {3, 1}}));
  check("distance of balls", distance, magnitudes({{6, gate}}));
  check("touching balls", touching, magnitudes({{2, 8 * gate}}));
  check("along an axis", along_an_axis, magnitudes({{15, gate}}));
  check("slack along an axis", slack_along_an_axis, magnitudes({{16, gate}}));
  check("beyond a half-space", beyond_a_half_space, magnitudes({{6, gate}, {3, 1}, {6, gate}}));
  check("threshold of a half-space", threshold, magnitudes({{9, gate}, {3, 1}, {1, 2}, {1, gate}}));
  // The gate is what keeps it so.
  const Rational finite(std::numeric_limits<double>::max());
  const Range_found beyond = range_of<Double_range>(along_an_axis, std::vector<double>(15, gate * gate));
  BOOST_TEST((beyond.largest > finite));
}

BOOST_AUTO_TEST_SUITE_END()
