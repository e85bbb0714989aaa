#ifndef TETRACONE_KERNEL_MOTION_INTEGER_FORM_H
#define TETRACONE_KERNEL_MOTION_INTEGER_FORM_H

#include <CGAL/enum.h>
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <utility>

namespace tetracone::kernel {

using Integer = mpz_class;

inline CGAL::Sign sign_of(const Integer& x) { return static_cast<CGAL::Sign>(sgn(x)); }

/// A form in s = 1-t and t of degree at most 3 with integer coefficients: coefficient k is that of s^(n-k) t^k. Also
/// the polynomial of these coefficients in v = t/s, which is positive for t in (0, 1).
class Integer_form {
 public:
  Integer_form() = default;

  template <std::size_t N>
  explicit Integer_form(std::array<Integer, N> coefficients) : size_(N)
  {
    static_assert(N <= 4);
    std::ranges::move(coefficients, coefficients_.begin());
  }

  /// Requires fewer than four coefficients so far.
  void push_back(Integer coefficient) { coefficients_[size_++] = std::move(coefficient); }

  /// The number of coefficients, one more than the degree; 0 for an empty form, which is zero.
  std::size_t size() const { return size_; }
  const Integer& operator[](std::size_t k) const { return coefficients_[k]; }

  const Integer& at_start() const { return coefficients_[0]; }
  const Integer& at_end() const { return coefficients_[size_ == 0 ? 0 : size_ - 1]; }

  bool is_zero() const
  {
    for (std::size_t k = 0; k < size_; ++k)
      if (sgn(coefficients_[k]) != 0) return false;
    return true;
  }

  /// Changes of sign along the coefficients, zeros skipped: the roots in (0, 1), each as often as it is one, or an even
  /// number more (Descartes).
  int variations() const
  {
    int count = 0, last = 0;
    for (std::size_t k = 0; k < size_; ++k) {
      const int sign = sgn(coefficients_[k]);
      if (sign != 0 && last != 0 && sign != last) ++count;
      if (sign != 0) last = sign;
    }
    return count;
  }

  /// The sign in (0, 1) of a form that is not zero and has no variations.
  CGAL::Sign only_sign() const
  {
    for (std::size_t k = 0; k < size_; ++k)
      if (sgn(coefficients_[k]) != 0) return sign_of(coefficients_[k]);
    return CGAL::ZERO;
  }

  /// The value at s : t, by Horner's scheme.
  Integer at(const Integer& s, const Integer& t) const
  {
    Integer sum = 0, power = 1;
    for (std::size_t k = size_; k-- > 0;) {
      sum = sum * t + coefficients_[k] * power;
      power *= s;
    }
    return sum;
  }

  /// The same roots in (0, 1): without factors s and t, which have none there, and common divisors.
  Integer_form primitive() const
  {
    Integer_form result;
    std::size_t begin = 0, end = size_;
    while (begin < end && sgn(coefficients_[begin]) == 0) ++begin;
    while (begin < end && sgn(coefficients_[end - 1]) == 0) --end;
    Integer divisor = 0;
    for (std::size_t k = begin; k < end && divisor != 1; ++k) divisor = gcd(divisor, coefficients_[k]);
    for (std::size_t k = begin; k < end; ++k) result.push_back(coefficients_[k] / divisor);
    return result;
  }

  /// The form over the first half of its time, times 2^degree: s -> 2s + t, t -> t.
  Integer_form first_half() const
  {
    Integer_form half = *this;
    half.shift();
    for (std::size_t k = 0; k < size_; ++k) half.coefficients_[k] <<= size_ - 1 - k;
    return half;
  }

  /// The form over the second half of its time, times 2^degree.
  Integer_form second_half() const { return reversed().first_half().reversed(); }

  /// The form with time reversed.
  Integer_form reversed() const
  {
    Integer_form result = *this;
    std::reverse(result.coefficients_.begin(), result.coefficients_.begin() + static_cast<std::ptrdiff_t>(size_));
    return result;
  }

  /// The form over the times from m/2^k to (m+1)/2^k, times 2^(k degree). Requires 0 <= m < 2^k.
  Integer_form over(const Integer& m, unsigned k) const
  {
    // s -> (N-m) s + (N-m-1) t and t -> m s + (m+1) t, by Horner's scheme in forms.
    const Integer whole = Integer(1) << k, s0 = whole - m, s1 = s0 - 1, t1 = m + 1;
    Integer_form sum, power;
    power.size_ = 1;
    power.coefficients_[0] = 1;
    for (std::size_t c = size_; c-- > 0;) {
      if (sum.size_ > 0) sum.multiply(m, t1);
      sum.size_ = power.size_;
      for (std::size_t j = 0; j < power.size_; ++j) sum.coefficients_[j] += coefficients_[c] * power.coefficients_[j];
      if (c > 0) power.multiply(s0, s1);
    }
    return sum;
  }

 private:
  /// s -> s + t.
  void shift()
  {
    for (std::size_t last = size_ - 1; last > 0; --last)
      for (std::size_t k = 1; k <= last; ++k) coefficients_[k] += coefficients_[k - 1];
  }

  /// Times x s + y t.
  void multiply(const Integer& x, const Integer& y)
  {
    coefficients_[size_] = y * coefficients_[size_ - 1];
    for (std::size_t k = size_ - 1; k > 0; --k) coefficients_[k] = x * coefficients_[k] + y * coefficients_[k - 1];
    coefficients_[0] *= x;
    ++size_;
  }

  std::size_t size_ = 0;
  std::array<Integer, 4> coefficients_;
};

/// The primitive common divisor of the highest degree in v of primitive forms; of size 1 where they share no root.
/// Requires that neither is zero.
inline Integer_form common_divisor(Integer_form f, Integer_form g)
{
  // Euclid's algorithm with primitive pseudo-remainders.
  if (f.size() < g.size()) std::swap(f, g);
  while (g.size() > 1) {
    std::array<Integer, 4> rest;
    for (std::size_t k = 0; k < f.size(); ++k) rest[k] = f[k];
    for (std::size_t top = f.size(); top >= g.size(); --top) {
      const Integer leading = rest[top - 1];
      for (std::size_t k = 0; k < top; ++k) rest[k] *= g.at_end();
      for (std::size_t k = 0; k < g.size(); ++k) rest[top - g.size() + k] -= leading * g[k];
    }
    Integer_form remainder;
    for (std::size_t k = 0; k + 1 < g.size(); ++k) remainder.push_back(rest[k]);
    f = std::move(g);
    g = remainder.primitive();
    if (g.size() == 0) return f;
  }
  return g;
}

/// f / g in v. Requires primitive forms, and that g divides f.
inline Integer_form quotient(const Integer_form& f, const Integer_form& g)
{
  std::array<Integer, 4> rest, found;
  for (std::size_t k = 0; k < f.size(); ++k) rest[k] = f[k];
  const std::size_t size = f.size() + 1 - g.size();
  for (std::size_t k = size; k-- > 0;) {
    found[k] = rest[k + g.size() - 1] / g.at_end();
    for (std::size_t j = 0; j < g.size(); ++j) rest[k + j] -= found[k] * g[j];
  }
  Integer_form result;
  for (std::size_t k = 0; k < size; ++k) result.push_back(found[k]);
  return result;
}

/// The primitive form with the roots of f in (0, 1), each once. Requires that f is not zero.
inline Integer_form without_squares(const Integer_form& f)
{
  const Integer_form p = f.primitive();
  if (p.size() < 3) return p;
  Integer_form derivative;
  for (std::size_t k = 1; k < p.size(); ++k) derivative.push_back(p[k] * static_cast<unsigned long>(k));
  const Integer_form shared = common_divisor(p, derivative.primitive());
  return shared.size() < 2 ? p : quotient(p, shared);
}

}  // namespace tetracone::kernel

#endif
