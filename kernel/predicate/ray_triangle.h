#ifndef TETRACONE_KERNEL_PREDICATE_RAY_TRIANGLE_H
#define TETRACONE_KERNEL_PREDICATE_RAY_TRIANGLE_H

#include "tetracone/kernel/number/double_double.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/vertex.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace tetracone::kernel {

/// A ray o + t d, t >= 0, against triangles: a filter in double, which answers uncertain rather than guess, and t
/// rounded correctly by double-double.
///
/// With A, B, C the corners less o and n = (B - A) x (C - A), t = N / D with N = n . A and D = n . d; the signs of d
/// past the edges, det[d, A, B] and so on, sum to D. d is scaled by a power of two to components of at most 2, one of
/// at least 1; what is written t below is that of the scaled d.
class Ray_triangle {
 public:
  enum class Meets { no, yes, uncertain };

  /// `low` and `high` enclose the scaled t where the ray meets the triangle's inside.
  struct Decision {
    Meets meets = Meets::uncertain;
    double low = 0, high = 0;
  };

  /// Requires finite numbers and d != 0.
  Ray_triangle(const Vertex& origin, const Vertex& direction) : origin_(origin)
  {
    double largest = 0;
    for (const double x : direction) largest = maximum(largest, std::abs(x));
    exponent_ = std::ilogb(largest);
    const bool is_common = std::abs(exponent_) <= 1000;  // then so are both powers of two
    const double scale = is_common ? std::ldexp(1, -exponent_) : 0, back = is_common ? std::ldexp(1, exponent_) : 0;
    for (int k = 0; k < 3; ++k) {
      direction_[k] = is_common ? direction[k] * scale : std::scalbn(direction[k], -exponent_);
      scaled_exactly_ = scaled_exactly_ && is_common && direction_[k] * back == direction[k];
      usable_ = usable_ && std::abs(origin[k]) <= 0x1p250;
    }
  }

  /// The direction, scaled, and the power of two that was taken from it.
  const Vertex& direction() const { return direction_; }
  int exponent() const { return exponent_; }

  /// Requires corners within 2^250.
  ///
  /// With M the largest |A_k|, |B_k|, |C_k|: a sign past an edge is a sum of six products of at most 2 M^2, rounded at
  /// most seven times each with its differences: below 2^-46 M^2. With S the largest component of an edge: N sums six
  /// products of at most S^2 M and D six of 2 S^2, rounded likewise: below 2^-46 S^2 M and 2^-45 S^2, of which twice as
  /// much is taken. Nothing underflows that counts beside these.
  Decision operator()(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    const Vertex A = less_origin(a), B = less_origin(b), C = less_origin(c);
    const double M = maximum(largest(A), largest(B), largest(C));
    if (!usable_ || !(M >= 0x1p-300)) return {};
    const double limit = 0x1p-46 * M * M;
    const double ab = determinant(direction_, A, B), bc = determinant(direction_, B, C),
                 ca = determinant(direction_, C, A);
    // No branch but the last: each is a guess.
    const bool some_left = (ab > limit) | (bc > limit) | (ca > limit),
               some_right = (ab < -limit) | (bc < -limit) | (ca < -limit);
    if (some_left & some_right) return {Meets::no};
    const bool all_left = (ab > limit) & (bc > limit) & (ca > limit),
               all_right = (ab < -limit) & (bc < -limit) & (ca < -limit);
    if (!(all_left | all_right)) return {};
    const double turn = all_left ? 1 : -1;

    const Vertex p = difference(b, a), q = difference(c, a);
    const double S = maximum(largest(p), largest(q));
    if (!(S >= 0x1p-300)) return {};
    const double N = determinant(A, p, q) * turn, D = determinant(direction_, p, q) * turn;
    const double error_N = 0x1p-45 * S * S * M, error_D = 0x1p-44 * S * S;
    if (N < -error_N) return {Meets::no};
    if (!(N > error_N) || !(D > 2 * error_D)) return {};
    return {Meets::yes, (N - error_N) / (D + error_D) * (1 - 0x1p-50), (N + error_N) / (D - error_D) * (1 + 0x1p-50)};
  }

  /// t of the ray as it was given, the double nearest to it, where double-double tells. Requires a ray that meets the
  /// triangle's plane in one point.
  ///
  /// Differences of doubles are exact here. A component of n is off by 20 u^2 S^2, u = 2^-53, N by less than 2^-97 S^2
  /// M and D by 2^-96 S^2; the quotient's own error is below 2^-100 of it.
  std::optional<double> rounded(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    const auto exact = [](const Vertex& x, const Vertex& y) {
      std::array<Double_double, 3> d;
      for (int k = 0; k < 3; ++k) d[k] = Double_double::sum(x[k], -y[k]);
      return d;
    };
    const auto A = exact(a, origin_), p = exact(b, a), q = exact(c, a);
    Double_double N, D;
    double S = 0, M = 0;
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      const Double_double normal = p[i] * q[j] - p[j] * q[i];
      N = N + normal * A[k];
      D = D + normal * Double_double(direction_[k]);
      S = maximum(S, std::abs(p[k].high), std::abs(q[k].high));
      M = maximum(M, std::abs(A[k].high));
    }
    if (!usable_ || !scaled_exactly_ || !(S * S * M >= 0x1p-700) || !(S >= 0x1p-300)) return std::nullopt;
    const double quotient = N.high / D.high;
    const Double_double rest = N - Double_double(quotient) * D;
    const double correction = rest.high / D.high;
    const double error =
        std::abs(quotient) * (0x1p-96 * S * S * M / std::abs(N.high) + 0x1p-95 * S * S / std::abs(D.high) + 0x1p-98);
    const double below = quotient + (correction - error), above = quotient + (correction + error);
    const double t = std::scalbn(below, -exponent_);
    if (!(below == above) || !(std::abs(t) >= 0x1p-1000 && std::abs(t) <= 0x1p1000)) return std::nullopt;
    return t;
  }

 private:
  static Vertex difference(const Vertex& a, const Vertex& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
  Vertex less_origin(const Vertex& a) const { return difference(a, origin_); }
  static double largest(const Vertex& a) { return maximum_of_defined(std::abs(a[0]), std::abs(a[1]), std::abs(a[2])); }
  static double determinant(const Vertex& a, const Vertex& b, const Vertex& c)
  {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }

  Vertex origin_, direction_;
  int exponent_;
  bool usable_ = true, scaled_exactly_ = true;
};

}  // namespace tetracone::kernel

#endif
