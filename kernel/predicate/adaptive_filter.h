#ifndef TETRACONE_KERNEL_PREDICATE_ADAPTIVE_FILTER_H
#define TETRACONE_KERNEL_PREDICATE_ADAPTIVE_FILTER_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/vertex.h"
#include "tetracone/kernel/predicate/adaptive_points.h"

#include <CGAL/enum.h>

#include <cmath>

namespace tetracone::kernel {

/// The filter stage: the expression in double on the images. It decides when the value is beyond its error bound.
class Adaptive_filter : public Adaptive_points {
 public:
  // With a^ = fl(p^ - p0^) the computed differences, m_k >= |a^_jk| and d >= error(p) + error(p0), the exact difference
  // a satisfies |a_jk - a^_jk| <= u |a^_jk| + d. The bounds of adaptive_bounds.h replace a^ by a in each product, one
  // factor after the other. A comparison with an infinite bound or NaN is false: undecided.

  /// Returns the sign of det[b-a, c-a, d-a], or undecided.
  static Decision filtered_volume_sign(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d)
  {
    return filtered_volume_sign(a.image, b.image, c.image, d.image, a.error + maximum(b.error, c.error, d.error));
  }
  static Decision filtered_volume_sign(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d, double error)
  {
    const Vertex p = difference(b, a), q = difference(c, a), r = difference(d, a);
    const auto largest = [&](int k) { return maximum_of_defined(std::abs(p[k]), std::abs(q[k]), std::abs(r[k])); };
    return beyond(determinant(p, q, r), adaptive_bound::volume_bound(largest(0), largest(1), largest(2), error));
  }

  /// Returns the sign of (b-a) x (c-a) in the component `axis`, or undecided.
  static Decision filtered_normal_sign(const Point_3& a, const Point_3& b, const Point_3& c, int axis)
  {
    return filtered_normal_sign(a.image, b.image, c.image, axis, a.error + maximum(b.error, c.error));
  }
  static Decision filtered_normal_sign(const Vertex& a, const Vertex& b, const Vertex& c, int axis, double error)
  {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    const double bi = b[i] - a[i], bj = b[j] - a[j], ci = c[i] - a[i], cj = c[j] - a[j];
    const double mi = maximum_of_defined(std::abs(bi), std::abs(ci)),
                 mj = maximum_of_defined(std::abs(bj), std::abs(cj));
    return beyond(cross_component(bi, bj, ci, cj), adaptive_bound::normal_bound(mi, mj, error));
  }

  /// Returns the sign of a[axis] - b[axis], or undecided. It is always decided where both errors are 0.
  static Decision filtered_difference_sign(const Point_3& a, const Point_3& b, int axis)
  {
    const double error = a.error + b.error;
    if (error == 0) return CGAL::sign(a.image[axis] - b.image[axis]);
    return beyond(a.image[axis] - b.image[axis], adaptive_bound::difference_bound(error));
  }
};

}  // namespace tetracone::kernel

#endif
