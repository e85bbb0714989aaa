#ifndef TETRACONE_KERNEL_PREDICATE_ADAPTIVE_DOUBLE_DOUBLE_H
#define TETRACONE_KERNEL_PREDICATE_ADAPTIVE_DOUBLE_DOUBLE_H

#include "tetracone/kernel/number/double_double.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/adaptive_points.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace tetracone::kernel {

/// The double-double stage: the expression on images of twice the digits, for images that the fixed stage finds too
/// wide. It decides when the value is beyond its bound.
class Adaptive_double_double : public Adaptive_points {
 public:
  // The expressions are the filter's, and so are the bounds except for their constants (adaptive_bounds.h). A
  // difference of images is rounded too, so its error is the images' errors and a fraction of itself. All bounds are
  // computed in double and judge the high part, whose relative error is u.

  /// Returns the image of a point, which its slot keeps if it has one.
  static Double_double_image kept_double_double_image(const Point_3& point)
  {
    if (point.slot == nullptr) return double_double_image(point);
    std::optional<Double_double_image>& image = kept(point).double_double;
    if (!image) image = double_double_image(point);
    return *image;
  }

  /// Computes the image of a point in double-double, and the bound of its error.
  static Double_double_image double_double_image(const Point_3& point)
  {
    Double_double_image image{{}, 0};
    if (point.pose == nullptr) {
      for (int k = 0; k < 3; ++k) image.coordinate[k] = point.vertex[k];
      image.error = point.error;
      return image;
    }
    const Pose& pose = *point.pose;
    double largest = 0;
    for (int row = 0; row < 3; ++row) {
      const auto term = [&](int k) {
        const Double_double entry = pose.double_double(4 * row + k);
        return entry.low == 0 ? Double_double::product(entry.high, point.vertex[k])
                              : entry * Double_double(point.vertex[k]);
      };
      const auto magnitude = [&](int k) { return std::abs(pose[4 * row + k] * point.vertex[k]); };
      image.coordinate[row] = sum(std::array{pose.double_double(4 * row + 3), term(0), term(1), term(2)});
      largest =
          maximum(largest, sum(std::array{std::abs(pose[4 * row + 3]), magnitude(0), magnitude(1), magnitude(2)}));
    }
    image.error = point.error <= std::numeric_limits<double>::max() ? adaptive_bound::double_double_image_bound(largest)
                                                                    : point.error;
    return image;
  }

  /// Returns the sign of det[b-a, c-a, d-a], or undecided.
  static Decision double_double_volume_sign(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d)
  {
    const std::array<Double_double_image, 4> p = {kept_double_double_image(a), kept_double_double_image(b),
                                                  kept_double_double_image(c), kept_double_double_image(d)};
    std::array<std::array<Double_double, 3>, 3> m;
    std::array<double, 3> largest{0, 0, 0};
    for (int j = 0; j < 3; ++j) {
      m[j] = difference(p[j + 1].coordinate, p[0].coordinate);
      for (int k = 0; k < 3; ++k) largest[k] = maximum(largest[k], std::abs(m[j][k].high));
    }
    const double images = p[0].error + maximum(p[1].error, p[2].error, p[3].error);
    std::array<double, 3> error;
    for (int k = 0; k < 3; ++k) error[k] = adaptive_bound::double_double_difference_error(images, largest[k]);
    return beyond(determinant(m[0], m[1], m[2]).high, adaptive_bound::double_double_volume_bound(largest, error));
  }

  /// Returns the sign of (b-a) x (c-a) in the component `axis`, or undecided.
  static Decision double_double_normal_sign(const Point_3& a, const Point_3& b, const Point_3& c, int axis)
  {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    const Double_double_image p = kept_double_double_image(a), q = kept_double_double_image(b),
                              r = kept_double_double_image(c);
    const Double_double bi = q.coordinate[i] - p.coordinate[i], bj = q.coordinate[j] - p.coordinate[j];
    const Double_double ci = r.coordinate[i] - p.coordinate[i], cj = r.coordinate[j] - p.coordinate[j];
    const double mi = maximum(std::abs(bi.high), std::abs(ci.high)), mj = maximum(std::abs(bj.high), std::abs(cj.high));
    const double images = p.error + maximum(q.error, r.error);
    const double ei = adaptive_bound::double_double_difference_error(images, mi),
                 ej = adaptive_bound::double_double_difference_error(images, mj);
    return beyond(cross_component(bi, bj, ci, cj).high, adaptive_bound::double_double_normal_bound(mi, mj, ei, ej));
  }

  /// Returns the sign of a[axis] - b[axis], or undecided.
  static Decision double_double_difference_sign(const Point_3& a, const Point_3& b, int axis)
  {
    const Double_double_image p = kept_double_double_image(a), q = kept_double_double_image(b);
    const double difference = (p.coordinate[axis] - q.coordinate[axis]).high, images = p.error + q.error;
    const double error = adaptive_bound::double_double_difference_error(images, std::abs(difference));
    return beyond(difference, adaptive_bound::difference_bound(error));
  }
};

}  // namespace tetracone::kernel

#endif
