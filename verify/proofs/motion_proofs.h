#ifndef TETRACONE_VERIFY_PROOFS_MOTION_PROOFS_H
#define TETRACONE_VERIFY_PROOFS_MOTION_PROOFS_H

#include "tetracone/kernel/motion/motion_filter.h"
#include "tetracone/kernel/motion/motion_forms.h"
#include "tetracone/kernel/motion/motion_span.h"
#include "tetracone/kernel/motion/time_root.h"
#include "tetracone/kernel/number/floating_point.h"
#include "verify/proofs/proof.h"

#include <utility>

/// The constants of kernel/motion/: of the filter of moving triangles, and of spans of time.
namespace tetracone::verify::proofs {

namespace detail {

/// A number computed in double: upper bounds of the exact number's magnitude and of the error, in exact rationals. An
/// expression run with these gives its own error for all inputs of such magnitudes, like CGAL's Static_filter_error.
/// Underflow is left out.
struct Static_error {
  Rational most, error;

  /// A constant, exactly.
  explicit Static_error(double value = 0) : most(abs(Rational(value))), error(0) {}
  Static_error(Rational m, Rational e) : most(std::move(m)), error(std::move(e)) {}

  friend Static_error operator+(const Static_error& a, const Static_error& b)
  {
    return rounded({Rational(a.most + b.most), Rational(a.error + b.error)});
  }
  friend Static_error operator-(const Static_error& a, const Static_error& b) { return a + b; }
  friend Static_error operator*(const Static_error& a, const Static_error& b)
  {
    return rounded({Rational(a.most * b.most), Rational(a.error * b.most + b.error * a.most + a.error * b.error)});
  }
  /// Division by a power of two is exact.
  friend Static_error halved(const Static_error& a) { return {Rational(a.most / 2), Rational(a.error / 2)}; }

 private:
  static Static_error rounded(const Static_error& a)
  {
    const Rational u(kernel::unit_roundoff<double>);
    return {a.most, Rational(a.error + u * (a.most + a.error))};
  }
};

/// Returns the largest error of a form's coefficients after all halvings, whichever half is taken: each halving begins
/// with the worst coefficient of the last.
template <std::size_t N>
Rational error_when_halved(kernel::motion_filter::Scaled<N, Static_error> form)
{
  const auto take_worst = [&form](const kernel::motion_filter::Scaled<N, Static_error>& half) {
    Static_error worst = half[0];
    for (const Static_error& x : half) worst = {std::max(worst.most, x.most), std::max(worst.error, x.error)};
    form.fill(worst);
  };
  take_worst(form);
  for (int k = 0; k < kernel::motion_filter::halvings; ++k) {
    auto first = form;
    const auto second = kernel::motion_filter::halve(first);
    for (std::size_t i = 0; i < N; ++i)
      first[i] = {std::max(first[i].most, second[i].most), std::max(first[i].error, second[i].error)};
    take_worst(first);
  }
  return form[0].error;
}

/// Returns the largest error of Time_root::value_at for a form of `count` coefficients, relative to `count` and the sum
/// of their magnitudes. This is the error for one coefficient alone, since each adds its own.
inline Rational error_of_value(std::size_t count)
{
  const Rational u(kernel::unit_roundoff<double>), once = 1 / (1 - u);
  const Static_error x(1), rest(Rational(1), u), coefficient(Rational(1), 2 * u * once);
  Rational worst = 0;
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<Static_error> coefficients(count);
    coefficients[k] = coefficient;
    worst = std::max(worst, kernel::Time_root::value_at(x, rest, coefficients).error);
  }
  // The error of x, times the slope. The sum is of truncated coefficients; it, its products and the bound's sum are
  // rounded too.
  return (worst + 3 * u * int(count - 1)) / int(count) * power(once, int(count) + 4);
}

}  // namespace detail

/// Returns their proofs, in exact rationals.
inline Proved_bounds motion_proofs()
{
  namespace filter = kernel::motion_filter;
  using detail::Static_error;
  const double u = kernel::unit_roundoff<double>;
  const Rational roundoff(u), once = 1 / (1 - roundoff);
  Proved_bounds bounds;
  const auto add = [&](const std::string& name, const std::string& file, double in_code, const Rational& proved,
                       double loosest) {
    bounds.push_back({name, file, Rational(in_code), proved, u, loosest, "rationals"});
  };

  // Differences, relative to the largest computed one of their axis; the bound is a product of up to three such.
  const Static_error difference(1, roundoff * once);
  const kernel::Linear_form<Static_error> form = {difference, difference};
  const kernel::Linear_vector<Static_error> vector = {form, form, form};
  const std::array<kernel::Quadratic_form<Static_error>, 3> crosses = {kernel::cross_form(vector, vector, 0),
                                                                       kernel::cross_form(vector, vector, 1),
                                                                       kernel::cross_form(vector, vector, 2)};
  const auto cross = filter::scaled(crosses[0]), all_three = [&] {
    auto sum = cross;
    for (Static_error& x : sum) x = x + x + x;
    return sum;
  }();
  const Rational bound = once * once * once * once;
  const std::string of_filter = "kernel/motion/motion_filter.h";
  add("motion_filter::cross_error", of_filter, filter::cross_error, detail::error_when_halved<3>(cross) * bound, 1.14);
  add("motion_filter::sum_error", of_filter, filter::sum_error, detail::error_when_halved<3>(all_three) * bound, 1.14);
  add("motion_filter::volume_error", of_filter, filter::volume_error,
      detail::error_when_halved<4>(filter::scaled(kernel::dot_form(crosses, vector))) * bound, 1.12);
  // A coefficient is truncated, and divided by a binomial.
  const Static_error coefficient(1, 2 * roundoff * once);
  add("motion_filter::rounded_error", of_filter, filter::rounded_error,
      detail::error_when_halved<4>(
          filter::scaled(kernel::Cubic_form<Static_error>{coefficient, coefficient, coefficient, coefficient})),
      1.12);

  Rational error_of_value = 0;
  for (std::size_t count = 1; count <= kernel::Time_root::most_coefficients; ++count)
    error_of_value = std::max(error_of_value, detail::error_of_value(count));
  add("Time_root::value_error", "kernel/motion/time_root.h", kernel::Time_root::value_error, error_of_value, 1.62);

  // A coefficient of a span is truncated and divided, and then an average of averages. A local point has two roundings.
  Rounding_count entry_of_map = entry(entry(entry(entry(Rounding_count()))));
  constexpr int most_halvings = 60, averages = int(kernel::Motion_span::most_coefficients) - 1;
  for (int k = 0; k < most_halvings * averages; ++k) entry_of_map = entry(entry_of_map);
  const std::array<Rounding_count, 3> axis,
      row = {entry_of_map, entry_of_map, entry_of_map},
      point = {entry(entry(axis[0])), entry(entry(axis[0])), entry(entry(axis[0]))};
  const auto along = kernel::Motion_span::across(axis, std::array{row, row, row});
  Rounding_count reach = abs(kernel::dot(along, point));
  reach = (reach + reach + reach) + reach;  // of a box's three edges, and its centre
  const Rounding_count difference_of_ranges = (kernel::dot(axis, row) + reach) + reach;
  add("few_roundings, of moving boxes", "kernel/motion/motion_span.h", kernel::few_roundings,
      1 / difference_of_ranges.least(roundoff) * bound - 1, 18.6);
  // A time is a quotient of at most 1, and one more operation adds or subtracts this.
  const Rounding_count zero = kernel::Motion_span::zero_between(Rounding_count(), Rounding_count());
  add("Motion_span::rounding_of_times", "kernel/motion/motion_span.h", kernel::Motion_span::rounding_of_times,
      1 / (zero * Rounding_count()).least(roundoff) - 1, 2.67);
  // The other way: points are placed first, and then projected on the axis.
  const Rounding_count coordinate = kernel::dot(row, point) + entry_of_map,
                       difference_of_points =
                           kernel::dot(axis, std::array{coordinate, coordinate, coordinate}) + axis[0];
  add("few_roundings, of moving points", "kernel/motion/motion_span.h", kernel::few_roundings,
      1 / difference_of_points.least(roundoff) * bound - 1, 18.75);
  return bounds;
}

}  // namespace tetracone::verify::proofs

#endif
