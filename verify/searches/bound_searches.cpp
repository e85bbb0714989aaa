#include "verify/searches/searches.h"

#include "tetracone/kernel/bound/bounds.h"
#include "tetracone/kernel/bound/cone_coordinates.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/tetratree/fast/separating_direction.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetracone::verify::proofs {
namespace {
namespace bound_search {

using detail::ratio, detail::rounded_once, detail::tracked, detail::u, detail::u_of_float;
using Number = Tracked<double>;
using Frame = kernel::Bound_frame<double, true>;
using Direction = tetratree::Separating_direction;

/// A coordinate of points with two roundings of their own, by entries that are rounded fractions.
double image(const Inputs& in)
{
  const std::array<Number, 4> entry = rounded_once<double, 4>(in, 0, 7);
  std::array<Number, 3> point = tracked<double>(in, 4);
  double reach = 0;
  for (int k = 0; k < 3; ++k) {
    reach = std::max(reach, std::abs(in[4 + k]));
    point[k].exact *= 1 + 2 * Rational(u) * Rational(std::clamp(in[11 + k], -0.99, 0.99));
  }
  const Number placed = kernel::sum(kernel::placed_terms(entry[0], entry[1], entry[2], entry[3], point));
  return ratio(placed.error(),
               Frame::reach_of_row(in[0], in[1], in[2], in[3], reach) * (1 + Frame::magnitude_rounding)) /
         u;
}

/// The corner of the cube that a row moves farthest.
double magnitude(const Inputs& in)
{
  const double reach = std::abs(in[4]);
  const auto signed_reach = [&](int k) { return std::copysign(reach, in[k] * in[3]); };
  const double image = kernel::sum(
      kernel::placed_terms(in[0], in[1], in[2], in[3], std::array{signed_reach(0), signed_reach(1), signed_reach(2)}));
  const double most = Frame::reach_of_row(in[0], in[1], in[2], in[3], reach);
  return std::max(0.0, ratio(std::abs(image) - most, most)) / u;
}

/// The largest row sum of |M^T M| over the computed one, for entries that are rounded fractions; halved for the root.
double stretch(const Inputs& in)
{
  const std::array column = {rounded_once<double>(in, 0, 9), rounded_once<double>(in, 3, 12),
                             rounded_once<double>(in, 6, 15)};
  double computed = 0;
  Rational exact = 0;
  for (int i = 0; i < 3; ++i) {
    double row = 0;
    Rational exact_row = 0;
    for (int j = 0; j < 3; ++j) {
      const Number product = kernel::dot(column[i], column[j]);
      row += std::abs(product.computed);
      exact_row += abs(product.exact);
    }
    computed = std::max(computed, row);
    exact = std::max(exact, exact_row);
  }
  const double root = std::sqrt(computed);
  return root > 0 ? std::max(0.0, Rational((exact / (Rational(root) * Rational(root)) - 1) / 2).get_d()) / u : 0;
}

double ball_distance(const Inputs& in)
{
  const Number square = kernel::squared_length(kernel::difference(tracked<double>(in, 0), tracked<double>(in, 3)));
  const Number radius = abs(Number(in[6])) + abs(Number(in[7])), touching = radius * radius;
  if (square.exact == 0 || touching.exact == 0) return 0;
  const Rational over = (Rational(square.computed) / square.exact) * (touching.exact / Rational(touching.computed));
  return std::max(0.0, Rational(over - 1).get_d()) / u;
}

double ball_radius(const Inputs& in)
{
  const Number square = kernel::squared_length(kernel::difference(tracked<double>(in, 0), tracked<double>(in, 3)));
  const Rational radius(std::sqrt(square.computed));
  return radius > 0 ? std::max(0.0, Rational((square.exact / (radius * radius) - 1) / 2).get_d()) / u : 0;
}

/// A point of each body, placed, along an axis.
double projection(const Inputs& in)
{
  const auto axis = tracked<double>(in, 0);
  double most = 0;
  const auto placed = [&](int first) {
    const auto point = tracked<double>(in, first + 12);
    const double reach = std::max({std::abs(in[first + 12]), std::abs(in[first + 13]), std::abs(in[first + 14])});
    const auto row = [&](int k) {
      const auto m = tracked<double, 4>(in, first + 4 * k);
      most = std::max(most, Frame::reach_of_row(m[0].computed, m[1].computed, m[2].computed, m[3].computed, reach));
      return kernel::sum(kernel::placed_terms(m[0], m[1], m[2], m[3], point));
    };
    return std::array<Number, 3>{row(0), row(1), row(2)};
  };
  const Number gap = kernel::dot(axis, placed(3)) - kernel::dot(axis, placed(18));
  return ratio(gap.error(), most * (std::abs(in[0]) + std::abs(in[1]) + std::abs(in[2]))) / u;
}

/// The first `entries` entries are rounded fractions.
template <int entries, int times>
double determinant(const Inputs& in)
{
  std::array<std::array<Number, 3>, 3> v = {tracked<double>(in, 0), tracked<double>(in, 3), tracked<double>(in, 6)};
  for (int k = 0; k < entries; ++k) v[k / 3][k % 3] = rounded_once<double>(in[k], in[9 + k]);
  return times * ratio(kernel::determinant(v[0], v[1], v[2]).error(), kernel::permanent(v[0], v[1], v[2]).computed) / u;
}

double form(const Inputs& in)
{
  using Cone = kernel::Cone_coordinates<double, true>;
  const auto p = rounded_once<double>(in, 0, 8), normal = tracked<double>(in, 3);
  const Number scale(1 + std::abs(in[6])), length(1 + std::abs(in[7])), zero(0);
  const Number c = Cone::coordinate(p, normal, scale);
  return ratio(Cone::form(std::array{c, zero, zero}, std::array{length, length, length}).error(),
               detail::sum_of_terms(p, normal) / (scale.computed * length.computed)) /
         u;
}

double one(const Inputs& in)
{
  std::array<Number, 3> shares = tracked<double>(in, 0);
  for (int k = 0; k < 3; ++k) shares[k] = Number(std::min(0.25, std::abs(in[k]) / 4));
  return kernel::Cone_coordinates<double, true>::allowed(shares).error() / u;
}

double turned_back(const Inputs& in)
{
  const auto m = tracked<float>(in, 0), row = rounded_once<float>(in, 3, 6);
  return ratio(Direction::turned_back_by(m[0], m[1], m[2], row[0], row[1], row[2]).error(),
               detail::sum_of_terms(m, row)) /
         u_of_float;
}

double gap(const Inputs& in)
{
  const auto m = tracked<float>(in, 0), apart = rounded_once<float>(in, 3, 6);
  const Tracked<float> zero(0);
  const auto lane = [&](int k) { return Direction::lanes_of_gap(m[k], apart[k], zero); };
  return ratio(((lane(0) + lane(1)) + (lane(2) + zero)).error(), detail::sum_of_terms(m, apart)) / u_of_float;
}

double offset(const Inputs& in)
{
  double terms = 0;
  const auto part = [&](int k) {
    const auto term = [&](int entry) {
      const Number product = rounded_once<double>(in[entry + k], in[16 + entry + k]) * Number(in[8 + entry + k]);
      terms += std::abs(product.computed);
      return product;
    };
    return Direction::difference_in_parts(term(0), term(2), term(4), term(6));
  };
  const Number first = part(0), second = part(1);
  return ratio((first + second).error(), terms) / u;
}

/// A direction of the lattice, and a coordinate with the error of its own rounding.
double reach(const Inputs& in)
{
  const auto d = tracked<double>(in, 0);
  std::array<Number, 3> p = tracked<double>(in, 3);
  for (int k = 0; k < 3; ++k) {
    p[k] = Number(std::clamp(in[3 + k], -1.0, 1.0));
    p[k].exact += Rational(std::clamp(in[6 + k], -1.0, 1.0)) * Rational(tetratree::Bvh8_elements::local_error);
  }
  return ratio(kernel::dot(d, p).error(), std::abs(in[0]) + std::abs(in[1]) + std::abs(in[2])) / u;
}

double reach_of_box(const Inputs& in)
{
  using Table = tetratree::Support_table;
  const auto d = tracked<float>(in, 0), origin = tracked<float>(in, 3), centre = tracked<float>(in, 6),
             extent = tracked<float>(in, 18);
  const std::array axes = {tracked<float>(in, 9), tracked<float>(in, 12), tracked<float>(in, 15)};
  double norm = 0;
  for (int k = 0; k < 3; ++k) norm += std::abs(in[k]);
  // At most 20/16 of it: the direction may be of any length.
  return ratio(Table::reach_of_box(d, origin, centre, axes, extent).error(), norm * 16 / 20) / u_of_float;
}

}  // namespace bound_search
}  // namespace

Searches bound_searches()
{
  using namespace bound_search;
  return {{"Bound_frame::error_rounding", {14, image}},
          {"Bound_frame::magnitude_rounding", {5, magnitude}},
          {"Bound_frame::stretch_rounding", {18, stretch}},
          {"ball_distance_rounding", {8, ball_distance}},
          {"ball_radius_rounding", {6, ball_radius}},
          {"projection_rounding and error_rounding of two frames", {33, projection}},
          {"Placed_half_space::determinant_rounding", {18, determinant<9, 1>}},
          {"Placed_half_space::normal_rounding", {15, determinant<6, 2>}},
          {"Cone_coordinates::form_rounding", {11, form}},
          {"Cone_coordinates::one_rounding", {3, one}},
          {"rounding of rows", {9, turned_back}},
          {"rounding of D in float", {9, gap}},
          {"rounding of D in double", {24, offset}},
          {"Support_table::reach_rounding", {9, reach}},
          {"Support_table::box_reach_rounding", {21, reach_of_box}}};
}

}  // namespace tetracone::verify::proofs
