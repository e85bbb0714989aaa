#ifndef TETRACONE_KERNEL_PREDICATE_RAY_TRIANGLE_H
#define TETRACONE_KERNEL_PREDICATE_RAY_TRIANGLE_H

#include "tetracone/kernel/number/double_double.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/number/vertex.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

namespace tetracone::kernel {

/// A ray o + t d, t >= 0, against triangles: a filter in double, which answers uncertain rather than guess, and t
/// rounded correctly by double-double.
///
/// Let A, B, C be the corners less o and n = (B - A) x (C - A). Then t = N / D with N = n . A and D = n . d. The signs
/// of det[d, A, B] and so on tell on which side d passes each edge. The sum of these determinants is D. d is scaled by
/// a power of two to components of at most 2, one of at least 1; below, t belongs to the scaled d.
class Ray_triangle {
 public:
  /// Whether the ray meets a triangle; `yes` only in its inside.
  enum class Meets { no, yes, uncertain };

  /// A decision about a triangle. `low` and `high` enclose the scaled t where the ray meets the triangle's inside.
  struct Decision {
    Meets meets = Meets::uncertain;
    double low = 0, high = 0;
  };

  /// Requires finite numbers and d != 0.
  Ray_triangle(const Vertex& origin, const Vertex& direction) : origin_(origin)
  {
    double largest = 0;
    for (const double x : direction) largest = maximum(largest, std::abs(x));
    const bool is_common = largest >= 0x1p-1000 && largest < 0x1p1001;  // then both powers of two are doubles
    exponent_ = is_common ? exponent_of(largest) : std::ilogb(largest);
    const double scale = is_common ? power_of_two(-exponent_) : 0, back = is_common ? power_of_two(exponent_) : 0;
    for (int k = 0; k < 3; ++k) {
      direction_[k] = is_common ? direction[k] * scale : std::scalbn(direction[k], -exponent_);
      scaled_exactly_ = scaled_exactly_ && is_common && direction_[k] * back == direction[k];
      usable_ = usable_ && std::abs(origin[k]) <= 0x1p250;
    }
  }

  /// Return the scaled direction, and the exponent of the power of two by which d was divided.
  const Vertex& direction() const { return direction_; }
  int exponent() const { return exponent_; }

  /// Upper bound of the error of a determinant past an edge, relative to M^2, M the largest |A_k|, |B_k|, |C_k|
  /// (verify/proofs/ray_proofs.h). It sums six products of at most 2 M^2, rounded seven times each with its
  /// differences.
  static constexpr double side_rounding = 0x1p-46;

  /// Upper bound of the errors of N and of t D, relative to S^2 M, S the largest component of an edge
  /// (verify/proofs/ray_proofs.h). N sums six products of at most S^2 M, rounded eight times; D six of 2 S^2, seven
  /// times. t is at most M where the ray meets the triangle, for |t d_k| <= M.
  static constexpr double plane_rounding = 0x1p-45;

  /// Upper bound of the relative error of the ends of a time's enclosure: a difference or a sum, a quotient and a
  /// product (verify/proofs/ray_proofs.h).
  static constexpr double time_rounding = 0x1p-50;

  /// Returns the decision about a triangle. Requires corners within 2^250. Underflow is negligible beside the bounds.
  /// Where the ray meets the triangle, D >= N / M. So D as computed is positive where N is above its bound.
  Decision operator()(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    const Vertex A = difference(a, origin_), B = difference(b, origin_), C = difference(c, origin_);
    const double M = maximum(largest(A), largest(B), largest(C));
    if (!usable_ || !(M >= 0x1p-300)) return {};
    const double limit = side_rounding * M * M;
    const double ab = determinant(A, B, direction_), bc = determinant(B, C, direction_),
                 ca = determinant(C, A, direction_);
    // There is no branch except the last, since the processor could not predict it.
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
    const double N = determinant(p, q, A) * turn, D = determinant(p, q, direction_) * turn,
                 error = plane_rounding * S * S * M;
    if (N < -error) return {Meets::no};
    if (!(N > error)) return {};
    return {Meets::yes, (N - error) / D * (1 - time_rounding), (N + error) / D * (1 + time_rounding)};
  }

  // Upper bounds of errors in double-double, proved in verify/proofs/ray_proofs.h.
  static constexpr double height_rounding = 0x1p-97,  ///< of N, relative to S^2 M: six products of at most S^2 M
      slope_rounding = 0x1p-96,                       ///< of D, relative to S^2: six products of at most 2 S^2
      quotient_rounding = 0x1p-98;  ///< of the quotient, relative to it: its remainder, and its correction in double

  /// Returns the double nearest to the t of the ray as it was given, where double-double decides it. Requires a ray
  /// that meets the triangle's plane in one point. Differences of doubles are exact here.
  std::optional<double> rounded(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    using Wide_vector = std::array<Double_double, 3>;
    const auto exact = [](const Vertex& x, const Vertex& y) {
      return Wide_vector{Double_double::sum(x[0], -y[0]), Double_double::sum(x[1], -y[1]),
                         Double_double::sum(x[2], -y[2])};
    };
    const Wide_vector A = exact(a, origin_), p = exact(b, a), q = exact(c, a), normal = cross(p, q);
    const Double_double N = dot(normal, A), D = dot(normal, Wide_vector{direction_[0], direction_[1], direction_[2]});
    double S = 0, M = 0;
    for (int k = 0; k < 3; ++k) {
      S = maximum(S, std::abs(p[k].high), std::abs(q[k].high));
      M = maximum(M, std::abs(A[k].high));
    }
    if (!usable_ || !scaled_exactly_ || !(S * S * M >= 0x1p-700) || !(S >= 0x1p-300)) return std::nullopt;
    const double quotient = N.high / D.high;
    const Double_double rest = N - Double_double(quotient) * D;
    const double correction = rest.high / D.high;
    const double error = std::abs(quotient) * (height_rounding * S * S * M / std::abs(N.high) +
                                               slope_rounding * S * S / std::abs(D.high) + quotient_rounding);
    const double below = quotient + (correction - error), above = quotient + (correction + error);
    const double t = below * power_of_two(-exponent_);
    if (!(below == above) || !(std::abs(t) >= 0x1p-1000 && std::abs(t) <= 0x1p1000)) return std::nullopt;
    return t;
  }

 private:
  /// Return the exponent of a positive normal double, and a power of two. `std::ilogb` and `std::ldexp` would take
  /// longer than the rest of the filter's constructor.
  static int exponent_of(double x) { return int(std::bit_cast<std::uint64_t>(x) >> 52) - 1023; }
  static double power_of_two(int exponent) { return std::bit_cast<double>(std::uint64_t(1023 + exponent) << 52); }
  static double largest(const Vertex& a) { return maximum_of_defined(std::abs(a[0]), std::abs(a[1]), std::abs(a[2])); }

  Vertex origin_, direction_;
  int exponent_;
  bool usable_ = true, scaled_exactly_ = true;
};

}  // namespace tetracone::kernel

#endif
