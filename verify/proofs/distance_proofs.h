#ifndef TETRACONE_VERIFY_PROOFS_DISTANCE_PROOFS_H
#define TETRACONE_VERIFY_PROOFS_DISTANCE_PROOFS_H

#include "tetracone/kernel/bound/cone_cells.h"
#include "tetracone/kernel/bound/triangle_distance.h"
#include "tetracone/kernel/number/double_double_ball.h"
#include "verify/proofs/adaptive_proofs.h"
#include "verify/proofs/proof.h"

/// The constants of kernel/bound/triangle_distance.h, of balls of double-double, and of the signs by which the point
/// locator's cones decide.
namespace tetracone::verify::proofs {

namespace detail {

/// Returns a coordinate of a point of a triangle, or of an edge if the last input is 0. Inputs: three coordinates, and
/// two weights.
template <class Number>
Number coordinate_in_triangle(const std::vector<Number>& in)
{
  const std::array<Number, 3> a = {in[0], in[0], in[0]}, b = {in[1], in[1], in[1]}, c = {in[2], in[2], in[2]};
  return kernel::triangle_distance::point_in_triangle(std::array{a, b, c}, in[3], in[4])[0];
}

/// Returns the gap of two corners along n. Inputs: n, one of B, one of A.
template <class Number>
Number gap_along(const std::vector<Number>& in)
{
  const auto n = triple(in, 0);
  return kernel::dot(n, triple(in, 3)) + kernel::dot(std::array{-n[0], -n[1], -n[2]}, triple(in, 6));
}

/// Returns the determinant by which a cone's side is decided. Inputs: a, b, p.
template <class Number>
Number cone_side(const std::vector<Number>& in)
{
  return kernel::cone_determinant(triple(in, 0), triple(in, 3), triple(in, 6));
}

/// Returns the determinant by which the side of a triangle's plane is decided. Inputs: a, b, c, p.
template <class Number>
Number plane_side(const std::vector<Number>& in)
{
  return kernel::plane_determinant(triple(in, 0), triple(in, 3), triple(in, 6), triple(in, 9));
}

}  // namespace detail

/// Returns their proofs. Throws std::runtime_error when Gappa does not prove one.
inline Proved_bounds distance_proofs()
{
  namespace td = kernel::triangle_distance;
  using Count = Rounding_count;
  const double u = kernel::unit_roundoff<double>;
  const Rational up = 1 + Rational(u), down = 1 - Rational(u);
  Proved_bounds bounds;
  const std::string of_triangles = "kernel/bound/triangle_distance.h", of_cones = "kernel/bound/cone_cells.h";

  // Lengths are roots of sums of squares: half of the squares' roundings count, and the root's own in full. `below`
  // divides by one, multiplies and subtracts. `above` multiplies and adds, and its squares are of differences.
  const std::array<Count, 3> point, way = kernel::difference(point, point);
  const int of_square = kernel::dot(point, point).count(), of_difference = kernel::dot(way, way).count();
  const Rational below = 1 - power(down, (of_square + 1) / 2 + 1) / power(up, 3),
                 above = 1 / power(down, (of_difference + 1) / 2 + 1 + 2) - 1;
  bounds.push_back({"triangle_distance::length_rounding", of_triangles, Rational(td::length_rounding),
                    std::max(below, above), u, 1.34, "rationals"});

  // Points of triangles whose largest coordinate R is in [1, 2). Except for underflow, which `Common_frame` excludes,
  // the relative error is equal for every R. Weights are each at most 1. Their computed sum is at most 1, so the exact
  // one is at most 1 + u, which moves the point by 2 R u. Two points have errors in three coordinates each, so the root
  // of 3 counts twice. `of_gap` is relative to |n|_1 2 R, and |n|_1 is at most the root of 3 times |n|_2. `slack` is 4
  // times its sum, and is rounded.
  Rational in_triangle = 0;
  constexpr int parts = 16;
  for (int k = 0; k < parts; ++k) {
    const double low = 1 + double(k) / parts, high = 1 + double(k + 1) / parts;
    const Range coordinate{-high, high}, weight{0, 1};
    const auto expression = [](const auto& in) { return detail::coordinate_in_triangle(in); };
    in_triangle = std::max(
        in_triangle, Rational(error_within<Ieee_64>(expression, {coordinate, coordinate, coordinate, weight, weight}) /
                              Rational(low)));
  }
  const Rational of_gap = largest(
      slice_errors<Relative_64>([](const auto& in) { return detail::gap_along(in); }, slices_of_dot(9, {3, 6})));
  const Rational half_root_of_3 = Rational(8661) / 10000;
  const Rational point_rounding =
      half_root_of_3 * std::max(Rational(in_triangle + 2 * Rational(u)), of_gap) / power(down, 4);
  bounds.push_back({"triangle_distance::point_rounding", of_triangles, Rational(td::point_rounding), point_rounding, u,
                    1.03, "gappa"});

  // Balls of double-double: the proved errors of their sums and products, relative to the high part of the result.
  // Magnitudes and radii are rounded on their way; a magnitude first becomes a high part.
  using Ball = kernel::Double_double_ball;
  const std::string of_balls = "kernel/number/double_double_ball.h";
  const Rational square(u * u);
  const Rational sum_error = 3 * square / (1 - 4 * Rational(u)), product_error = 7 * square;
  bounds.push_back({"Double_double_ball::sum_rounding", of_balls, Rational(Ball::sum_rounding),
                    sum_error / (1 - sum_error) * up, u * u, 1.34, "rationals"});
  bounds.push_back({"Double_double_ball::product_rounding", of_balls, Rational(Ball::product_rounding),
                    product_error / (1 - product_error) * up, u * u, 1.15, "rationals"});
  const Count radius, magnitude = entry(radius);
  const int of_radius = std::max(Ball::radius_of_sum(radius, radius, magnitude).count(),
                                 Ball::radius_of_product(magnitude, radius, magnitude, radius, magnitude).count());
  bounds.push_back({"Double_double_ball::of_radii", of_balls, Rational(Ball::of_radii) - 1,
                    1 / power(down, of_radius) - 1, u, 2.3, "rationals"});
  // The remainder of the high parts' product, both mixed products, and three products of radii.
  bounds.push_back({"Double_double_ball::underflow", of_balls, Rational(Ball::underflow),
                    (Double_double_range::lost_by_product() + 3 * Double_range::lost_by_product()) * 2, 0x1p-1074, 2731,
                    "rationals"});

  // Signs about the origin, for a model's coordinates of at most 1 and a point with a norm of at most 4. The errors of
  // its coordinates change the determinants by their minors.
  const Range model{-1, 1}, far{-4, 4};
  const Rational off(kernel::local_error);
  const Rational of_cone = error_within<Ieee_64>([](const auto& in) { return detail::cone_side(in); },
                                                 {model, model, model, model, model, model, far, far, far}) +
                           (8 + 8 + 6) * off;
  bounds.push_back({"cone_side_bound", of_cones, Rational(kernel::cone_side_bound), of_cone, u, 3.5, "gappa"});
  const Rational of_plane =
      error_within<Ieee_64>([](const auto& in) { return detail::plane_side(in); },
                            {model, model, model, model, model, model, model, model, model, far, far, far}) +
      2 * (28 + 28 + 24) * off;
  bounds.push_back({"plane_side_bound", of_cones, Rational(kernel::plane_side_bound), of_plane, u, 1.71, "gappa"});
  return bounds;
}

}  // namespace tetracone::verify::proofs

#endif
