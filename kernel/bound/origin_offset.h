#ifndef TETRACONE_KERNEL_BOUND_ORIGIN_OFFSET_H
#define TETRACONE_KERNEL_BOUND_ORIGIN_OFFSET_H

#include "tetracone/kernel/number/double_double.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/simd/short_vectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace tetracone::kernel {

/// The local units of a body: a local point p is origin + unit * p in the model's coordinates. `unit` is a power of
/// two, and the body lies within |p_k| <= 1.
struct Local_scale {
  Vertex origin{0, 0, 0};
  double unit = 1;

  /// True within bounds where the underflow of a pose's entries or of a product is far below all rounding. Beyond them
  /// no test answers.
  bool is_in_range() const
  {
    return unit >= 0x1p-200 && unit <= 0x1p200 &&
           maximum(std::abs(origin[0]), std::abs(origin[1]), std::abs(origin[2])) <= 0x1p200;
  }
};

/// Returns local units about the origin. The unit is a power of two, so that local coordinates are the model's up to
/// the rounding of a difference. Halves are taken, since a difference of the largest doubles overflows.
inline Local_scale local_scale(const Vertex& origin, std::span<const Vertex> vertices)
{
  double half_reach = 0;
  for (const Vertex& v : vertices)
    for (int k = 0; k < 3; ++k) half_reach = maximum(half_reach, std::abs(0.5 * v[k] - 0.5 * origin[k]));
  return {origin, half_reach > 0 ? std::ldexp(1.0, std::clamp(std::ilogb(half_reach) + 2, -1000, 1023)) : 1};
}

/// Return x + y and x y exactly, as a rounded result and its remainder.
inline Double_double two_sum(double x, double y) { return Double_double::sum(x, y); }
inline Double_double two_product(double x, double y) { return Double_double::product(x, y); }

/// D = (M_b o_b + t_b) - (M_a o_a + t_a): the vector from the place of A's local origin to the place of B's.
class Origin_offset {
 public:
  // Parts of a component's sum, a lane each. p and q are the terms of A, r and s those of B, in lanes.
  template <class Lanes>
  [[gnu::always_inline]] static Lanes difference_in_parts(const Lanes& p, const Lanes& q, const Lanes& r,
                                                          const Lanes& s)
  {
    return (r - p) + (s - q);
  }
  template <class Lanes>
  [[gnu::always_inline]] static Lanes terms_in_parts(const Lanes& p, const Lanes& q, const Lanes& r, const Lanes& s)
  {
    return (magnitudes(p) + magnitudes(r)) + (magnitudes(q) + magnitudes(s));
  }
  template <class Lanes>
  [[gnu::always_inline]] static auto sum_of_parts(const Lanes& parts)
  {
    return parts[0] + parts[1];
  }

  /// Computes D in double.
  Origin_offset(const Pose& a, const Local_scale& in_a, const Pose& b, const Local_scale& in_b)
  {
    const Two_doubles a_first = {in_a.origin[0], in_a.origin[1]}, a_last = {in_a.origin[2], 1};
    const Two_doubles b_first = {in_b.origin[0], in_b.origin[1]}, b_last = {in_b.origin[2], 1};
    Two_doubles sum[3], terms[3];  // of component i, in two parts
    for (int i = 0; i < 3; ++i) {
      const double *row_a = a.entries().data() + 4 * i, *row_b = b.entries().data() + 4 * i;
      const Two_doubles p = two_from(row_a) * a_first, q = two_from(row_a + 2) * a_last;
      const Two_doubles r = two_from(row_b) * b_first, s = two_from(row_b + 2) * b_last;
      sum[i] = difference_in_parts(p, q, r, s);
      terms[i] = terms_in_parts(p, q, r, s);
    }
    value_ = {sum_of_parts(sum[0]), sum_of_parts(sum[1]), sum_of_parts(sum[2])};
    const double most = maximum(sum_of_parts(terms[0]), sum_of_parts(terms[1]), sum_of_parts(terms[2]));
    finish(most, 0, double_rounding * most);
  }

  static constexpr double u = unit_roundoff<double>;

  /// Upper bound of the error of D in double, relative to its terms (verify/proofs/frame_proofs.h): 4 roundings of
  /// each, and one of a fraction's entry. The errors of the terms themselves are of second order.
  static constexpr double double_rounding = 5.1 * u;

  // Upper bounds of the errors of D in double-double, proved in verify/proofs/frame_proofs.h.
  static constexpr double result_rounding = 4 * u,  ///< rounding of the result, relative to |D|
      remainder_rounding = 0x1p-98,                 ///< the sum of all remainders, relative to the terms of D
      fraction_rounding = 2 * u;                    ///< in its place where entries are rounded fractions

  /// A sum of numbers and products whose remainders are summed too (Ogita, Rump and Oishi, "Accurate sum and dot
  /// product", SIAM J. Sci. Comput. 2005).
  template <class Number>
  struct Compensated_sum {
    Number high{0}, low{0}, magnitude{0};

    void add(const Number& x)
    {
      using std::abs;
      const auto [sum, lost] = two_sum(high, x);
      low = low + lost;
      high = sum;
      magnitude = magnitude + abs(x);
    }
    void add_product(const Number& x, const Number& y)
    {
      const auto [product, lost] = two_product(x, y);
      low = low + lost;
      add(product);
    }
    Number value() const { return high + low; }
  };

  /// Returns component i of D.
  template <class Number>
  static Compensated_sum<Number> compensated(const std::array<Number, 4>& row_a, const std::array<Number, 3>& origin_a,
                                             const std::array<Number, 4>& row_b, const std::array<Number, 3>& origin_b)
  {
    Compensated_sum<Number> sum;
    for (int j = 0; j < 3; ++j) {
      sum.add_product(row_b[j], origin_b[j]);
      sum.add_product(-row_a[j], origin_a[j]);
    }
    sum.add(row_b[3]);
    sum.add(-row_a[3]);
    return sum;
  }

  /// Returns D in double-double.
  static Origin_offset in_double_double(const Pose& a, const Local_scale& in_a, const Pose& b, const Local_scale& in_b)
  {
    Origin_offset d;
    double terms = 0;
    for (int i = 0; i < 3; ++i) {
      const auto row = [i](const Pose& pose) {
        return std::array{pose[4 * i], pose[4 * i + 1], pose[4 * i + 2], pose[4 * i + 3]};
      };
      const auto sum = compensated(row(a), in_a.origin, row(b), in_b.origin);
      d.value_[i] = sum.value();
      terms = maximum(terms, sum.magnitude);
    }
    d.finish(terms, result_rounding,
             (a.is_rational() || b.is_rational() ? fraction_rounding : remainder_rounding) * terms);
    return d;
  }

  double operator[](int i) const { return value_[i]; }
  /// Returns the largest magnitude of a component of D.
  double largest() const { return largest_; }

  /// Returns an upper bound of the error of a component.
  double error() const { return error_; }

  /// Returns the largest sum of magnitudes of the terms of a component.
  double terms() const { return terms_; }

  Origin_offset operator-() const
  {
    Origin_offset reversed = *this;
    for (double& x : reversed.value_) x = -x;
    return reversed;
  }

 private:
  Origin_offset() = default;

  void finish(double terms, double of_largest, double of_terms)
  {
    terms_ = terms;
    largest_ = maximum(std::abs(value_[0]), std::abs(value_[1]), std::abs(value_[2]));
    error_ = of_largest * largest_ + of_terms;
  }

  std::array<double, 3> value_{};
  double largest_ = 0, terms_ = 0, error_ = 0;
};

}  // namespace tetracone::kernel

#endif
