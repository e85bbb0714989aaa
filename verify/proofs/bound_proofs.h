#ifndef TETRACONE_VERIFY_PROOFS_BOUND_PROOFS_H
#define TETRACONE_VERIFY_PROOFS_BOUND_PROOFS_H

#include "tetracone/kernel/bound/bounds.h"
#include "tetracone/kernel/bound/cone_coordinates.h"
#include "verify/proofs/adaptive_proofs.h"
#include "verify/proofs/proof.h"

/// The constants of kernel/bound/bounds.h and cone_coordinates.h, of sound tests in double.
namespace tetracone::verify::proofs {

/// Returns their proofs. Throws std::runtime_error when Gappa does not prove one.
inline Proved_bounds bound_proofs()
{
  using Count = Rounding_count;
  using Frame = kernel::Bound_frame<double, true>;
  using Half_space = kernel::Placed_half_space<double, true>;
  using detail::triple;
  const double u = kernel::unit_roundoff<double>;
  const Rational once = 1 / (1 - Rational(u));
  const auto lost = [&](const Count& count) { return Rational(1 / count.least(Rational(u))); };
  const std::vector<Count> counts(9);
  const Count count;
  Proved_bounds bounds;
  const auto add = [&](const std::string& name, double in_code, const Rational& proved, double loosest,
                       const std::string& by = "gappa", const std::string& file = "kernel/bound/bounds.h") {
    bounds.push_back({name, file, Rational(in_code), proved, u, loosest, by});
  };

  // Points of the cube that were computed in the model's frame have an error of two roundings themselves.
  const auto placed = [](const auto& in) {
    auto computed = in;
    for (int k = 4; k < 7; ++k) computed[k] = entry(entry(computed[k]));
    return kernel::sum(detail::placed_terms(computed));
  };
  const Rational image = largest(slice_errors<Relative_64>(placed, detail::slices_of_placed()));
  const Count reach = Frame::reach_of_row(entry(count), entry(count), entry(count), entry(count), count) * count;
  const Rational magnitude = (1 + image) * lost(reach) - 1;
  const Rational error = image * lost(reach * count) / (1 + Rational(Frame::magnitude_rounding));
  add("Bound_frame::error_rounding", Frame::error_rounding, error, 1.15);
  add("Bound_frame::magnitude_rounding", Frame::magnitude_rounding, magnitude, 1.24);

  // A row of M^T M has three entries. The error of each is a fraction of the longest column's square, which is at most
  // the largest row sum. The two sums of a row and the slack's sum are rounded too. The root halves these relative
  // errors. Its own rounding and those of a ball's radius count in full.
  const auto of_columns = [](const auto& in) {
    auto entries = in;
    for (auto& x : entries) x = entry(x);
    return kernel::dot(triple(entries, 0), triple(entries, 3));
  };
  const Rational column = largest(slice_errors<Relative_64>(of_columns, slices_of_dot()));
  const Rational squares = once * once * once / (1 - 3 * column);
  const Rational roots = once * once * once * once;  // root, its factor, the radius' product and sum
  add("Bound_frame::stretch_rounding", Frame::stretch_rounding, Rational(squares * roots * roots - 1) / 2, 2.47);

  // Squares of distances and radii: the roundings on the longest path.
  const std::array<Count, 3> point;
  const Count distance = kernel::squared_length(kernel::difference(point, point));
  add("ball_distance_rounding", kernel::ball_distance_rounding,
      power(1 + Rational(u), distance.count()) * lost(kernel::touching_distance_2(count, count)) - 1, 1.21,
      "rationals");
  const Rational radius = lost(distance + count) * once * once * once * once;
  add("ball_radius_rounding", kernel::ball_radius_rounding, Rational(radius - 1) / 2, 1.21, "rationals");

  // Two dot products of points up to the magnitude, and their difference. The slack in the frames' errors covers the
  // second order.
  const auto interval = [](const auto& in) {
    return kernel::dot(triple(in, 0), triple(in, 3)) - kernel::dot(triple(in, 0), triple(in, 6));
  };
  const std::vector<Slice> terms_of_interval = slices_of_dot(9, {3, 6});
  const Count allowance_of_interval = (count + count + count * count) * kernel::norm_1(point) + count;
  const Rational projection =
      2 * largest(slice_errors<Relative_64>(interval, terms_of_interval)) * lost(allowance_of_interval);
  add("projection_rounding and error_rounding of two frames",
      kernel::projection_rounding<double> + 2 * Frame::error_rounding,
      projection + 2 * Rational(error * lost(allowance_of_interval)), 1.1);

  // Errors relative to permanents, for entries that may be fractions. The normal's error is for points that are 2
  // magnitudes apart, plus the roundings of a point's own projection beyond the first order.
  const auto determinant = [](const auto& in) {
    return kernel::determinant(triple(in, 0), triple(in, 3), triple(in, 6));
  };
  const auto with_entries = [&](int n) {
    return [determinant, n](const auto& in) {
      auto entries = in;
      for (int k = 0; k < n; ++k) entries[k] = entry(entries[k]);
      return determinant(entries);
    };
  };
  Count permanent = kernel::permanent(std::array{entry(count), entry(count), entry(count)},
                                      std::array{entry(count), entry(count), entry(count)},
                                      std::array{entry(count), entry(count), entry(count)});
  const Count threshold =
      Half_space::sound_threshold(count, permanent, count, permanent + count + count, reach * count, count);
  add("Placed_half_space::determinant_rounding", Half_space::determinant_rounding,
      largest(slice_errors<Relative_64>(with_entries(9), slices_of_determinant())) * lost(threshold), 2.01);
  const auto beyond = [](const auto& in) {
    return kernel::dot(triple(in, 0), kernel::difference(triple(in, 3), triple(in, 6)));
  };
  const Rational asked =
      2 * largest(slice_errors<Relative_64>(beyond, terms_of_interval)) * lost(allowance_of_interval);
  add("Placed_half_space::normal_rounding", Half_space::normal_rounding,
      2 * largest(slice_errors<Relative_64>(with_entries(6), slices_of_determinant())) * lost(threshold) +
          Rational(asked - Rational(kernel::projection_rounding<double>)),
      2.29);

  // Absolute errors relative to one product's or entry's underflow, for entries, normals, coordinates and offsets of
  // any size. Parts below `underflow_slack` are left out.
  using Absolute = Range_number<Double_range>;
  Rational growth = 0;
  for (const double m : {0x1p-600, 0x1p-60, 1.0, 0x1p60, 0x1p500})
    for (const double n : {0x1p-300, 1.0, 0x1p500})
      for (const double coordinate : {0x1p-300, 1.0, 0x1p250})
        for (const double offset : {0x1p-300, 1.0, 0x1p700}) {
          const Absolute zero(0), entry_of(entry(Absolute(m)));
          const std::array row = {entry_of, entry_of, entry_of}, along = {Absolute(n), zero, zero},
                           from_origin = {Absolute(2 * coordinate), Absolute(2 * coordinate), Absolute(2 * coordinate)};
          const Absolute component = kernel::determinant(row, row, along);
          const Rational of_point = kernel::dot(std::array{component, component, component}, from_origin).lost(),
                         of_volume = (kernel::determinant(row, row, row) * Absolute(offset)).lost();
          const Rational left = of_point + of_volume - Rational(kernel::underflow_slack), larger = 1 + Rational(m);
          growth = std::max(
              growth,
              Rational(left / (larger * ((1 + Rational(n)) * Rational(coordinate) + larger * Rational(offset)))));
        }
  bounds.push_back({"Placed_half_space::entry_underflow, over 2^-1075", "kernel/bound/bounds.h",
                    Rational(Half_space::entry_underflow) / Double_range::lost_by_product(),
                    growth / Double_range::lost_by_product(), 1, 1.34, "rationals"});

  // A coordinate along a ray, from a rounded difference, and its term in the form that is 1 on a plane.
  using Cone = kernel::Cone_coordinates<double, true>;
  const auto form = [](const auto& in) {
    const auto zero = std::decay_t<decltype(in[0])>(0);
    const auto p = kernel::difference(triple(in, 0), std::array{zero, zero, zero});
    const auto c = Cone::coordinate(p, triple(in, 3), in[6]);
    return Cone::form(std::array{c, zero, zero}, std::array{in[6], in[6], in[6]});
  };
  const Count absolute = Cone::coordinate(std::array{count * count, count, count}, point, count) * count * count;
  const std::string cone = "kernel/bound/cone_coordinates.h";
  add("Cone_coordinates::form_rounding", Cone::form_rounding,
      largest(slice_errors<Relative_64>(form, slices_of_dot(7, {3}, {6}))) * lost(absolute) +
          3 * Rational(u) * 16 * Rational(u),
      2.01, "gappa", cone);
  // 1 less the errors is rounded as IEEE 754 does: below 1 by half of u. Where the errors are larger, `form_rounding`
  // has more slack than their rounding needs.
  const auto allowance = [](const auto& in) { return Cone::allowed(triple(in, 0)); };
  add("Cone_coordinates::one_rounding", Cone::one_rounding,
      error_within<Ieee_64>(allowance, {{0, 0.25}, {0, 0.25}, {0, 0.25}}), 2.01, "gappa", cone);
  return bounds;
}

}  // namespace tetracone::verify::proofs

#endif
