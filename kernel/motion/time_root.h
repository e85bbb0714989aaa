#ifndef TETRACONE_KERNEL_MOTION_TIME_ROOT_H
#define TETRACONE_KERNEL_MOTION_TIME_ROOT_H

#include "tetracone/kernel/motion/integer_form.h"
#include "tetracone/kernel/number/floating_point.h"

#include <climits>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace tetracone::kernel {

/// The times from m / 2^k to (m+1) / 2^k. Requires 0 <= m < 2^k.
struct Time_cell {
  Integer m = 0;
  unsigned k = 0;
};

/// A time in [0, 1], exact. It is a dyadic number, or a simple root of a form in an open dyadic cell that holds no
/// other root of it.
class Time_root {
 public:
  /// The time m / 2^k.
  Time_root(Integer m, unsigned k) : exact_(true), m_(std::move(m)), k_(k) {}

  /// The root of `form`, which is primitive, in the cell from m/2^k to (m+1)/2^k. `there` is the form over the cell.
  /// Requires that it has one variation.
  Time_root(const Integer_form& form, Integer_form there, Integer m, unsigned k)
      : exact_(false), m_(std::move(m)), k_(k), form_(form), there_(std::move(there))
  {}

  bool is_dyadic() const { return exact_; }

  /// Returns the sign of this time less m / 2^k. Changes nothing.
  CGAL::Sign compare(const Integer& m, unsigned k) const
  {
    const auto at = [&](const Integer& own) {
      return sign_of(k < k_ ? Integer(own - (m << (k_ - k))) : Integer((own << (k - k_)) - m));
    };
    if (exact_) return at(m_);
    if (at(m_) != CGAL::NEGATIVE) return CGAL::POSITIVE;
    if (at(m_ + 1) != CGAL::POSITIVE) return CGAL::NEGATIVE;
    // The form has one root in the cell, and has its cell's first sign before it.
    const CGAL::Sign there = sign_of(form_.at((Integer(1) << k) - m, m));
    return there == CGAL::ZERO ? CGAL::ZERO : there == there_.only_sign() ? CGAL::POSITIVE : CGAL::NEGATIVE;
  }

  /// Returns the cell that holds this time, or begins with it where it is dyadic.
  Time_cell cell() const { return {m_, k_}; }

  /// Returns `cell()` after making the cell far smaller, where doubles find a smaller one.
  Time_cell close_cell()
  {
    if (!exact_) refine_at_once();
    return cell();
  }

  /// Returns the primitive form that it is a root of. Requires a time that is not dyadic.
  const Integer_form& form() const { return form_; }

  /// Returns approximately this time, as near as doubles give it from the form in its cell.
  double about() const
  {
    const double start = mpz_get_d(m_.get_mpz_t());
    return std::ldexp(exact_ ? start : start + about_in_cell(), -int(k_));
  }

  /// Returns the sign of g at this time. May refine the cell.
  CGAL::Sign sign(const Integer_form& g)
  {
    if (exact_) return sign_at_dyadic(g);
    // A linear form has its root at s : t = |f_1| : |f_0|. No cell is made smaller for it.
    if (form_.size() == 2) return sign_of(g.at(abs(form_[1]), abs(form_[0])));
    if (g.is_zero()) return CGAL::ZERO;
    refine_at_once();
    if (exact_) return sign_at_dyadic(g);
    if (const CGAL::Sign there = certain_sign(g); there != CGAL::ZERO) return there;
    Integer_form cell = g.over(m_, k_);
    if (cell.variations() == 0) return cell.only_sign();
    const Integer_form shared = common_divisor(form_, g.primitive());
    // Roots of a divisor are roots of the form: at most one in the cell, and Descartes' count tells odd from even.
    if (shared.size() > 1 && shared.over(m_, k_).variations() % 2 == 1) return CGAL::ZERO;
    while (cell.variations() != 0) {
      const Half half = refine();
      if (half == Half::none) return sign_at_dyadic(g);
      cell = half == Half::first ? cell.first_half() : cell.second_half();
    }
    return cell.only_sign();
  }

  /// True when this time is before `other`. May refine both.
  bool is_before(Time_root& other)
  {
    if (!other.exact_) {
      // Where they differ, the cells come apart, unless this is a root of the other's form in the other's cell.
      if (sign(other.form_) == CGAL::ZERO && in_cell_of(other)) return false;
      for (;;) {
        const CGAL::Sign from_start = sign(difference_from(other.m_, other.k_)),
                         from_end = sign(difference_from(other.m_ + 1, other.k_));
        if (from_start != CGAL::POSITIVE) return true;
        if (from_end != CGAL::NEGATIVE) return false;
        if (other.refine() == Half::none) break;
      }
    }
    return sign(difference_from(other.m_, other.k_)) == CGAL::NEGATIVE;
  }

  /// Returns the linear form that is t - m/2^k up to a positive factor.
  static Integer_form difference_from(const Integer& m, unsigned k)
  {
    return Integer_form(std::array<Integer, 2>{Integer(-m), Integer((Integer(1) << k) - m)});
  }

  /// Returns the value of a form at rest : x, where rest is 1 - x.
  template <class Number>
  static Number value_at(const Number& x, const Number& rest, const std::vector<Number>& coefficients)
  {
    Number value(0), power(1);
    for (std::size_t k = coefficients.size(); k-- > 0;) {
      value = value * x + coefficients[k] * power;
      power = power * rest;
    }
    return value;
  }

  /// Upper bound of the error of `value_at` in double, relative to the number of coefficients, at most
  /// `most_coefficients`, times the sum of their magnitudes. Coefficients are truncated, and x has an error of 3 u.
  /// Proved in verify/proofs/motion_proofs.h. It covers underflow, since the largest coefficient is at least 1/2.
  static constexpr double value_error = 0x1p-50;
  static constexpr std::size_t most_coefficients = 40;

 private:
  enum class Half { none, first, second };

  /// The number of halvings made at once. An approximation in double is good enough for it, and few of the times
  /// compared with it are nearer.
  static constexpr unsigned halvings_at_once = 24;

  /// Returns a form in double, times a power of two that makes its largest coefficient at most 1. Coefficients are
  /// truncated.
  static std::vector<double> rounded(const Integer_form& form)
  {
    std::vector<double> coefficients(form.size());
    std::vector<long> exponents(form.size());
    long largest = LONG_MIN;
    for (std::size_t k = 0; k < form.size(); ++k) {
      coefficients[k] = mpz_get_d_2exp(&exponents[k], form[k].get_mpz_t());
      if (coefficients[k] != 0) largest = maximum(largest, exponents[k]);
    }
    for (std::size_t k = 0; k < form.size(); ++k)
      coefficients[k] = std::ldexp(coefficients[k], int(maximum(exponents[k] - largest, -2000L)));
    return coefficients;
  }

  /// Returns the sign of g in all of the cell, as far as double tells it. That is its value at the cell's middle, if
  /// the cell's length and `value_error` cannot change it. The slope of s^(n-k) t^k is at most n.
  CGAL::Sign certain_sign(const Integer_form& g) const
  {
    if (g.size() > most_coefficients) return CGAL::ZERO;
    const std::vector<double> coefficients = rounded(g);
    const double cell = std::ldexp(1.0, -int(k_)), x = (mpz_get_d(m_.get_mpz_t()) + 0.5) * cell,
                 value = value_at(x, 1 - x, coefficients);
    double sum = 0;
    for (const double c : coefficients) sum += std::abs(c);
    const double error = sum * double(coefficients.size()) * (cell + value_error);
    return value > error ? CGAL::POSITIVE : value < -error ? CGAL::NEGATIVE : CGAL::ZERO;
  }

  /// Returns approximately the root of a form of one variation, from 0 to 1, by bisection in double.
  double about_in_cell() const
  {
    const std::vector<double> coefficients = rounded(there_);
    const double sense = there_.only_sign();
    double low = 0, high = 1;
    for (int round = 0; round < 60; ++round) {
      const double x = 0.5 * (low + high);
      (sense * value_at(x, 1 - x, coefficients) > 0 ? low : high) = x;
    }
    return 0.5 * (low + high);
  }

  /// Replaces the cell by one far within it, about an approximation, if the root is inside. Replaces it by the root if
  /// that is an end of the small cell, and so dyadic. It does so once only.
  void refine_at_once()
  {
    if (is_refined_) return;
    is_refined_ = true;
    const Integer at(std::floor(std::ldexp(about_in_cell(), halvings_at_once)));
    const Integer m = (m_ << halvings_at_once) + at;
    const unsigned k = k_ + halvings_at_once;
    const CGAL::Sign after_start = compare(m, k), after_end = compare(m + 1, k);
    exact_ = after_start == CGAL::ZERO || after_end == CGAL::ZERO;
    if (exact_) {
      m_ = after_start == CGAL::ZERO ? m : Integer(m + 1);
      k_ = k;
      return;
    }
    if (after_start != CGAL::POSITIVE || after_end != CGAL::NEGATIVE) return;
    there_ = form_.over(m, k);
    m_ = m;
    k_ = k;
  }

  CGAL::Sign sign_at_dyadic(const Integer_form& g) const { return sign_of(g.at((Integer(1) << k_) - m_, m_)); }

  bool in_cell_of(const Time_root& other)
  {
    return sign(difference_from(other.m_, other.k_)) == CGAL::POSITIVE &&
           sign(difference_from(other.m_ + 1, other.k_)) == CGAL::NEGATIVE;
  }

  /// Halves the cell. There is no half where the root is its middle, and so dyadic.
  Half refine()
  {
    Integer_form first = there_.first_half(), second = there_.second_half();
    m_ <<= 1;
    ++k_;
    if (sgn(second.at_start()) == 0) {
      exact_ = true;
      ++m_;
      return Half::none;
    }
    if (first.variations() % 2 == 1) {
      there_ = std::move(first);
      return Half::first;
    }
    ++m_;
    there_ = std::move(second);
    return Half::second;
  }

  bool exact_, is_refined_ = false;
  Integer m_;
  unsigned k_;
  Integer_form form_, there_;
};

namespace detail {

inline void isolate_within(const Integer_form& form, const Integer_form& cell, const Integer& m, unsigned k,
                           std::vector<Time_root>& found)
{
  const int variations = cell.variations();
  if (variations == 0) return;
  if (variations == 1) {
    found.emplace_back(form, cell, m, k);
    return;
  }
  const Integer_form second = cell.second_half();
  const Integer middle = 2 * m + 1;
  isolate_within(form, cell.first_half(), 2 * m, k + 1, found);
  if (sgn(second.at_start()) == 0) found.emplace_back(middle, k + 1);
  isolate_within(form, second, middle, k + 1, found);
}

}  // namespace detail

/// Returns the roots within a cell, without its ends, of a form that is not zero, each once, in order. It applies
/// Descartes' rule of signs to nested halves (Collins and Akritas 1976), which ends where no root is multiple. One
/// variation means one simple root.
inline std::vector<Time_root> roots_within(const Integer_form& form, const Time_cell& cell = {})
{
  std::vector<Time_root> found;
  Integer_form there = form.over(cell.m, cell.k);
  const int variations = there.variations();
  if (variations == 0) return found;
  if (variations == 1) {
    found.emplace_back(form.reduced(), std::move(there), cell.m, cell.k);
    return found;
  }
  const Integer_form simple = without_squares(form);
  detail::isolate_within(simple, simple.over(cell.m, cell.k), cell.m, cell.k, found);
  return found;
}

}  // namespace tetracone::kernel

#endif
