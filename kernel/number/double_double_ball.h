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
  /// Share by which `is_positive` lowers the high part. It covers the relative error of this part, u, and the rounding
  /// of a product (verify/proofs/nearest_proofs.h).
  static constexpr double high_rounding = 4 * u;
  // Those below are for quotients by a number and by a root. They are derived in verify/proofs/nearest_proofs.h too.
  static constexpr double most_radius =
                              0x1p-48,  ///< upper bound of an accepted divisor's radius, relative to its high part
      quotient_rounding = 0x1p-47,      ///< upper bound of the error of a quotient's second part, relative to this part
      of_quotients = 1 + 0x1p-47,       ///< factor that covers the rounding of a quotient's radius
      most_step = 0x1p-42,      ///< upper bound of an accepted step from a root's first part, relative to this part
      step_rounding = 0x1p-41,  ///< upper bound of the error of the step, relative to the step
      of_steps = 1 + 0x1p-41;   ///< factor that covers the rounding of a step's radius

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

  /// Returns the quotient. Its radius is infinite unless y is surely above 0 and known up to `most_radius`.
  ///
  /// With q = x / y in double, the exact quotient is q + (x - q y) / y.
  friend Double_double_ball operator/(const Double_double_ball& x, const Double_double_ball& y)
  {
    const double by = y.middle.high, first = x.middle.high / by;
    const Double_double_ball rest = x - y * first;
    const double second = rest.middle.high / by;
    const double bound = (rest.radius / by + quotient_rounding * std::abs(second)) * of_quotients + underflow;
    return {Double_double::sum(first, second), y.is_divisor() ? bound : HUGE_VAL};
  }

  /// True when the number is surely above 0, and known up to `most_radius`.
  bool is_divisor() const { return radius < most_radius * middle.high; }

  /// Returns the double that is surely nearest to every number of the ball. Returns nothing where that is not shown,
  /// and for magnitudes outside 2^-900 to 2^900.
  std::optional<double> nearest() const
  {
    const double size = std::abs(middle.high);
    if (!(size > 0x1p-900 && size < 0x1p900)) return std::nullopt;
    // The neighbour towards 0 is no farther than the other.
    const double towards_0 = std::bit_cast<double>(std::bit_cast<std::uint64_t>(size) - 1);
    if (!((std::abs(middle.low) + radius) * of_radii < (size - towards_0) / 2)) return std::nullopt;
    return middle.high;
  }

  /// True when the number is surely above 0.
  bool is_positive() const { return middle.high * (1 - high_rounding) > radius; }
};

/// Returns the double nearest to top / sqrt(square), as `nearest` does. Requires numbers top > 0 and square > 0.
///
/// With q = top / sqrt(square) in double, the exact quotient x is q + (top^2 - q^2 square) / (square (x + q)).
inline std::optional<double> nearest_over_root(const Double_double_ball& top, const Double_double_ball& square)
{
  using Ball = Double_double_ball;
  const Ball first = top.middle.high / std::sqrt(square.middle.high), rest = top * top - first * first * square;
  const double by = first.middle.high * square.middle.high, step = rest.middle.high / by / 2;
  const double radius =
      (rest.radius / by / 2 + Ball::step_rounding * std::abs(step)) * Ball::of_steps + Ball::underflow;
  const bool is_near = std::abs(step) + radius < Ball::most_step * first.middle.high;
  return is_near && square.is_divisor() ? Ball(Double_double::sum(first.middle.high, step), radius).nearest()
                                        : std::nullopt;
}

}  // namespace tetracone::kernel

#endif
