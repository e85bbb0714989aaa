#include "verify/searches/searches.h"

#include "tetracone/kernel/bound/origin_offset.h"
#include "tetracone/kernel/bound/relative_frame.h"
#include "tetracone/kernel/number/products.h"
#include "verify/proofs/lanes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace tetracone::verify::proofs {
namespace {
namespace frame_search {

using detail::at, detail::ratio, detail::rounded_once, detail::share, detail::tracked, detail::u;
using Number = Tracked<double>;
using Frame = kernel::Relative_frame;

/// Rows of both bodies times their origins: p and q of A, r and s of B.
double offset(const Inputs& in)
{
  using Pair = Lanes<double, 2>;
  std::vector<double> computed;
  Rational exact = 0;
  double terms = 0;
  for (int k = 0; k < 8; ++k) {
    computed.push_back(in[k] * in[8 + k]);
    exact += (k < 4 ? -1 : 1) * Rational(in[k]) * Rational(in[8 + k]);
    terms += std::abs(computed.back());
  }
  const auto pair_at = [&](int k) { return Pair{{computed[k], computed[k + 1]}}; };
  using Offset = kernel::Origin_offset;
  return share(Offset::sum_of_parts(Offset::difference_in_parts(pair_at(0), pair_at(2), pair_at(4), pair_at(6))), exact,
               terms) /
         u;
}

double compensated(const Inputs& in)
{
  using Offset = kernel::Origin_offset;
  const auto row = [&](int k) { return std::array{in[k], in[k + 1], in[k + 2], in[k + 3]}; };
  const auto sum = Offset::compensated<double>(row(0), at(in, 8), row(4), at(in, 11));
  Rational exact = Rational(in[7]) - Rational(in[3]);
  for (int k = 0; k < 3; ++k)
    exact += Rational(in[4 + k]) * Rational(in[11 + k]) - Rational(in[k]) * Rational(in[8 + k]);
  const Rational parts = Rational(sum.high) + Rational(sum.low);
  return Rational(abs(Rational(parts - exact))).get_d() / sum.magnitude / (u * u);
}

/// The rounding of the result, a double from D in double-double.
double result(const Inputs& in)
{
  return share(in[0] + in[1], Rational(Rational(in[0]) + Rational(in[1])), std::abs(in[0] + in[1])) / u;
}

/// The error for rounded fractions as entries, without the rounding of the result.
double fraction(const Inputs& in)
{
  using Offset = kernel::Origin_offset;
  std::array<double, 8> entries{};
  std::array<Rational, 8> exact;
  for (int k = 0; k < 8; ++k) {
    const Number entry = rounded_once<double>(in[k], in[14 + k]);
    entries[k] = entry.computed;
    exact[k] = entry.exact;
  }
  const auto row = [&](int k) { return std::array{entries[k], entries[k + 1], entries[k + 2], entries[k + 3]}; };
  const auto sum = Offset::compensated<double>(row(0), at(in, 8), row(4), at(in, 11));
  Rational meant = exact[7] - exact[3];
  for (int k = 0; k < 3; ++k) meant += exact[4 + k] * Rational(in[11 + k]) - exact[k] * Rational(in[8 + k]);
  return Rational(abs(Rational(Rational(sum.high) + Rational(sum.low) - meant))).get_d() / sum.magnitude / u;
}

/// The entries of a pose that turns, each with a rounding error: row by row, without translation.
std::array<Number, 12> turning(const Inputs& in)
{
  const auto m = detail::rotation(in, 0);
  const Number zero(0);
  std::array<Number, 12> entries = {zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero};
  for (int k = 0; k < 9; ++k) entries[4 * (k / 3) + k % 3] = rounded_once<double>(m[k / 3][k % 3], in[4 + k]);
  return entries;
}

/// The row sums of I - f G, beyond those computed from G - s^2 I.
double gram(const Inputs& in)
{
  const auto m = turning(in);
  const auto g = [&m](int i, int j) { return Frame::product_of_columns(m, m, i, j); };
  const double square = g(0, 0).computed, f = 1 / square;
  double worst = 0;
  for (int i = 0; i < 3; ++i) {
    Rational exact = 0, computed = 0;
    for (int j = 0; j < 3; ++j) {
      const Number entry = g(i, j);
      exact += abs(Rational((i == j ? 1 : 0) - Rational(f) * entry.exact));
      computed += std::abs(i == j ? entry.computed - square : entry.computed);
    }
    worst = std::max(worst, Rational(exact - computed * Rational(f)).get_d());
  }
  return worst / u;
}

/// An image under the map of products of a row with the columns of B's pose and with D.
double image_of_products(const Inputs& in)
{
  const auto row = tracked<double>(in, 0), point = tracked<double>(in, 15), offset = tracked<double>(in, 12);
  std::array<std::array<Number, 3>, 3> column = {offset, offset, offset};
  double terms = detail::sum_of_terms(row, offset);
  for (int j = 0; j < 3; ++j) {
    column[j] = rounded_once<double>(in, 3 + 3 * j, 18 + 3 * j);
    terms += detail::sum_of_terms(row, column[j]) * std::abs(in[15 + j]);
  }
  const Number one(1);
  const auto part = [&](const std::array<Number, 3>& v) { return kernel::dot(row, v) * one; };
  return ratio(kernel::sum(kernel::placed_terms(part(column[0]), part(column[1]), part(column[2]), part(offset), point))
                   .error(),
               terms) /
         u;
}

/// The row's entries are rounded fractions too.
double image_of_transposed(const Inputs& in)
{
  using Numbers = std::array<Number, 12>;
  const Number zero(0);
  Numbers p = {zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero}, q = p;
  double of_p = 0, of_q = 0;
  for (int k = 0; k < 3; ++k) {
    p[4 * k] = rounded_once<double>(in[k], in[6 + k]);
    q[4 * k] = rounded_once<double>(in[3 + k], in[9 + k]);
    of_p += in[k] * in[k];
    of_q += in[3 + k] * in[3 + k];
  }
  const Number entry = Frame::product_of_columns(p, q, 0, 0) * Number(1);
  const Number image = kernel::sum(kernel::placed_terms(entry, zero, zero, zero, tracked<double>(in, 12)));
  return ratio(image.error(), std::sqrt(of_p * of_q) * std::abs(in[12])) / u;
}

double residual(const Inputs& in)
{
  const auto row = tracked<double>(in, 0), column = rounded_once<double>(in, 3, 6);
  return ratio(Frame::product_sum(Number(-1), row, column).error(), 1 + detail::sum_of_terms(row, column)) / u;
}

/// |v|_1 over |v|_2.
double norm_1(const Inputs& in)
{
  const double length = std::hypot(in[0], in[1], in[2]);
  return ratio(std::abs(in[0]) + std::abs(in[1]) + std::abs(in[2]), length);
}

}  // namespace frame_search
}  // namespace

Searches frame_searches()
{
  using namespace frame_search;
  return {{"Origin_offset::double_rounding", {16, offset}},
          {"Origin_offset::remainder_rounding", {14, compensated}},
          {"Origin_offset::result_rounding", {2, result}},
          {"Origin_offset::fraction_rounding", {22, fraction}},
          {"Relative_frame::gram_rounding", {13, gram}},
          {"Relative_frame::transpose_rounding", {15, image_of_transposed}},
          {"Relative_frame::residual_rounding", {9, residual}},
          {"Relative_frame::inverse_rounding", {27, image_of_products}},
          {"Relative_frame::root_of_3", {3, norm_1}},
          {"axis_norm_1", {3, norm_1}},
          {"position_factor", {3, norm_1}},
          {"Bvh8_containment::beyond_holder", {3, norm_1}}};
}

}  // namespace tetracone::verify::proofs
