#ifndef TETRACONE_VERIFY_PROOFS_NEAREST_PROOFS_H
#define TETRACONE_VERIFY_PROOFS_NEAREST_PROOFS_H

#include "tetracone/kernel/bound/common_frame.h"
#include "tetracone/kernel/bound/triangle_distance.h"
#include "tetracone/kernel/number/double_double_ball.h"
#include "tetracone/kernel/predicate/enclosed_distance.h"
#include "tetracone/tetratree/memory/element_gap.h"
#include "tetracone/tetratree/query/bvh8_distance.h"
#include "verify/proofs/adaptive_proofs.h"
#include "verify/proofs/proof.h"

/// The constants by which the nearest pair of elements is found. They are those of the common frame of two bodies, of
/// limits and distances in it, and of directions that decide without exact numbers.
namespace tetracone::verify::proofs {

namespace detail {

/// Returns a coordinate of the image of a local point by a map of fractions. Inputs: a row, and the point, which has an
/// error of two roundings.
template <class Number>
Number image_in_common(const std::vector<Number>& in)
{
  const std::array<Number, 3> row = {entry(in[0]), entry(in[1]), entry(in[2])},
                              point = {entry(entry(in[3])), entry(entry(in[4])), entry(entry(in[5]))};
  return kernel::dot(row, point);
}

/// Returns a row of L^T L less a multiple of the sum of squares, with all terms taken as positive. Inputs: three
/// columns.
template <class Number>
Number row_of_gram(const std::vector<Number>& in)
{
  return kernel::least_stretch_bound::row_of_gram(triple(in, 0), triple(in, 3), triple(in, 6));
}

}  // namespace detail

/// Returns the proofs of these constants. Throws std::runtime_error when Gappa does not prove one.
inline Proved_bounds nearest_proofs()
{
  using Ball = kernel::Double_double_ball;
  using Count = Rounding_count;
  using Distance = tetratree::Bvh8_distance<>;
  using Enclosed = kernel::Enclosed_distance;
  using Frame = kernel::Common_frame;
  namespace stretch = kernel::least_stretch_bound;
  const double unit = kernel::unit_roundoff<double>;
  const Rational u(unit), up = 1 + u, down = 1 - u, similarity(kernel::Relative_frame::similarity_defect);
  Proved_bounds bounds;
  const auto add = [&](const std::string& name, const std::string& file, double in_code, const Rational& proved,
                       double in_units, double loosest, const std::string& by = "rationals") {
    bounds.push_back({name, file, Rational(in_code), proved, in_units, loosest, by});
  };

  const std::string of_frame = "kernel/bound/common_frame.h";
  add("Common_frame::image_rounding", of_frame, Frame::image_rounding,
      largest(slice_errors<Relative_64>([](const auto& in) { return detail::image_in_common(in); }, slices_of_dot())),
      unit, 1.34, "gappa");
  // One sum is rounded. Its argument has an error below 8 u.
  add("Common_frame::way_rounding", of_frame, Frame::way_rounding, u * (1 + 8 * u), unit, 2.01);
  // Rounded are a row's sum, the sum with the way, products with shares, their sums, and the last product.
  const Count number, row = number + number + number, way = row + number,
                      error = (number * row + number * way + number * number) * number;
  add("Common_frame::sum_rounding", of_frame, Frame::sum_rounding,
      1 / std::min(error.least(u), (way * number).least(u)) - 1, unit, 2.29);
  // Three products of numbers of at most 1 underflow. So do a pose's entries, times a unit and the power of two that
  // leads to the frame, both at most 2^200.
  using Double = Range_number<Double_range>;
  const Double point(1), map_entry(1, Rational(0x1p-1074) / 2 * Rational(0x1p400));
  add("Common_frame::underflow", of_frame, Frame::underflow,
      kernel::dot(std::array{map_entry, map_entry, map_entry}, std::array{point, point, point}).lost(), 1, 2.57e112);
  // The root of the sum of all squares is at most sqrt(3) times the largest sum of a row, which is rounded.
  add("Common_frame::entry_rounding", of_frame, Frame::entry_rounding, root_3() * u / power(down, 4), unit, 2.32);

  // An entry of a row is a sum of products, each of which is below half the squares of both columns. The first column's
  // squares count thrice at most, as |x|^2 + |x| |y| + |x| |z| does 2 |x|^2 + (|y|^2 + |z|^2) / 2. The rest is rounded,
  // with the sum of squares.
  std::vector<Slice> squares, products;
  for (int k = 0; k < 3; ++k) {
    squares.push_back(slice_of(9, {k}));
    products.push_back(slice_of(9, {k, 3 + k}));
    products.push_back(slice_of(9, {k, 6 + k}));
  }
  Rational of_row = 0;
  for (const auto& slices : {squares, products}) {
    // A slice of a product also contains the square of the first column.
    for (const Rational& lost :
         slice_errors<Relative_64>([](const auto& in) { return detail::row_of_gram(in); }, slices))
      of_row = std::max(of_row, lost);
  }
  const Count sum_of_squares =
      kernel::dot(std::array{number, number, number}, std::array{number, number, number}) + number + number;
  add("row_rounding of least_stretch", of_frame, stretch::row_rounding,
      (2 * of_row + u) / (sum_of_squares * number).least(u), unit, 2.14, "gappa");
  add("root_rounding of least_stretch", of_frame, stretch::root_rounding, 1 - power(1 / up, 3), unit, 1.34);
  // The volume is a difference, which is doubled. A sum of squares, a quotient and a product are rounded too.
  add("quotient_rounding of least_stretch", of_frame, stretch::quotient_rounding,
      1 - power(down, sum_of_squares.count()) / power(up, 3), unit, 4.01);

  // Rows of a similarity are as long as its columns, up to its defect.
  add("row_of_similarity", "tetratree/memory/element_gap.h", tetratree::row_of_similarity,
      root_3() * (1 + 3 * similarity), 1, 1.16);

  // A limit is rounded, multiplied and added to, on either side.
  const std::string of_distance = "tetratree/query/bvh8_distance.h";
  add("Bvh8_distance::limit_rounding", of_distance, Distance::limit_rounding,
      std::max(Rational(1 - 1 / power(up, 3)), Rational(1 / power(down, 3) - 1)), unit, 1.34);
  // A square is rounded, which counts half in its root. Then the root, a product and a sum are.
  add("Bvh8_distance::distance_rounding", of_distance, Distance::distance_rounding,
      std::max(Rational(1 - 1 / power(up, 4)), Rational(1 / power(down, 4) - 1)), unit, 2.01);
  // The underflow in space grows by the power of two that leads to the frame, below 2^200. The frame adds its own.
  const Rational half_of_least = Rational(0x1p-1074) / 2;
  add("Bvh8_distance::smallest", of_distance, Distance::smallest, half_of_least * Rational(0x1p200) + 2 * half_of_least,
      1, 3.8e22);
  // `root` is an upper bound of the root of `least_square` plus its underflow.
  const Rational root(0x1p-500 + 0x1p-540);
  const Rational square = Rational(Distance::least_square) + half_of_least;
  add("Bvh8_distance::most_unseen", of_distance, Distance::most_unseen,
      square <= root * root ? Rational(root * power(up, 4)) : Rational(1), 1, 1024.1);

  // The low part is below u of the high one. A product with a number less than 1 is rounded.
  add("Double_double_ball::high_rounding", "kernel/number/double_double_ball.h", Ball::high_rounding, 1 - down / up,
      unit, 2.01);
  // A divisor is its high part, up to its low part and its radius. The rest of a quotient has an error of its low part,
  // which is u of its high part, and its radius. The second part, rest over divisor, is rounded.
  const std::string of_ball = "kernel/number/double_double_ball.h";
  const Rational of_divisor = u + Rational(Ball::most_radius);
  const auto of_rest = [&](const Rational& of_quotient) { return Rational((u + of_quotient) / (1 - of_quotient)); };
  add("Double_double_ball::quotient_rounding", of_ball, Ball::quotient_rounding, (of_rest(of_divisor) + u) / down, unit,
      1.84);
  // The radius over the divisor, a sum, and two products are rounded.
  add("Double_double_ball::of_quotients, less 1", of_ball, Ball::of_quotients - 1,
      1 / ((1 - of_divisor) * power(down, 4)) - 1, unit, 1.74);
  // With x the root's quotient and q its first part, |x - q| is at most |rest| / (square q): twice what is compared
  // with `most_step`. So x + q is 2 q, up to this share. Before the step is rounded, the divisor q square is.
  const Rational of_both = (1 + of_divisor) * (1 + Rational(Ball::most_step) * power(up, 4) / (1 - of_divisor)) - 1;
  add("Double_double_ball::step_rounding", of_ball, Ball::step_rounding, (of_rest(of_both) + 2 * u) / power(down, 3),
      unit, 2);
  add("Double_double_ball::of_steps, less 1", of_ball, Ball::of_steps - 1, 1 / ((1 - of_both) * power(down, 6)) - 1,
      unit, 2);
  // The radii of an accepted direction are compared with two sums of magnitudes and a product. Their own sum has two
  // roundings. Each coordinate is rounded once.
  const std::string of_directions = "kernel/predicate/enclosed_distance.h";
  add("Enclosed_distance::direction_error", of_directions, Enclosed::direction_error,
      Rational(Enclosed::most_radii) / power(down, 6) + u / down, unit, 1.34);
  // n . (p x q) over |n|_1 L^2, where coordinates have an error of 2 u L. Each of two products has the errors of both
  // factors and a rounding. Their difference is at most 2 L^2 and is rounded. Then n has its error, and a product with
  // n and two sums are rounded. The slack is rounded four times: two sums, a square, a product.
  const Rational coordinate = 1 + 2 * u, of_product = coordinate * coordinate * up - 1,
                 of_cross = 2 * of_product + u * 2 * (1 + of_product);
  add("Enclosed_distance::side_rounding", of_directions, Enclosed::side_rounding,
      (of_cross + (Rational(Enclosed::direction_error) + 3 * u) * (2 + of_cross) * power(up, 3)) / power(down, 4), unit,
      1.24);
  // n . (x - p) over |n|_1 has these errors. Both points are off: `slack` gives 4 of `position_error`. Their difference
  // is at most 2 `largest`. It has the direction's error, and one rounding each of the difference, a product and two
  // sums. The roundings of `slack` itself come last.
  namespace td = kernel::triangle_distance;
  add("triangle_distance::point_rounding, of directions", "kernel/bound/triangle_distance.h", 4 * td::point_rounding,
      2 * (Rational(Enclosed::direction_error) + 4 * u) / power(down, 12), unit, 4.01);
  return bounds;
}

}  // namespace tetracone::verify::proofs

#endif
