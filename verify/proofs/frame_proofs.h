#ifndef TETRACONE_VERIFY_PROOFS_FRAME_PROOFS_H
#define TETRACONE_VERIFY_PROOFS_FRAME_PROOFS_H

#include "tetracone/kernel/bound/origin_offset.h"
#include "tetracone/kernel/bound/relative_frame.h"
#include "verify/proofs/adaptive_proofs.h"
#include "verify/proofs/compensated.h"
#include "verify/proofs/lanes.h"
#include "verify/proofs/proof.h"

/// The constants of kernel/bound/origin_offset.h and relative_frame.h.
namespace tetracone::verify::proofs {

namespace detail {

/// Returns the terms of a component of D in double. Inputs: row a (m0 m1 m2 t), origin of a, row b, origin of b.
template <class Number>
std::array<Lanes<Number, 2>, 4> offset_terms(const std::vector<Number>& in)
{
  const auto terms = [&in](int row, int origin, int k) {
    return entry(in[row + k]) * (k < 3 ? in[origin + k] : Number(1));
  };
  const auto translation = [&in](int row) { return entry(in[row + 3]); };
  const auto pair = [](const Number& first, const Number& second) { return Lanes<Number, 2>{{first, second}}; };
  return {pair(terms(0, 4, 0), terms(0, 4, 1)), pair(terms(0, 4, 2), translation(0)),
          pair(terms(7, 11, 0), terms(7, 11, 1)), pair(terms(7, 11, 2), translation(7))};
}

/// Returns the eight slices of these terms.
inline std::vector<Slice> slices_of_offset()
{
  std::vector<Slice> slices;
  for (const int body : {0, 7}) {
    for (int k = 0; k < 3; ++k) slices.push_back(slice_of(14, {body + k, body + 4 + k}));
    slices.push_back(slice_of(14, {body + 3}));
  }
  return slices;
}

/// Returns an upper bound of the error of the sum of all remainders, relative to a term.
inline Rational remainder_loss()
{
  Rational most = 0;
  for (const Slice& slice : slices_of_offset()) {
    std::vector<Remainder_share> in;
    for (const double input : slice) in.emplace_back(input);
    Remainder_share::lost() = 0;
    kernel::Origin_offset::compensated<Remainder_share>({in[0], in[1], in[2], in[3]}, {in[4], in[5], in[6]},
                                                        {in[7], in[8], in[9], in[10]}, {in[11], in[12], in[13]});
    most = std::max(most, Remainder_share::lost());
  }
  return most;
}

}  // namespace detail

/// Returns their proofs. Throws std::runtime_error when Gappa does not prove one.
inline Proved_bounds frame_proofs()
{
  using Count = Rounding_count;
  using Offset = kernel::Origin_offset;
  using Frame = kernel::Relative_frame;
  using detail::triple;
  const double u = kernel::unit_roundoff<double>;
  const Rational roundoff(u), once = 1 / (1 - roundoff);
  const auto lost = [&](const Count& count) { return Rational(1 / count.least(roundoff)); };
  const Count count;
  Proved_bounds bounds;
  const auto add = [&](const std::string& name, double in_code, const Rational& proved, double unit, double loosest,
                       const std::string& by = "gappa") {
    const std::string file =
        name.starts_with("Origin") ? "kernel/bound/origin_offset.h" : "kernel/bound/relative_frame.h";
    bounds.push_back({name, file, Rational(in_code), proved, unit, loosest, by});
  };

  const auto offset = [](const auto& in) {
    const auto t = detail::offset_terms(in);
    return Offset::sum_of_parts(Offset::difference_in_parts(t[0], t[1], t[2], t[3]));
  };
  const auto terms = detail::offset_terms(std::vector<Count>(14));
  const Count most = Offset::sum_of_parts(Offset::terms_in_parts(terms[0], terms[1], terms[2], terms[3]));
  add("Origin_offset::double_rounding", Offset::double_rounding,
      largest(slice_errors<Relative_64>(offset, detail::slices_of_offset())) * lost(most * count), u, 1.03);
  // The result rounds once. The error of the remainders does not depend on the terms; entries with a relative error of
  // u add u.
  const Rational remainders = detail::remainder_loss() * lost(most * count);
  add("Origin_offset::result_rounding", Offset::result_rounding, roundoff * once * lost(count * count), u, 4.01,
      "rationals");
  add("Origin_offset::remainder_rounding", Offset::remainder_rounding, remainders, u * u, 3.94, "rationals");
  add("Origin_offset::fraction_rounding", Offset::fraction_rounding, roundoff * lost(most * count) + remainders, u,
      2.01, "rationals");

  // Entries of f M^T N, and of f M^T D: products of columns |M_i| |N_j|, by Cauchy and Schwarz.
  const std::vector<Slice> terms_of_dot = slices_of_dot();
  const auto of_columns = [](const auto& in, bool second_is_entry, bool scaled) {
    using Number = std::decay_t<decltype(in[0])>;
    std::array<Number, 12> p = {in[0], in[0], in[0], in[0], in[0], in[0], in[0], in[0], in[0], in[0], in[0], in[0]},
                           q = p;
    for (int k = 0; k < 3; ++k) {
      p[4 * k] = entry(in[k]);
      q[4 * k] = second_is_entry ? entry(in[3 + k]) : in[3 + k];
    }
    const Number product = Frame::product_of_columns(p, q, 0, 0);
    return scaled ? product * Number(1) : product;
  };
  const auto gram = [&](const auto& in) { return of_columns(in, true, false); };
  const Rational entry_of_gram = largest(slice_errors<Relative_64>(gram, terms_of_dot));
  // Columns of a similarity up to its defect. Three entries per row are rounded, the quotient f, and the difference of
  // squares, which is itself below twice the defect.
  const Rational defect(Frame::similarity_defect), columns = 1 + 2 * defect;
  add("Relative_frame::gram_rounding", Frame::gram_rounding,
      3 * entry_of_gram * columns * columns + roundoff * once + 16 * roundoff * defect, u, 1.51);
  // An image adds 4 roundings to those of the entries: product, two sums, the offset.
  const auto image_of = [](const auto& entry_of_map) {
    const auto zero = std::decay_t<decltype(entry_of_map)>(0), one = std::decay_t<decltype(entry_of_map)>(1);
    return kernel::sum(kernel::placed_terms(entry_of_map, zero, zero, zero, std::array{one, one, one}));
  };
  const auto linear = [&](const auto& in) { return image_of(of_columns(in, true, true)); };
  add("Relative_frame::transpose_rounding", Frame::transpose_rounding,
      largest(slice_errors<Relative_64>(linear, terms_of_dot)) * columns * columns, u, 1.61);

  const auto residual = [](const auto& in) {
    const auto column = triple(in, 4);
    return Frame::product_sum(in[0], triple(in, 1), std::array{entry(column[0]), entry(column[1]), entry(column[2])});
  };
  const std::vector<Slice> terms_of_residual = {
      {1, 0, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 1, 0, 0}, {0, 0, 1, 0, 0, 1, 0}, {0, 0, 0, 1, 0, 0, 1}};
  const std::array<Count, 3> three, entries = {entry(count), entry(count), entry(count)};
  const Count magnitude = Frame::product_sum(count, three, entries) * count + count + count + count;
  // Sums of a row's entries round also their computed part, which is below `most_residual` of the residual's terms.
  add("Relative_frame::residual_rounding", Frame::residual_rounding,
      largest(slice_errors<Relative_64>(residual, terms_of_residual)) * lost(magnitude) +
          4 * roundoff * Rational(Frame::most_residual),
      u, 1.21);
  const auto row = [&](const auto& in) {
    const auto column = triple(in, 3);
    return image_of(kernel::dot(triple(in, 0), std::array{entry(column[0]), entry(column[1]), entry(column[2])}) *
                    std::decay_t<decltype(in[0])>(1));
  };
  add("Relative_frame::inverse_rounding", Frame::inverse_rounding,
      largest(slice_errors<Relative_64>(row, terms_of_dot)), u, 1.12);

  // The image of a point with error d < 2^-10: (norm + 2 error) d + error <= (1 + 2 d) (error + norm d); rho / (1 -
  // rho) for rho < `most_residual`; and some 30 roundings of the bounds themselves.
  add("Relative_frame::second_order", Frame::second_order,
      (1 + 2 * Rational(0x1p-10)) / (1 - Rational(Frame::most_residual)) * power(once, 30), 1, 1.009, "rationals");
  return bounds;
}

}  // namespace tetracone::verify::proofs

#endif
