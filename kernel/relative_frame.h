#ifndef TETRACONE_KERNEL_RELATIVE_FRAME_H
#define TETRACONE_KERNEL_RELATIVE_FRAME_H

#include "kernel/bounds.h"
#include "kernel/floating_point.h"
#include "kernel/pose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tetracone::kernel {

/// Where a body's local units are: p local is origin + unit * p in the model's coordinates. `unit` is a power of two and the body lies
/// within |p_k| <= 1.
struct Local_units {
  Vertex origin{0, 0, 0};
  double unit = 1;
};

/// The map from the local units of one placed body to those of another, in double, with a bound on its error: p -> linear p + offset, every
/// coordinate of the image of a point with |p_k| <= 1 within `error` of the exact one. `error` is infinite where no bound is known (a
/// pose that is nearly flat, numbers near the ends of the doubles' range).
class Relative_frame {
 public:
  using Row = std::array<double, 3>;

  Relative_frame() = default;

  /// From B's units to A's: (M_a^-1 (M_b (o_b + u_b p) + t_b - t_a) - o_a) / u_a.
  ///
  /// With X the inverse of M_a as computed and rho >= ||I - X M_a||: M_a^-1 differs from X by at most rho / (1 - rho) ||X||. The difference
  /// D of the placed origins is summed in double-double, so that it is off by 4 u |D| + 2^-98 times the sum S of its terms, and by
  /// 2 u S where entries are rounded fractions. Norms are maxima of row sums.
  Relative_frame(const Pose& a, const Local_units& in_a, const Pose& b, const Local_units& in_b)
  {
    constexpr double u = unit_roundoff<double>;
    std::array<Row, 3> inverse;
    if (!invert(a, inverse)) return;
    const double residual = residual_norm(a, inverse), norm_x = norm(inverse), scale = in_b.unit / in_a.unit;
    if (!(residual < 0x1p-20)) return;

    Row difference;
    double terms = 0, largest = 0;
    for (int i = 0; i < 3; ++i) {
      Sum sum;
      for (int j = 0; j < 3; ++j) {
        sum.add_product(b[4 * i + j], in_b.origin[j]);
        sum.add_product(-a[4 * i + j], in_a.origin[j]);
      }
      sum.add(b[4 * i + 3]);
      sum.add(-a[4 * i + 3]);
      difference[i] = sum.high + sum.low;
      terms = std::max(terms, sum.magnitude);
      largest = std::max(largest, std::abs(difference[i]));
    }
    const bool rounded = a.is_rational() || b.is_rational();
    const double difference_error = 4 * u * largest + (rounded ? 2 * u : 0x1p-98) * terms;

    double norm_b = 0;
    for (int i = 0; i < 3; ++i) {
      norm_b = std::max(norm_b, std::abs(b[4 * i]) + std::abs(b[4 * i + 1]) + std::abs(b[4 * i + 2]));
      for (int j = 0; j < 3; ++j) {
        double sum = 0;
        for (int k = 0; k < 3; ++k) sum += inverse[i][k] * b[4 * k + j];
        linear_[i][j] = sum * scale;
      }
      offset_[i] = (inverse[i][0] * difference[0] + inverse[i][1] * difference[1] + inverse[i][2] * difference[2]) / in_a.unit;
    }
    // Relative errors of the products X M_b and X D: 4 u for their own roundings, u for a fraction's entry, 2 rho for X.
    const double relative = 2 * residual + 8 * u;
    const double error = norm_x * (norm_b * scale * relative + (largest * relative + difference_error * 1.01) / in_a.unit);
    // Beyond the gate something may have overflowed or underflowed: then nothing is known.
    const double top = std::max({terms, norm_b, norm_x, scale, 1 / scale, in_a.unit, 1 / in_a.unit});
    if (top <= 0x1p200 && error <= std::numeric_limits<double>::max()) error_ = error * 1.01 + 0x1p-300;
    decide_similarity();
  }

  double error() const { return error_; }

  /// linear = scale * (orthonormal columns but for `axis_defect`).
  bool is_similarity() const { return similarity_; }

  const std::array<Row, 3>& linear() const { return linear_; }

  template <class Number>
  Row operator()(const std::array<Number, 3>& p) const
  {
    Row image = direction(p);
    for (int i = 0; i < 3; ++i) image[i] += offset_[i];
    return image;
  }

  /// The linear part alone.
  template <class Number>
  Row direction(const std::array<Number, 3>& p) const
  {
    Row image;
    for (int i = 0; i < 3; ++i) image[i] = linear_[i][0] * double(p[0]) + linear_[i][1] * double(p[1]) + linear_[i][2] * double(p[2]);
    return image;
  }

 private:
  /// A sum in double-double.
  struct Sum {
    double high = 0, low = 0, magnitude = 0;

    void add(double x)
    {
      const double sum = high + x, part = sum - high;
      low += (high - (sum - part)) + (x - part);
      high = sum;
      magnitude += std::abs(x);
    }
    void add_product(double x, double y)
    {
      const double product = x * y;
      low += std::fma(x, y, -product);
      add(product);
    }
  };

  static bool invert(const Pose& a, std::array<Row, 3>& inverse)
  {
    const auto m = [&a](int i, int j) { return a[4 * i + j]; };
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const int k = (i + 1) % 3, l = (i + 2) % 3, n = (j + 1) % 3, o = (j + 2) % 3;
        inverse[j][i] = m(k, n) * m(l, o) - m(k, o) * m(l, n);
      }
    const double determinant = m(0, 0) * inverse[0][0] + m(0, 1) * inverse[1][0] + m(0, 2) * inverse[2][0];
    if (!(std::abs(determinant) > 0x1p-200 && std::abs(determinant) < 0x1p200)) return false;
    for (Row& row : inverse)
      for (double& x : row) x /= determinant;
    return true;
  }

  static double norm(const std::array<Row, 3>& m)
  {
    double norm = 0;
    for (const Row& row : m) norm = std::max(norm, std::abs(row[0]) + std::abs(row[1]) + std::abs(row[2]));
    return norm;
  }

  /// At least ||I - X M_a||: as computed, and 5 u a term for the computation and a fraction's entry.
  static double residual_norm(const Pose& a, const std::array<Row, 3>& x)
  {
    double norm = 0;
    for (int i = 0; i < 3; ++i) {
      double row = 0;
      for (int j = 0; j < 3; ++j) {
        double sum = i == j ? -1 : 0, magnitude = 1;
        for (int k = 0; k < 3; ++k) sum += x[i][k] * a[4 * k + j], magnitude += std::abs(x[i][k] * a[4 * k + j]);
        row += std::abs(sum) + 6 * unit_roundoff<double> * magnitude;
      }
      norm = std::max(norm, row);
    }
    return norm;
  }

  void decide_similarity()
  {
    const auto column = [this](int i, int j) {
      return linear_[0][i] * linear_[0][j] + linear_[1][i] * linear_[1][j] + linear_[2][i] * linear_[2][j];
    };
    const double square = column(0, 0), tolerance = square * 0x1p-24;
    similarity_ = std::abs(column(1, 1) - square) <= tolerance && std::abs(column(2, 2) - square) <= tolerance &&
                  std::abs(column(0, 1)) <= tolerance && std::abs(column(1, 2)) <= tolerance && std::abs(column(0, 2)) <= tolerance;
  }

  std::array<Row, 3> linear_{};
  Row offset_{};
  double error_ = std::numeric_limits<double>::infinity();
  bool similarity_ = false;
};

}  // namespace tetracone::kernel

#endif
