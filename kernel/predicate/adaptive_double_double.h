#ifndef TETRACONE_KERNEL_PREDICATE_ADAPTIVE_DOUBLE_DOUBLE_H
#define TETRACONE_KERNEL_PREDICATE_ADAPTIVE_DOUBLE_DOUBLE_H

#include "tetracone/kernel/number/double_double.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/adaptive_points.h"

#include <array>
#include <cmath>
#include <limits>

namespace tetracone::kernel {

/// Double-double: the expression on images of twice the digits, decided when it is beyond its bound.
class Adaptive_double_double : public Adaptive_points {
 public:
  // With u = 2^-53 an image is three exact products and three additions, each of relative error 3 u^2 (1 + 5u) of a
  // partial sum below S: 9 u^2 S; a fraction's entry is itself off by u^2, and its product by 7 u^2, of a term, 17 u^2
  // S in all: `error` = 20 u^2 S covers both. Differences are rounded by 3 u^2 m; so with d = 3.02 u^2 m + the errors
  // of the two images the bounds are those of the filter, with 7 + 3 + 7 + 3 + 3 = 23 roundings of u^2 on four of the
  // six products and 20 on the two that are added last, 132 u^2, and 7 + 3 on each of two products, 20 u^2. All bounds
  // are computed in double, as before, and judge the high part, which is off by u of itself. The tests derive these
  // constants too, and record how much of each bound is used.

  /// An image of twice the digits.
  struct Double_double_image {
    std::array<Double_double, 3> coordinate;
    double error;  ///< per coordinate; infinite: not known
  };

  static Double_double_image double_double_image(const Point_3& point)
  {
    Double_double_image image{{}, 0};
    if (point.pose == nullptr) {
      for (int k = 0; k < 3; ++k) image.coordinate[k] = point.vertex[k];
      image.error = point.error;
      return image;
    }
    const Pose& pose = *point.pose;
    constexpr double u = unit_roundoff<double>;
    double largest = 0;
    for (int row = 0; row < 3; ++row) {
      Double_double sum = pose.double_double(4 * row + 3);
      double magnitude = std::abs(pose[4 * row + 3]);
      for (int k = 0; k < 3; ++k) {
        const Double_double entry = pose.double_double(4 * row + k);
        sum = sum + (entry.low == 0 ? Double_double::product(entry.high, point.vertex[k])
                                    : entry * Double_double(point.vertex[k]));
        magnitude += std::abs(entry.high * point.vertex[k]);
      }
      image.coordinate[row] = sum;
      largest = maximum(largest, magnitude);
    }
    image.error = point.error <= std::numeric_limits<double>::max() ? 20 * u * u * largest + underflow : point.error;
    return image;
  }

  /// The sign of det[b-a, c-a, d-a], or undecided.
  static Decision double_double_volume_sign(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d)
  {
    constexpr double u2 = unit_roundoff<double> * unit_roundoff<double>;
    const std::array<Double_double_image, 4> p = {double_double_image(a), double_double_image(b),
                                                  double_double_image(c), double_double_image(d)};
    std::array<std::array<Double_double, 3>, 3> m;
    std::array<double, 3> largest{0, 0, 0};
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) {
        m[j][k] = p[j + 1].coordinate[k] - p[0].coordinate[k];
        largest[k] = maximum(largest[k], std::abs(m[j][k].high));
      }
    const Double_double determinant = (m[0][1] * m[1][2] - m[0][2] * m[1][1]) * m[2][0] +
                                      (m[0][2] * m[1][0] - m[0][0] * m[1][2]) * m[2][1] +
                                      (m[0][0] * m[1][1] - m[0][1] * m[1][0]) * m[2][2];
    const double images = p[0].error + maximum(p[1].error, p[2].error, p[3].error);
    std::array<double, 3> error, M;
    for (int k = 0; k < 3; ++k) {
      error[k] = images + 3.02 * u2 * largest[k];
      M[k] = largest[k] + error[k];
    }
    const double bound =
        146 * u2 * (M[0] * M[1] * M[2]) +
        6.001 * (error[0] * (M[1] * M[2]) + largest[0] * error[1] * M[2] + largest[0] * largest[1] * error[2]) +
        underflow;
    return beyond(determinant.high, bound);
  }

  /// The sign of (b-a) x (c-a) in the component `axis`, or undecided.
  static Decision double_double_normal_sign(const Point_3& a, const Point_3& b, const Point_3& c, int axis)
  {
    constexpr double u2 = unit_roundoff<double> * unit_roundoff<double>;
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    const Double_double_image p = double_double_image(a), q = double_double_image(b), r = double_double_image(c);
    const Double_double bi = q.coordinate[i] - p.coordinate[i], bj = q.coordinate[j] - p.coordinate[j];
    const Double_double ci = r.coordinate[i] - p.coordinate[i], cj = r.coordinate[j] - p.coordinate[j];
    const double mi = maximum(std::abs(bi.high), std::abs(ci.high)), mj = maximum(std::abs(bj.high), std::abs(cj.high));
    const double images = p.error + maximum(q.error, r.error);
    const double ei = images + 3.02 * u2 * mi, ej = images + 3.02 * u2 * mj;
    const double bound = 22 * u2 * ((mi + ei) * (mj + ej)) + 2.001 * (ei * (mj + ej) + mi * ej) + underflow;
    return beyond((bi * cj - bj * ci).high, bound);
  }

  /// The sign of a[axis] - b[axis], or undecided.
  static Decision double_double_difference_sign(const Point_3& a, const Point_3& b, int axis)
  {
    constexpr double u2 = unit_roundoff<double> * unit_roundoff<double>;
    const Double_double_image p = double_double_image(a), q = double_double_image(b);
    const double difference = (p.coordinate[axis] - q.coordinate[axis]).high;
    return beyond(difference, 1.001 * (p.error + q.error + 3.02 * u2 * std::abs(difference)));
  }
};

}  // namespace tetracone::kernel

#endif
