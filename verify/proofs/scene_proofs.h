#ifndef TETRACONE_VERIFY_PROOFS_SCENE_PROOFS_H
#define TETRACONE_VERIFY_PROOFS_SCENE_PROOFS_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/tetratree/memory/pair_certificate.h"
#include "tetracone/tetratree/scene/body_box.h"
#include "tetracone/tetratree/scene/body_extent.h"
#include "tetracone/tetratree/scene/turned_box.h"
#include "verify/proofs/adaptive_proofs.h"
#include "verify/proofs/lanes.h"
#include "verify/proofs/proof.h"

#include <cmath>
#include <initializer_list>

/// The constants of tetratree/scene/ and of pair certificates. They are about boxes of placed and turned bodies, and
/// about motions.
namespace tetracone::verify::proofs {

namespace detail {

/// Returns a coordinate of a placed box. Inputs: a row of a map and its translation, the centre and half the extents of
/// a box.
template <class Number>
tetratree::Placed_coordinate<Number> placed_coordinate(const std::vector<Number>& in)
{
  return {triple(in, 0), in[3], triple(in, 4), triple(in, 7)};
}

/// Returns `placed_coordinate` with rounded entries, as nearest doubles of fractions and differences of two poses are.
template <class Number>
tetratree::Placed_coordinate<Number> placed_by_entries(std::vector<Number> in)
{
  for (std::size_t k = 0; k < 4; ++k) in[k] = entry(in[k]);
  return placed_coordinate(in);
}

/// Returns a row of a step from one pose to the next. Inputs: a row of both poses, the centre and half the extents of a
/// box, and 1. Entries are nearest doubles of fractions, or exact.
template <class Number>
tetratree::Step_of_row<Lanes<Number, 2>> step_of_row(std::vector<Number> in, bool of_fractions = true)
{
  for (std::size_t k = 0; k < 8; ++k)
    if (of_fractions) in[k] = entry(in[k]);
  const auto two = [](const Number& first, const Number& second) { return Lanes<Number, 2>{{first, second}}; };
  return {{two(in[0], in[1]), two(in[2], in[3])},
          {two(in[4], in[5]), two(in[6], in[7])},
          {two(in[8], in[9]), two(in[10], in[14])},
          {two(in[11], in[12]), two(in[13], Number(0))}};
}

/// Returns a sufficient relative error for the root of a square with the roundings of `of_square`, and `after` more
/// roundings after the root.
inline Rational lost_with_root(const Rounding_count& of_square, int after, const Rational& u)
{
  return (1 / (of_square.least(u) * power(1 - u, 2 * after)) - 1) / 2;  // the root of 1 + x is at most 1 + x / 2
}

/// Returns the absolute error by underflow of a box of an image, for any entries, where |c_j| and half_j have these
/// sizes.
inline Rational lost_by_box(double centre, double half)
{
  using Absolute = Range_number<Double_range>;
  std::vector<Absolute> in(10, Absolute(0));
  std::fill_n(in.begin() + 4, 3, Absolute(centre));
  std::fill_n(in.begin() + 7, 3, Absolute(half));
  const auto x = placed_by_entries(in);
  return (x.at - x.reach).lost() + Rational(tetratree::placed_rounding) * x.terms.lost();
}

/// Returns the underflow of a step, as the sum of three:
/// - both centres have one in three rows;
/// - the turning part has one in a sum of squares over the rows, or in one of all entries lengthened by up to 2;
/// - a root has one where its squares underflow.
inline Rational lost_by_step(double centre, double half)
{
  using Absolute = Range_number<Double_range>;
  std::vector<Absolute> in(15, Absolute(0));
  std::fill_n(in.begin() + 8, 3, Absolute(centre));
  std::fill_n(in.begin() + 11, 3, Absolute(half));
  in[14] = Absolute(1);
  const auto sum = [](const auto& lanes) { return lanes[0] + lanes[1]; };
  const auto row = step_of_row(in), nothing = step_of_row(std::vector<Absolute>(15, Absolute(0)));
  const Absolute squares = sum(nothing.squares), longer(2);
  const Rational of_squares = (longer * longer * (squares + squares + squares)).lost();
  const Rational root =
      Rational(std::sqrt(Rational(of_squares * Rational(0x1p1000) * 0x1p74).get_d()) * (1 + 0x1p-50)) *
      Rational(0x1p-537);
  return 6 * sum(row.at).lost() + 2 * root_3() * sum(row.turn).lost() +
         3 * Rational(tetratree::placed_rounding) * sum(row.terms).lost() + root;
}

/// Returns the growth of `lost` per unit of the sum of three sizes.
template <class Lost>
Rational growth(const Lost& lost)
{
  const double size = 0x1p600;
  return Rational(lost(size) - lost(0)) / (3 * Rational(size));
}

}  // namespace detail

/// Returns their proofs. Throws std::runtime_error when Gappa does not prove one.
inline Proved_bounds scene_proofs()
{
  const double u = kernel::unit_roundoff<double>, of_float = kernel::unit_roundoff<float>;
  const Rational once_in_float = 1 + 2 * Rational(of_float);
  const std::string extent = "tetratree/scene/body_extent.h", turned = "tetratree/scene/turned_box.h";
  Proved_bounds bounds;
  const auto add = [&](const std::string& name, const std::string& file, double in_code, const Rational& proved,
                       double unit, double loosest, const std::string& by = "rationals") {
    bounds.push_back({name, file, Rational(in_code), proved, unit, loosest, by});
  };

  std::vector<Slice> terms = slices_of_dot(10, {4, 7});
  terms.push_back(slice_of(10, {3}));
  const Rounding_count of_terms = detail::placed_by_entries(std::vector<Rounding_count>(10)).terms * Rounding_count();
  const Rational lost = 1 / of_terms.least(Rational(u));
  // The difference with the slack is rounded down to the next double.
  const auto low = [](const auto& in) {
    const auto x = detail::placed_by_entries(in);
    return x.at - x.reach;
  };
  add("placed_rounding", extent, tetratree::placed_rounding, largest(slice_errors<Relative_64>(low, terms)) * lost, u,
      2.67, "gappa");
  const auto at = [](const auto& in) { return detail::placed_by_entries(in).at; };
  const Rational of_centre = largest(slice_errors<Relative_64>(at, terms)) * lost;
  add("placed_rounding, of a turned box's centre", turned, 4 * tetratree::placed_rounding,
      root_3() * of_centre * once_in_float, u, 7.4, "gappa");

  // A step is summed over rows. The images of both centres have the largest error. Entries of the rotation are rounded
  // once, and have a smaller one.
  std::vector<Slice> terms_of_step;
  for (int k = 0; k < 3; ++k) terms_of_step.push_back(slice_of(15, {4 + k, 8 + k, 14}));
  terms_of_step.push_back(slice_of(15, {7, 14}));
  const auto at_of_step = [](const auto& in) {
    const auto row = detail::step_of_row(in);
    return row.at[0] + row.at[1];
  };
  const auto of_row = detail::step_of_row(std::vector<Rounding_count>(15), false);
  const auto over_rows = [](const auto& of_one) { return of_one + of_one + of_one; };
  const auto sum = [](const auto& lanes) { return lanes[0] + lanes[1]; };
  // The entries, the product with the share, and two sums are rounded.
  const Rounding_count of_terms_of_step =
      entry(sum(over_rows(of_row.terms))) * Rounding_count() + Rounding_count() + Rounding_count();
  add("placed_rounding, of steps", extent, tetratree::placed_rounding,
      largest(slice_errors<Relative_64>(at_of_step, terms_of_step)) / of_terms_of_step.least(Rational(u)), u, 4.01,
      "gappa");
  const Rounding_count reach, turn = sum(of_row.turn);
  const Rounding_count by_length = reach * reach * sum(over_rows(of_row.squares)), by_turns = over_rows(turn * turn);
  // The root, the product with the share, and two sums are rounded.
  const Rational of_steps = detail::lost_with_root(by_length.count() > by_turns.count() ? by_length : by_turns, 4, u);
  add("step_rounding", extent, tetratree::step_rounding, of_steps, u, 3.37);
  const Rounding_count in_halves = tetratree::square_in_halves(Rounding_count(), Rounding_count(), Rounding_count());
  add("step_rounding, of reaches in halves", extent, tetratree::step_rounding,
      detail::lost_with_root(over_rows(in_halves), 2, u), u, 5.82);

  // Absolute errors are multiples of that of one product or entry. `Body_extent::underflow` itself is rounded in a
  // product and six sums.
  const Rational one_loss = Double_range::lost_by_product();
  const Rational of_underflow = power(1 / (1 - Rational(u)), 7);
  const Rational growth = std::max({detail::growth([](double x) { return detail::lost_by_box(x, 0); }),
                                    detail::growth([](double x) { return detail::lost_by_box(0, x); }),
                                    detail::growth([](double x) { return detail::lost_by_step(x, 0); }),
                                    detail::growth([](double x) { return detail::lost_by_step(0, x); })});
  add("entry_underflow, over 2^-1075", extent, Rational(Rational(tetratree::entry_underflow) / one_loss).get_d(),
      growth * of_underflow / one_loss, 1, 1.16);
  add("placed_underflow", extent, tetratree::placed_underflow,
      std::max(detail::lost_by_box(0, 0), detail::lost_by_step(0, 0)) * of_underflow, 0x1p-540, 1.63);

  // A certificate keeps the vector between the positions, rounded to double and then to float. The vector of a later
  // frame has one rounding to double, relative to the kept vector and to the change.
  const std::string certificates = "tetratree/memory/pair_certificate.h";
  const Rational once_less = 1 - Rational(u), less_in_float = 1 - Rational(of_float);
  const Rational off_then = (1 + Rational(u)) * (1 + Rational(of_float)) - 1;
  const Rounding_count of_between =
      tetratree::error_of_between(std::array{Rounding_count(), Rounding_count(), Rounding_count()});
  add("between_rounding", certificates, tetratree::between_rounding,
      (u + off_then) / (once_less * once_less * less_in_float) / of_between.least(u), of_float, 2.01);
  add("between_underflow", certificates, tetratree::between_underflow, 3 * Rational(0x1p-150) / of_between.least(u),
      0x1p-150, 2.67);
  // The change is squared and summed up, and its share of what was rounded before is added. It is compared with what is
  // left, which is a difference, squared and multiplied.
  const Rounding_count change = Rounding_count() * Rounding_count();
  const Rational squares = power(once_less, (change + change + change).count() + 4) / power(1 + Rational(u), 4);
  add("certificate_rounding", certificates, tetratree::certificate_rounding, 1 - squares, u, 11.7);
  const Rounding_count sum_of_two = tetratree::sum_below(Rounding_count(), entry(Rounding_count()));
  add("sum_rounding, of certificates", certificates, tetratree::sum_rounding,
      power(1 + Rational(u), sum_of_two.count()) - 1, u, 1.34);

  // The numbers of a body's box are differences that were rounded twice, and then once to float, which may make them
  // larger. The places' difference is rounded once before.
  const std::string body_box = "tetratree/scene/body_box.h";
  const auto gap = [](const auto& in) {
    return tetratree::less_turned(tetratree::gap_along(in[0], in[1], in[2]), in[3], in[4], in[5]);
  };
  const std::vector<Rational> of_gap = slice_errors<Relative_64>(gap, slices_of_sum(6));
  const auto low_side = [](const auto& in) { return tetratree::lower_side(in[0], in[1], in[2]); };
  const auto high_side = [](const auto& in) { return tetratree::upper_side(in[0], in[1], in[2]); };
  const std::vector<Rational> of_low = slice_errors<Relative_64>(low_side, slices_of_sum(3)),
                              of_high = slice_errors<Relative_64>(high_side, slices_of_sum(3));
  const auto most = [&](std::initializer_list<Rational> errors) { return std::max(errors); };
  const Rational one = 1, once = 1 + Rational(u);
  // The slack is the constant times a sum of three magnitudes, which has four roundings. `of_gap[5]` is the error of
  // its term in the gap.
  const Rational least_slack = (one - 4 * Rational(u)) * (one - of_gap[5]);
  add("body_box_rounding, of places", body_box, tetratree::body_box_rounding,
      most({Rational(of_gap[0] * once + u), of_low[0], of_high[0]}) / least_slack, u, 2.67, "gappa");
  add("body_box_rounding, of the box's numbers", body_box, tetratree::body_box_rounding,
      (2 * Rational(u) + most({of_gap[1], of_gap[2], of_low[1], of_high[1]}) * once_in_float) / least_slack, u, 2.29,
      "gappa");
  add("body_box_rounding, of what has turned", body_box, tetratree::body_box_rounding,
      1 / ((one - u) * (one - u) * (one - most({of_gap[3], of_gap[4], of_low[2], of_high[2]}) - u)) - 1, u, 2.67,
      "gappa");

  // A direction's entries are rounded to float; those of a fraction are rounded once before. Its norm is a sum by two
  // steps. The sum of both slacks is rounded.
  add("slack_of_direction", extent, tetratree::slack_of_direction,
      (Rational(of_float) + 2 * Rational(u)) * once_in_float * once_in_float * once_in_float +
          Rational(of_float) * Rational(double(tetratree::Support_table::slack + tetratree::slack_of_direction)),
      of_float, 4.01);

  // Points are centres plus sums of axes. Lengths of axes have the errors of a root of a sum, a quotient, and half of
  // three sums.
  const Rounding_count one_extent, of_radius = one_extent + one_extent + one_extent, of_axis = of_radius * one_extent;
  add("turned_radius_rounding", turned, tetratree::turned_radius_rounding,
      1 / (of_radius * of_axis).least(Rational(u)) - 1, u, 1.44e9);
  // A product, a sum and a product are rounded, and the result to float. For a reach, centres are rounded to float too.
  add("turned_extent_rounding", turned, tetratree::turned_extent_rounding,
      Rational(of_float) * once_in_float + 8 * Rational(u), of_float, 4.01);
  add("turned_reach_rounding", turned, tetratree::turned_reach_rounding,
      2 * Rational(of_float) * once_in_float + 8 * Rational(u), of_float, 8.01);

  // A point of a box with axes a_j and its point with rounded axes differ by s_j (a_j - a'_j). Each has an error of
  // `of_float` in length, and so have centres. The axes are orthonormal up to the least defect.
  add("turned_rounding", turned, tetratree::turned_rounding, Rational(of_float) * once_in_float, of_float, 16.1);
  add("turned_centre_rounding", turned, tetratree::turned_centre_rounding, Rational(of_float) * once_in_float, of_float,
      4.01);
  add("axis_defect, of turned boxes", turned, kernel::axis_defect,
      Rational(tetratree::most_skewed) + 2 * Rational(of_float) * once_in_float, of_float, 2.67);
  return bounds;
}

}  // namespace tetracone::verify::proofs

#endif
