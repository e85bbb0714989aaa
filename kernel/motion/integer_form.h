#ifndef TETRACONE_KERNEL_MOTION_INTEGER_FORM_H
#define TETRACONE_KERNEL_MOTION_INTEGER_FORM_H

#include <CGAL/enum.h>
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::kernel {

using Integer = mpz_class;

inline CGAL::Sign sign_of(const Integer& x) { return static_cast<CGAL::Sign>(sgn(x)); }

/// A form in s = 1-t and t with integer coefficients: coefficient k belongs to s^(n-k) t^k. It is also the polynomial
/// with these coefficients in v = t/s, which is positive for t in (0, 1).
class Integer_form {
 public:
  Integer_form() = default;
  explicit Integer_form(std::vector<Integer> coefficients) : coefficients_(std::move(coefficients)) {}

  template <std::size_t N>
  explicit Integer_form(std::array<Integer, N> coefficients)
      : coefficients_(std::make_move_iterator(coefficients.begin()), std::make_move_iterator(coefficients.end()))
  {}

  void push_back(Integer coefficient) { coefficients_.push_back(std::move(coefficient)); }

  /// Returns the number of coefficients, one more than the degree; 0 for an empty form, which is zero.
  std::size_t size() const { return coefficients_.size(); }
  const Integer& operator[](std::size_t k) const { return coefficients_[k]; }

  /// Return the values at t = 0 and at t = 1. Require a form that is not empty.
  const Integer& at_start() const { return coefficients_.front(); }
  const Integer& at_end() const { return coefficients_.back(); }

  bool is_zero() const
  {
    return std::ranges::all_of(coefficients_, [](const Integer& c) { return sgn(c) == 0; });
  }

  /// Requires forms of one degree.
  Integer_form& operator+=(const Integer_form& other)
  {
    assert(size() == other.size());
    for (std::size_t k = 0; k < size(); ++k) coefficients_[k] += other[k];
    return *this;
  }
  Integer_form& operator-=(const Integer_form& other)
  {
    assert(size() == other.size());
    for (std::size_t k = 0; k < size(); ++k) coefficients_[k] -= other[k];
    return *this;
  }
  friend Integer_form operator+(Integer_form f, const Integer_form& g) { return f += g; }
  friend Integer_form operator-(Integer_form f, const Integer_form& g) { return f -= g; }

  Integer_form& operator*=(const Integer& factor)
  {
    for (Integer& c : coefficients_) c *= factor;
    return *this;
  }
  friend Integer_form operator*(Integer_form f, const Integer& factor) { return f *= factor; }

  /// Makes this the zero form of this size, and keeps its memory.
  void clear(std::size_t size)
  {
    coefficients_.resize(size);
    for (Integer& c : coefficients_) c = 0;
  }

  /// Adds f times a factor. Requires forms of one degree.
  void add_product(const Integer_form& f, const Integer& factor)
  {
    assert(size() == f.size());
    for (std::size_t k = 0; k < size(); ++k)
      mpz_addmul(coefficients_[k].get_mpz_t(), f[k].get_mpz_t(), factor.get_mpz_t());
  }

  /// Requires forms that are not empty.
  friend Integer_form operator*(const Integer_form& f, const Integer_form& g)
  {
    std::vector<Integer> product(f.size() + g.size() - 1);
    for (std::size_t i = 0; i < f.size(); ++i)
      for (std::size_t j = 0; j < g.size(); ++j)
        mpz_addmul(product[i + j].get_mpz_t(), f[i].get_mpz_t(), g[j].get_mpz_t());
    return Integer_form(std::move(product));
  }

  /// Returns this function of t, with s + t = 1, as a form of `size` coefficients. Requires a form that is not empty,
  /// and a `size` that is not below the present one.
  Integer_form raised_to(std::size_t size) const
  {
    Integer_form result = *this;
    while (result.size() < size) result.multiply(1, 1);
    return result;
  }

  /// Returns the number of changes of sign along the coefficients, zeros skipped. It is the number of roots in (0, 1)
  /// with their multiplicities, or larger by an even number (Descartes).
  int variations() const
  {
    int count = 0, last = 0;
    for (const Integer& c : coefficients_) {
      const int sign = sgn(c);
      if (sign != 0 && last != 0 && sign != last) ++count;
      if (sign != 0) last = sign;
    }
    return count;
  }

  /// Returns the sign just after t = 0; ZERO for the zero form. If the form has no variations, that is its sign in all
  /// of (0, 1).
  CGAL::Sign only_sign() const
  {
    for (const Integer& c : coefficients_)
      if (sgn(c) != 0) return sign_of(c);
    return CGAL::ZERO;
  }

  /// Returns the value at s : t, by Horner's scheme.
  Integer at(const Integer& s, const Integer& t) const
  {
    Integer sum = 0, power = 1;
    for (std::size_t k = size(); k-- > 0;) {
      sum = sum * t + coefficients_[k] * power;
      power *= s;
    }
    return sum;
  }

  /// Returns a form with the roots of this one in (0, 1). It is without factors s and t, which have none there, and
  /// without common divisors of the coefficients. It is empty for the zero form.
  Integer_form primitive() const
  {
    Integer_form result;
    std::size_t begin = 0, end = size();
    while (begin < end && sgn(coefficients_[begin]) == 0) ++begin;
    while (begin < end && sgn(coefficients_[end - 1]) == 0) --end;
    result.coefficients_.assign(coefficients_.begin() + std::ptrdiff_t(begin),
                                coefficients_.begin() + std::ptrdiff_t(end));
    Integer divisor = 0;
    for (std::size_t k = 0; k < result.size() && divisor != 1; ++k) divisor = gcd(divisor, result[k]);
    if (divisor > 1)
      for (Integer& c : result.coefficients_) mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), divisor.get_mpz_t());
    return result;
  }

  /// Returns `primitive()` without factors s + t, which have no roots in (0, 1) either. Raised forms have them.
  Integer_form reduced() const
  {
    Integer_form result = primitive();
    while (result.is_divided_by_sum()) result.divide_by_sum();
    return result;
  }

  /// Returns the form over the first half of its time, times 2^degree: s -> 2s + t, t -> t.
  Integer_form first_half() const
  {
    Integer_form half = *this;
    half.shift();
    for (std::size_t k = 0; k < size(); ++k) half.coefficients_[k] <<= size() - 1 - k;
    return half;
  }

  /// Returns the form over the second half of its time, times 2^degree.
  Integer_form second_half() const { return reversed().first_half().reversed(); }

  /// Returns the form with time reversed.
  Integer_form reversed() const
  {
    Integer_form result = *this;
    std::ranges::reverse(result.coefficients_);
    return result;
  }

  /// Returns the form over the times from m/2^k to (m+1)/2^k, times 2^(k degree). Requires 0 <= m < 2^k.
  Integer_form over(const Integer& m, unsigned k) const { return between(m, m + 1, k); }

  /// Returns the form over the times from `from`/2^k to `to`/2^k, times 2^(k degree). Requires 0 <= from < to <= 2^k.
  Integer_form between(const Integer& from, const Integer& to, unsigned k) const
  {
    // s -> (N-from) s + (N-to) t and t -> from s + to t, by Horner's scheme in forms.
    const Integer whole = Integer(1) << k, s0 = whole - from, s1 = whole - to;
    Integer_form sum, power;
    power.push_back(1);
    for (std::size_t c = size(); c-- > 0;) {
      if (sum.size() > 0) sum.multiply(from, to);
      sum.coefficients_.resize(power.size());
      for (std::size_t j = 0; j < power.size(); ++j) sum.coefficients_[j] += coefficients_[c] * power[j];
      if (c > 0) power.multiply(s0, s1);
    }
    return sum;
  }

 private:
  /// True when s + t divides the form.
  bool is_divided_by_sum() const
  {
    Integer at_minus_one = 0;
    for (std::size_t k = 0; k < size(); ++k) at_minus_one = coefficients_[size() - 1 - k] - at_minus_one;
    return size() > 1 && at_minus_one == 0;
  }

  /// Divides the form by s + t, which divides it.
  void divide_by_sum()
  {
    for (std::size_t k = size() - 1; k-- > 1;) coefficients_[k] -= coefficients_[k + 1];
    coefficients_.erase(coefficients_.begin());
  }

  /// Substitutes s + t for s.
  void shift()
  {
    for (std::size_t last = size() - 1; last > 0; --last)
      for (std::size_t k = 1; k <= last; ++k) coefficients_[k] += coefficients_[k - 1];
  }

  /// Multiplies the form by x s + y t.
  void multiply(const Integer& x, const Integer& y)
  {
    coefficients_.push_back(y * coefficients_.back());
    for (std::size_t k = size() - 2; k > 0; --k) coefficients_[k] = x * coefficients_[k] + y * coefficients_[k - 1];
    coefficients_[0] *= x;
  }

  std::vector<Integer> coefficients_;
};

/// Returns the primitive common divisor of the highest degree in v of two primitive forms; it has size 1 where they
/// share no root. Requires that neither is zero.
inline Integer_form common_divisor(Integer_form f, Integer_form g)
{
  // Euclid's algorithm with primitive pseudo-remainders.
  if (f.size() < g.size()) std::swap(f, g);
  while (g.size() > 1) {
    std::vector<Integer> rest(f.size());
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

/// Returns f / g in v where g divides f; nothing elsewhere. Requires that g is primitive and does not end in zero.
inline std::optional<Integer_form> exact_quotient(const Integer_form& f, const Integer_form& g)
{
  if (f.size() < g.size()) return std::nullopt;
  const std::size_t size = f.size() + 1 - g.size();
  std::vector<Integer> rest(f.size()), found(size);
  for (std::size_t k = 0; k < f.size(); ++k) rest[k] = f[k];
  for (std::size_t k = size; k-- > 0;) {
    // Where a primitive form divides one with integer coefficients, the quotient has such (Gauss' lemma).
    const Integer& leading = rest[k + g.size() - 1];
    if (mpz_divisible_p(leading.get_mpz_t(), g.at_end().get_mpz_t()) == 0) return std::nullopt;
    found[k] = leading / g.at_end();
    for (std::size_t j = 0; j < g.size(); ++j) rest[k + j] -= found[k] * g[j];
  }
  if (std::ranges::any_of(rest, [](const Integer& r) { return sgn(r) != 0; })) return std::nullopt;
  return Integer_form(std::move(found));
}

/// Returns f / g in v. Requires that g is primitive, does not end in zero, and divides f.
inline Integer_form quotient(const Integer_form& f, const Integer_form& g)
{
  std::optional<Integer_form> found = exact_quotient(f, g);
  assert(found);
  return std::move(*found);
}

/// Returns the primitive form with the roots of f in (0, 1), each once. Requires that f is not zero.
inline Integer_form without_squares(const Integer_form& f)
{
  const Integer_form p = f.reduced();
  if (p.size() < 3) return p;
  Integer_form derivative;
  for (std::size_t k = 1; k < p.size(); ++k) derivative.push_back(p[k] * static_cast<unsigned long>(k));
  const Integer_form shared = common_divisor(p, derivative.primitive());
  return shared.size() < 2 ? p : quotient(p, shared);
}

}  // namespace tetracone::kernel

#endif
