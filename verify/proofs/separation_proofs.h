#ifndef TETRACONE_VERIFY_PROOFS_SEPARATION_PROOFS_H
#define TETRACONE_VERIFY_PROOFS_SEPARATION_PROOFS_H

#include "tetracone/kernel/bound/oriented_box.h"
#include "tetracone/tetratree/fast/bvh8_elements.h"
#include "tetracone/tetratree/fast/separating_direction.h"
#include "tetracone/tetratree/fast/support_table.h"
#include "tetracone/tetratree/query/bvh8_containment.h"
#include "verify/proofs/adaptive_proofs.h"
#include "verify/proofs/proof.h"

/// The constants of the search for a separating direction, of its support tables and of rays of containment, and two of
/// kernel/bound/obb8.h.
namespace tetracone::verify::proofs {

/// Returns their proofs. Throws std::runtime_error when Gappa does not prove one.
inline Proved_bounds separation_proofs()
{
  using tetratree::Separating_direction, tetratree::Support_table;
  using Containment = tetratree::Bvh8_containment<>;
  using detail::triple;
  const double u = kernel::unit_roundoff<float>, of_double = kernel::unit_roundoff<double>;
  const Rational roundoff(u), once = 1 + 2 * roundoff, defect(kernel::axis_defect);
  const std::string direction = "tetratree/fast/separating_direction.h", table = "tetratree/fast/support_table.h",
                    containment = "tetratree/query/bvh8_containment.h", box = "kernel/bound/obb8.h";
  Proved_bounds bounds;
  const auto sum_of_lanes = [](const auto& v) { return (v[0] + v[1]) + (v[2] + v[3]); };

  // A direction turned back, of rows rounded to float; fractions' own rounding, in double, is far less.
  const auto turned = [](const auto& in) {
    return Separating_direction::turned_back_by(in[0], in[1], in[2], entry(in[3]), entry(in[4]), entry(in[5]));
  };
  const std::vector<Slice> terms = slices_of_dot();
  bounds.push_back({"rounding of rows", direction, Rational(Separating_direction::rounding * u),
                    largest(slice_errors<Relative_32>(turned, terms)) * once + 2 * Rational(of_double), u, 1.51,
                    "gappa"});

  // The gap's part from D, which is rounded to float, and the part from the reach of the support tables.
  const auto gap = [&](const auto& in) {
    const auto zero = std::decay_t<decltype(in[0])>(0);
    const auto lane = [&](int k) { return Separating_direction::lanes_of_gap(in[k], entry(in[3 + k]), zero); };
    return sum_of_lanes(std::array{lane(0), lane(1), lane(2), zero});
  };
  bounds.push_back({"rounding of D in float", direction, Rational(Separating_direction::rounding * u),
                    largest(slice_errors<Relative_32>(gap, terms)) * once, u, 1.21, "gappa"});
  const auto offset = [](const auto& in) {
    const auto part = [&in](int k) {
      return Separating_direction::difference_in_parts(entry(in[k]) * in[8 + k], entry(in[2 + k]) * in[8 + k],
                                                       entry(in[4 + k]) * in[8 + k], entry(in[6 + k]) * in[8 + k]);
    };
    return part(0) + part(1);
  };
  std::vector<Slice> terms_of_offset;
  for (int k = 0; k < 8; ++k) terms_of_offset.push_back(slice_of(10, {k, 8 + k % 2}));
  bounds.push_back({"rounding of D in double", direction, Rational(Separating_direction::rounding * of_double),
                    largest(slice_errors<Relative_64>(offset, terms_of_offset)) * once, of_double, 1.21, "gappa"});

  // The position of a direction in the lattice; 2 of 3 coordinates move the third as well.
  const Rounding_count count, norm = sum_of_lanes(std::array{count, count, count, count});
  const Rational place = 2 * (1 / Support_table::scaled(count, norm).least(roundoff) - 1);
  // Weights: of corner 0, in IEEE's own numbers; of its opposite the same, and then two more are sums with it.
  const auto rest = [](const auto& in) { return Support_table::weight_of_first(in[0], in[1]); };
  const auto second = [](const auto& in) { return in[0] + Support_table::weight_of_first(in[0], in[1]); };
  const std::vector<Range> parts = {{0, 1}, {0, 1}};
  const Rational corner(Support_table::row, Support_table::n);
  const Rational weights = (error_within<Ieee_32>(rest, parts) + 2 * error_within<Ieee_32>(second, parts)) * corner;
  const auto reach = [&](const auto& in) {
    const auto zero = std::decay_t<decltype(in[0])>(0);
    const auto lane = [&](int k) {
      return Separating_direction::lanes_of_gap(zero, zero,
                                                Support_table::weighted(in[k], in[4 + k], entry(entry(in[8]))));
    };
    return sum_of_lanes(std::array{lane(0), lane(1), lane(2), lane(3)});
  };
  std::vector<Slice> terms_of_reach;
  for (int k = 0; k < 4; ++k) terms_of_reach.push_back(slice_of(9, {k, 4 + k, 8}));
  // Reaches of both tables are added before.
  const Rational sums = (largest(slice_errors<Relative_32>(reach, terms_of_reach)) + roundoff) * corner * once;
  bounds.push_back({"Support_table::slack", table, Rational(Support_table::slack), (place + weights + sums) * once, u,
                    1.78, "gappa"});
  const auto product = [](const auto& in) { return kernel::dot(triple(in, 0), triple(in, 3)); };
  bounds.push_back(
      {"Support_table::reach_rounding", table, Rational(Support_table::reach_rounding),
       largest(slice_errors<Relative_64>(product, terms)) + Rational(tetratree::Bvh8_elements::local_error), of_double,
       1.21, "gappa"});

  // s = (A^T A)^-1 A^T y, and row sums of A^T A - I are below 3 d.
  bounds.push_back({"axis_defect_factor", box, Rational(kernel::axis_defect_factor),
                    3 / (1 - 3 * defect) + Rational(0x1p-20), 1, 1.34, "rationals"});
  bounds.push_back(
      {"axis_norm_1", box, Rational(kernel::axis_norm_1), root_3() * (1 + 4 * defect), 1, 1.16, "rationals"});
  // A ray's centre once, its direction along half of it, its extent, half of it; and the axes in double.
  bounds.push_back({"Bvh8_containment::ray_rounding", containment, Rational(Containment::ray_rounding),
                    2 * roundoff * once, u, 1.51, "rationals"});
  return bounds;
}

}  // namespace tetracone::verify::proofs

#endif
