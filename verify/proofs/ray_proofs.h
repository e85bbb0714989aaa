#ifndef TETRACONE_VERIFY_PROOFS_RAY_PROOFS_H
#define TETRACONE_VERIFY_PROOFS_RAY_PROOFS_H

#include "tetracone/kernel/predicate/ray_triangle.h"
#include "verify/proofs/adaptive_proofs.h"
#include "verify/proofs/proof.h"

/// The constants of kernel/predicate/ray_triangle.h.
namespace tetracone::verify::proofs {

namespace detail {

/// Returns the determinant of three vectors. The first `differences` of them are differences from a point at 0; the
/// others are exact.
template <std::size_t differences, class Number>
Number determinant_of_differences(const std::vector<Number>& in)
{
  const std::array<Number, 3> zero = {Number(0), Number(0), Number(0)};
  std::array<std::array<Number, 3>, 3> v = {triple(in, 0), triple(in, 3), triple(in, 6)};
  for (std::size_t k = 0; k < differences; ++k) v[k] = kernel::difference(v[k], zero);
  return kernel::determinant(v[0], v[1], v[2]);
}

}  // namespace detail

/// Returns their proofs. Throws std::runtime_error when Gappa does not prove one.
inline Proved_bounds ray_proofs()
{
  using Ray = kernel::Ray_triangle;
  const double u = kernel::unit_roundoff<double>;
  // Magnitudes are of rounded differences; a bound is a product of at most three such.
  const Rational once = 1 / (1 - Rational(u)), few = power(once, 6);
  Proved_bounds bounds;
  const auto add = [&](const std::string& name, double in_code, const Rational& proved, double unit, double loosest,
                       const std::string& by = "gappa") {
    bounds.push_back({name, "kernel/predicate/ray_triangle.h", Rational(in_code), proved, unit, loosest, by});
  };

  // The direction's components are 2 at most.
  const Rational of_direction = 2 * sum(slice_errors<Relative_64>(
                                        [](const auto&in) { return detail::determinant_of_differences<2>(in); },
                                        slices_of_determinant())),
                 of_corner = sum(slice_errors<Relative_64>(
                     [](const auto&in) { return detail::determinant_of_differences<3>(in); }, slices_of_determinant()));
  add("Ray_triangle::side_rounding", Ray::side_rounding, of_direction * few, u, 1.61);
  add("Ray_triangle::plane_rounding", Ray::plane_rounding, (of_corner + of_direction) * few, u, 2.04);

  // A difference or a sum, a quotient and a product.
  add("Ray_triangle::time_rounding", Ray::time_rounding, power(once, 3) - 1, u, 2.67, "rationals");

  const auto wide = [](const auto& in) { return detail::determinant_of_differences<0>(in); };
  const Rational of_products = sum(slice_errors<Relative_double_double>(wide, slices_of_determinant()));
  add("Ray_triangle::height_rounding", Ray::height_rounding, of_products * few, u * u, 3.89);
  add("Ray_triangle::slope_rounding", Ray::slope_rounding, 2 * of_products * few, u * u, 3.89);
  // The remainder N - q D is below 4 u N. Its product has an error of 7 u^2 of N, its sum 3 u^2 of the remainder. The
  // high parts of the remainder and of D and their quotient add u of the remainder each; so do the correction and the
  // error.
  add("Ray_triangle::quotient_rounding", Ray::quotient_rounding, Rational(u * u) * (7 + 4 * 5) * few, u * u, 9.49,
      "rationals");
  return bounds;
}

}  // namespace tetracone::verify::proofs

#endif
