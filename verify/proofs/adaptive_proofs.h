#ifndef TETRACONE_VERIFY_PROOFS_ADAPTIVE_PROOFS_H
#define TETRACONE_VERIFY_PROOFS_ADAPTIVE_PROOFS_H

#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/adaptive_bounds.h"
#include "verify/proofs/proof.h"

/// The constants of kernel/predicate/adaptive_bounds.h and of `Pose::determinant_sign`.
namespace tetracone::verify::proofs {

namespace detail {

/// Returns the three inputs from `first` on.
template <class Number>
std::array<Number, 3> triple(const std::vector<Number>& in, int first)
{
  return {in[first], in[first + 1], in[first + 2]};
}

/// Returns the differences of three points from one at 0: the inputs, rounded as differences are.
template <class Number>
std::array<std::array<Number, 3>, 3> differences(const std::vector<Number>& in)
{
  const std::array<Number, 3> origin = {Number(0), Number(0), Number(0)};
  return {kernel::difference(triple(in, 0), origin), kernel::difference(triple(in, 3), origin),
          kernel::difference(triple(in, 6), origin)};
}

/// Returns the terms of a placed coordinate, with entries that may be fractions: inputs m0 m1 m2 t x y z.
template <class Number>
std::array<Number, 4> placed_terms(const std::vector<Number>& in)
{
  return kernel::placed_terms(entry(in[0]), entry(in[1]), entry(in[2]), entry(in[3]), triple(in, 4));
}
/// Returns the four slices of these terms.
inline std::vector<Slice> slices_of_placed()
{
  return {{1, 0, 0, 0, 1, 0, 0}, {0, 1, 0, 0, 0, 1, 0}, {0, 0, 1, 0, 0, 0, 1}, {0, 0, 0, 1, 0, 0, 0}};
}

/// Returns an upper bound of the factor by which rounding makes a bound too small. `bound()` computes the bound in
/// `Rounding_count`.
template <class Bound>
Rational loss(const Bound& bound)
{
  return 1 / bound().least(Rational(kernel::adaptive_bound::u));
}

}  // namespace detail

/// Returns their proofs. Throws std::runtime_error when Gappa does not prove one.
inline Proved_bounds adaptive_proofs()
{
  namespace bound = kernel::adaptive_bound;
  using Count = Rounding_count;
  using detail::triple;
  const double u = bound::u;
  const Rational grown = 1 + Rational(u), widened = 1 / (1 - Rational(u)), cube = widened * widened * widened;
  const std::string file = "kernel/predicate/adaptive_bounds.h";
  const Count count;
  Proved_bounds bounds;
  const auto add = [&](const std::string& name, double in_code, const Rational& proved, double unit, double loosest,
                       const std::string& by = "gappa") {
    bounds.push_back({name, file, Rational(in_code), proved, unit, loosest, by});
  };

  // An image: its error relative to the sum of the magnitudes of its terms, which is itself computed from rounded
  // entries.
  const auto placed = [](const auto& in) { return kernel::sum(detail::placed_terms(in)); };
  const Rational image = largest(slice_errors<Relative_64>(placed, detail::slices_of_placed()));
  const std::vector<Count> counts(9);
  add("image", bound::image,
      image * detail::loss([&] { return bound::image_bound(kernel::sum_of_magnitudes(detail::placed_terms(counts))); }),
      u, 1.21);
  const auto sum_of_two = [](const auto& in) { return in[0] + in[1]; };
  add("translation", bound::translation,
      largest(slice_errors<Relative_64>(sum_of_two, slices_of_sum(2))) * widened *
          detail::loss([&] { return count * count; }),
      u, 1.002);

  // The filter: exact differences of images are at most 1 / (1 - u) times the computed ones, whose upper bound is m_k.
  const auto volume = [](const auto& in) {
    const auto p = detail::differences(in);
    return kernel::determinant(p[0], p[1], p[2]);
  };
  const Rational volume_loss = detail::loss([&] { return bound::volume_bound(count, count, count, count); });
  add("volume", bound::volume, sum(slice_errors<Relative_64>(volume, slices_of_determinant())) * cube * volume_loss, u,
      1.07);
  add("volume_motion", bound::volume_motion, 6 * cube * volume_loss, 1, 1.001, "rationals");

  const std::vector<Slice> two_products = {{1, 0, 0, 1}, {0, 1, 1, 0}};
  const auto normal = [](const auto& in) {
    const auto zero = std::decay_t<decltype(in[0])>(0);
    return kernel::cross_component(in[0] - zero, in[1] - zero, in[2] - zero, in[3] - zero);
  };
  const Rational normal_loss = detail::loss([&] { return bound::normal_bound(count, count, count); });
  add("normal", bound::normal, sum(slice_errors<Relative_64>(normal, two_products)) * widened * widened * normal_loss,
      u, 1.13);
  add("normal_motion", bound::normal_motion, 2 * widened * widened * normal_loss, 1, 1.001, "rationals");
  const Rational difference_loss = detail::loss([&] { return bound::difference_bound(count + count); });
  add("difference_motion", bound::difference_motion, grown * difference_loss, 1, 1.002, "rationals");

  // Double-double: the terms of the translation come first. The high part has a relative error of u, and bounds are in
  // double.
  const auto placed_in_double_double = [](const auto& in) {
    const auto terms = detail::placed_terms(in);
    return kernel::sum(std::array{terms[3], terms[0], terms[1], terms[2]});
  };
  add("double_double_image", bound::double_double_image,
      largest(slice_errors<Relative_double_double>(placed_in_double_double, detail::slices_of_placed())) *
          detail::loss([&] {
            return bound::double_double_image_bound(kernel::sum_of_magnitudes(detail::placed_terms(counts)));
          }),
      u * u, 1.18);
  const auto difference_of_two = [](const auto& in) { return in[0] - in[1]; };
  const Rational difference = largest(slice_errors<Relative_double_double>(difference_of_two, slices_of_sum(2)));
  add("double_double_difference", bound::double_double_difference,
      difference / (1 - difference) * grown *
          detail::loss([&] { return bound::double_double_difference_error(count, count); }),
      u * u, 1.007);
  const auto determinant = [](const auto& in) {
    return kernel::determinant(triple(in, 0), triple(in, 3), triple(in, 6));
  };
  const std::array<Count, 3> three;
  const Rational wide_loss = detail::loss([&] { return bound::double_double_volume_bound(three, three); }) * widened;
  add("double_double_volume", bound::double_double_volume,
      sum(slice_errors<Relative_double_double>(determinant, slices_of_determinant())) * grown * grown * grown *
          wide_loss,
      u * u, 1.11);
  add("volume_motion in double-double", bound::volume_motion, 6 * grown * grown * grown * wide_loss, 1, 1.001,
      "rationals");
  const auto component = [](const auto& in) { return kernel::cross_component(in[0], in[1], in[2], in[3]); };
  const Rational narrow_loss =
      detail::loss([&] { return bound::double_double_normal_bound(count, count, count, count); }) * widened;
  add("double_double_normal", bound::double_double_normal,
      sum(slice_errors<Relative_double_double>(component, two_products)) * grown * grown * narrow_loss, u * u, 1.11);
  add("normal_motion in double-double", bound::normal_motion, 2 * grown * grown * narrow_loss, 1, 1.001, "rationals");
  add("difference_motion in double-double", bound::difference_motion, grown * widened * difference_loss, 1, 1.002,
      "rationals");

  // The sign of det M: its error relative to the permanent, for entries that may be rounded fractions.
  const auto of_entries = [](const auto& in) {
    auto entries = in;
    for (auto& x : entries) x = entry(x);
    return kernel::determinant(triple(entries, 3), triple(entries, 6), triple(entries, 0));
  };
  const Rational determinant_error = largest(slice_errors<Relative_64>(of_entries, slices_of_determinant()));
  const auto permanent = [&] {
    auto entries = counts;
    for (auto& x : entries) x = entry(x);
    return kernel::Pose::determinant_bound(
        kernel::permanent(triple(entries, 3), triple(entries, 6), triple(entries, 0)));
  };
  bounds.push_back({"Pose::determinant_rounding", "kernel/number/pose.h", Rational(kernel::Pose::determinant_rounding),
                    determinant_error * detail::loss(permanent), u, 2.01, "gappa"});
  return bounds;
}

}  // namespace tetracone::verify::proofs

#endif
