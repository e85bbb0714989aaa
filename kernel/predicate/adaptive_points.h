#ifndef TETRACONE_KERNEL_PREDICATE_ADAPTIVE_POINTS_H
#define TETRACONE_KERNEL_PREDICATE_ADAPTIVE_POINTS_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/number/vertex.h"
#include "tetracone/kernel/predicate/adaptive_bounds.h"
#include "tetracone/kernel/predicate/kept_images.h"

#include <CGAL/enum.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

namespace tetracone::kernel {

/// The points of the adaptive kernel, each a vertex and the pose that places it. `image` and `error` enclose the exact
/// image. All signs hold for the exact images.
class Adaptive_points {
 public:
  using Decision = std::optional<CGAL::Sign>;  ///< nothing: undecided

  struct Point_3 {
    std::array<double, 3> image;  ///< the image, rounded
    double error;                 ///< per coordinate: |image - exact image| <= error; infinite: not known
    Vertex vertex;                ///< the point before it was placed
    const Pose* pose;             ///< null: not placed, the image is the vertex; else outlives the point
    std::unique_ptr<Kept_images>* slot = nullptr;  ///< where further images are kept once they have been asked for;
                                                   ///< null: nowhere

    double x() const { return image[0]; }
    double y() const { return image[1]; }
    double z() const { return image[2]; }
  };

  /// Returns `vertex` unmoved.
  static Point_3 unmoved(const Vertex& vertex)
  {
    return {vertex, magnitude(vertex) <= magnitude_gate ? 0 : std::numeric_limits<double>::infinity(), vertex, nullptr};
  }

  /// Returns `vertex` placed by `pose`, which must outlive the point.
  ///
  /// Its error is `adaptive_bound::image_bound` of the largest sum of its terms' magnitudes. A fraction that is rounded
  /// to a denormal, or to 0, has an error of 2^-1075 instead. For vertices within the gate that stays far below
  /// `underflow_slack`. The error is not known where that sum, or a vertex under a pose of fractions, is beyond the
  /// gate.
  static Point_3 placed(const Vertex& vertex, const Pose& pose)
  {
    if (pose.is_translation()) return translated(vertex, pose);
    Point_3 point{{}, 0, vertex, &pose};
    double largest = 0;
    for (int row = 0; row < 3; ++row) {
      const auto terms = placed_terms(pose[4 * row], pose[4 * row + 1], pose[4 * row + 2], pose[4 * row + 3], vertex);
      point.image[row] = sum(terms);
      largest = maximum(largest, sum_of_magnitudes(terms));
    }
    const bool known = largest <= magnitude_gate && (!pose.is_rational() || magnitude(vertex) <= magnitude_gate);
    point.error = known ? adaptive_bound::image_bound(largest) : std::numeric_limits<double>::infinity();
    return point;
  }

  /// Returns the image under a pose that only translates: one sum a coordinate. Its relative error is at most u. It is
  /// exact where TwoSum's (Knuth) remainder is 0.
  static Point_3 translated(const Vertex& vertex, const Pose& pose)
  {
    Point_3 point{{}, 0, vertex, &pose};
    double largest = 0, terms = 0, lost = 0;
    for (int k = 0; k < 3; ++k) {
      const double v = vertex[k], t = pose[4 * k + 3], sum = v + t, of_t = sum - v;
      lost = maximum(lost, std::abs((v - (sum - of_t)) + (t - of_t)));
      point.image[k] = sum;
      largest = maximum(largest, std::abs(sum));
      terms = maximum(terms, std::abs(v), std::abs(t));
    }
    point.error = !(terms <= magnitude_gate) ? std::numeric_limits<double>::infinity()
                  : lost == 0                ? 0
                                             : adaptive_bound::translation * largest;
    return point;
  }

  /// True when the two are one vertex under one `Pose` object. Others may still have the same image.
  static bool identical(const Point_3& a, const Point_3& b) { return a.pose == b.pose && a.vertex == b.vertex; }

  /// True when no image is rounded.
  template <class... Points>
  static bool are_exact(const Points&... points)
  {
    return ((points.error == 0) && ...);
  }

  /// True when the errors of all points are known.
  template <class... Points>
  static bool in_gate(const Points&... points)
  {
    return ((points.error <= std::numeric_limits<double>::max()) && ...);
  }

 protected:
  /// Returns what is kept of a point that has a slot.
  static Kept_images& kept(const Point_3& point)
  {
    if (!*point.slot) *point.slot = std::make_unique<Kept_images>();
    return **point.slot;
  }

  static double magnitude(const Vertex& v) { return maximum(std::abs(v[0]), std::abs(v[1]), std::abs(v[2])); }

  /// Returns the sign of the number that `value` approximates to within `bound`, or undecided. NaN is undecided.
  static Decision beyond(double value, double bound)
  {
    if (value > bound) return CGAL::POSITIVE;
    if (value < -bound) return CGAL::NEGATIVE;
    return std::nullopt;
  }
};

}  // namespace tetracone::kernel

#endif
