#ifndef TETRACONE_KERNEL_NUMBER_DOUBLE_DOUBLE_BALL_H
#define TETRACONE_KERNEL_NUMBER_DOUBLE_DOUBLE_BALL_H

#include "tetracone/kernel/number/double_double.h"
#include "tetracone/kernel/number/floating_point.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

namespace tetracone::kernel {

/// A real number that differs from `middle` by at most `radius`, which is infinite or NaN where nothing is known.
///
/// A sum in double-double has a relative error of 3 u^2 / (1 - 4 u), a product one of 7 u^2. Where parts underflow, a
/// few times 2^-1074 are added. Both errors are computed from the high part, whose relative error is u. Where a sum's
/// error term underflows, the sum is exact. A computed radius is rounded by at most 16 u of it.
struct Double_double_ball {
  Double_double middle;
  double radius = 0;

  Double_double_ball() = default;
  Double_double_ball(double x) : middle(x) {}
  Double_double_ball(const Double_double& x, double r) : middle(x), radius(r) {}

  static constexpr double u = unit_roundoff<double>;
  // All four are proved in verify/proofs/distance_proofs.h.
  static constexpr double sum_rounding = 4 * u * u,  ///< upper bound of a sum's error, relative to its high part
      product_rounding = 8 * u * u,                  ///< upper bound of a product's error, relative to its high part
      of_radii = 1 + 16 * u,                         ///< factor that covers the rounding of a computed radius
      underflow = 0x1p-1060;                         ///< upper bound of what underflow adds to a product's error
  /// Upper bound of the relative error of the high part, and of its product with 1 - `high_rounding`
  /// (verify/proofs/nearest_proofs.h).
  static constexpr double high_rounding = 4 * u;

  /// Return the radius of a sum and of a product x y. They take the radii of both numbers and the result's magnitude;
  /// the product also takes both magnitudes.
  template <class Number>
  static Number radius_of_sum(const Number& x_radius, const Number& y_radius, const Number& sum)
  {
    return (x_radius + y_radius + Number(sum_rounding) * sum) * Number(of_radii);
  }
  template <class Number>
  static Number radius_of_product(const Number& x, const Number& x_radius, const Number& y, const Number& y_radius,
                                  const Number& product)
  {
    const Number by_radii = x * y_radius + x_radius * (y + y_radius);
    return (by_radii + Number(product_rounding) * product) * Number(of_radii) + Number(underflow);
  }

  friend Double_double_ball operator-(const Double_double_ball& x)
  {
    return {{-x.middle.high, -x.middle.low}, x.radius};
  }
  friend Double_double_ball operator+(const Double_double_ball& x, const Double_double_ball& y)
  {
    const Double_double sum = x.middle + y.middle;
    return {sum, radius_of_sum(x.radius, y.radius, std::abs(sum.high))};
  }
  friend Double_double_ball operator-(const Double_double_ball& x, const Double_double_ball& y) { return x + -y; }
  friend Double_double_ball operator*(const Double_double_ball& x, const Double_double_ball& y)
  {
    const Double_double product = x.middle * y.middle;
    return {product, radius_of_product(std::abs(x.middle.high), x.radius, std::abs(y.middle.high), y.radius,
                                       std::abs(product.high))};
  }

  /// True when the number is surely above 0.
  bool is_positive() const { return middle.high * (1 - high_rounding) > radius; }
};

/// Returns the double nearest to top / sqrt(square), where the quotient surely lies between the midpoints to both
/// neighbours. Returns nothing elsewhere, and outside 2^-900 to 2^900. Requires numbers top > 0 and square > 0.
inline std::optional<double> nearest_over_root(const Double_double_ball& top, const Double_double_ball& square)
{
  const Double_double_ball top_square = top * top;
  const auto left = [&](const Double_double_ball& x) { return top_square - x * x * square; };
  double nearest = top.middle.high / std::sqrt(square.middle.high);
  nearest += left(nearest).middle.high / (2 * nearest * square.middle.high);  // a step of Newton's
  if (!(nearest > 0x1p-900 && nearest < 0x1p900)) return std::nullopt;
  const auto bits = std::bit_cast<std::uint64_t>(nearest);
  const double below = std::bit_cast<double>(bits - 1), above = std::bit_cast<double>(bits + 1);
  const auto middle = [&](double neighbour) {
    return Double_double_ball(Double_double(nearest, (neighbour - nearest) / 2), 0);
  };
  if (!left(middle(below)).is_positive() || !(-left(middle(above))).is_positive()) return std::nullopt;
  return nearest;
}

}  // namespace tetracone::kernel

#endif
