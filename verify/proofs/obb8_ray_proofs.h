#ifndef TETRACONE_VERIFY_PROOFS_OBB8_RAY_PROOFS_H
#define TETRACONE_VERIFY_PROOFS_OBB8_RAY_PROOFS_H

#include "tetracone/kernel/bound/obb8_ray.h"
#include "verify/proofs/axis_number.h"
#include "verify/proofs/proof.h"

/// The constants of kernel/bound/obb8_ray.h, from the expressions of obb8_ray_simd.inl themselves.
namespace tetracone::verify::proofs {

namespace detail {

/// Rounding errors, relative to the length of each vector or to each number. They are the larger of those with fused
/// products and of those without.
struct Ray_shares {
  Rational from = 0, centre = 0, step = 0;  ///< of a scalar product with an axis
  Rational at = 0, reach = 0;               ///< of an entry, times the step
};

/// Enlarges the shares to those with fused products, or without.
template <bool fused>
void enlarge(Ray_shares& shares)
{
  namespace simd = kernel::HWY_NAMESPACE;
  // Inputs: the axis, the ray's origin and a centre, the first of which is rounded to float.
  const auto place = [](const auto& in) {
    using Floats = Axis_number<std::decay_t<decltype(in[0])>, fused>;
    const auto way = [&](int k) { return Sub(Floats(entry(in[3 + k])), Floats(in[6 + k])); };
    return simd::along_axis(Floats(in[0]), Floats(in[1]), Floats(in[2]), way(0), way(1), way(2)).one();
  };
  const auto step = [](const auto& in) {
    using Floats = Axis_number<std::decay_t<decltype(in[0])>, fused>;
    const auto direction = [&](int k) { return Floats(entry(in[3 + k])); };
    return simd::along_axis(Floats(in[0]), Floats(in[1]), Floats(in[2]), direction(0), direction(1), direction(2))
        .one();
  };
  // Inputs: the position along the axis, the step, the extent and the slack.
  const auto enters = [](const auto& in) {
    using Number = std::decay_t<decltype(in[0])>;
    using Floats = Axis_number<Number, fused>;
    return simd::entry_of_slab(Floats(in[0]), Floats(Number(1) / in[1]), Floats(in[2] + in[3])).one();
  };
  const auto enlarged = [](Rational& share, const std::vector<Rational>& errors) {
    share = std::max(share, largest(errors));
  };
  enlarged(shares.from, slice_errors<Relative_32>(place, slices_of_dot(9, {3})));
  enlarged(shares.centre, slice_errors<Relative_32>(place, slices_of_dot(9, {6})));
  enlarged(shares.step, slice_errors<Relative_32>(step, slices_of_dot()));
  enlarged(shares.at, slice_errors<Relative_32>(enters, {{1, 1, 0, 0}}));
  enlarged(shares.reach, slice_errors<Relative_32>(enters, {{0, 1, 1, 0}, {0, 1, 0, 1}}));
}

}  // namespace detail

/// Returns their proofs. Throws std::runtime_error when Gappa does not prove one.
inline Proved_bounds obb8_ray_proofs()
{
  using kernel::Local_ray;
  const double u = kernel::unit_roundoff<float>, of_double = kernel::unit_roundoff<double>;
  const Rational once = 1 + 2 * Rational(of_double), root_8 = 2 * root_2(), computed = 1 + Rational(0x1p-18);
  const Rational defect(kernel::axis_defect), length(Local_ray::length), farthest(Local_ray::farthest);
  const std::string file = "kernel/bound/obb8_ray.h";
  Proved_bounds bounds;

  // The origin is a difference. The direction has half of its square's roundings, the root's and the quotient's. No way
  // along it is longer than that from the farthest corner, and no component of the direction is above 1.
  const std::array<Rounding_count, 3> component;
  const Rational of_direction = ((kernel::dot(component, component).count() + 1) / 2 + 2) * Rational(of_double) * once;
  const auto moved = [](const auto& in) { return Local_ray::farther(in[0], in[1], in[2]); };
  const auto of_way = slice_errors<Relative_64>(moved, {{1, 0, 0}, {0, 1, 1}});
  const Rational way = root_3() * farthest;
  const Rational error =
      ((Rational(of_double) + of_way[0]) * farthest + (of_direction + of_way[1]) * way + of_direction * length) * once;
  bounds.push_back(
      {"Local_ray::error", file, Rational(Local_ray::error), error, Local_ray::farthest * of_double, 1.3, "gappa"});

  detail::Ray_shares shares;
  detail::enlarge<true>(shares);
  detail::enlarge<false>(shares);
  const Rational of_axes = 3 * root_3() * defect, of_points = root_3() * (1 + 4 * defect) * Rational(Local_ray::error),
                 of_place = shares.from * (root_8 + root_3()) + shares.centre * (3 + root_3()),
                 of_steps = shares.step * length + 2 * length * Rational(Local_ray::least_step),
                 of_entry = shares.at * (root_8 + 3) + shares.reach * (root_3() + Rational(Local_ray::slack));
  bounds.push_back({"Local_ray::slack", file, Rational(Local_ray::slack),
                    (of_axes + of_points + of_place + of_steps + of_entry) * computed, u, 1.7, "gappa"});
  return bounds;
}

}  // namespace tetracone::verify::proofs

#endif
