#ifndef TETRACONE_KERNEL_PREDICATE_ADAPTIVE_FILTER_H
#define TETRACONE_KERNEL_PREDICATE_ADAPTIVE_FILTER_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/vertex.h"
#include "tetracone/kernel/predicate/adaptive_points.h"

#include <CGAL/enum.h>

#include <cmath>

namespace tetracone::kernel {

/// The filter: the double expression on the images, decided when it is beyond the bound on all rounding.
class Adaptive_filter : public Adaptive_points {
 public:
  // Let a^ = fl(p^ - p0^) be the computed differences, m_k >= |a^_jk| and d >= error(p) + error(p0), so that the exact
  // difference a satisfies |a_jk - a^_jk| <= u m_k (1+2u) + d and |a_jk| <= (m_k + d)(1+2u) =: M_k (1+2u). Then
  //   |det a^ computed - det a| <= 48 u (1+64u) Mx My Mz + 6 (1+64u) (d My Mz + mx d Mz + mx my d):
  // 48 = 6 products * (3 differences + 1 product + 1 minor + 1 product + 2 sums) roundings; the second term telescopes
  // the six exact products over the three replaced factors. The bound is itself computed with at most 12 roundings,
  // which 49 u and 6.001 absorb. A comparison with an infinite or undefined bound is false: undecided. The tests derive
  // every constant of this class again, in exact rationals, and pin the literals to what they derive from.
  static constexpr double volume_rounding = 49 * unit_roundoff<double>, volume_motion = 6.001;

  /// The sign of det[b-a, c-a, d-a], or undecided.
  static Decision filtered_volume_sign(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d)
  {
    return filtered_volume_sign(a.image, b.image, c.image, d.image, a.error + maximum(b.error, c.error, d.error));
  }
  static Decision filtered_volume_sign(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d, double error)
  {
    const double bx = b[0] - a[0], by = b[1] - a[1], bz = b[2] - a[2];
    const double cx = c[0] - a[0], cy = c[1] - a[1], cz = c[2] - a[2];
    const double dx = d[0] - a[0], dy = d[1] - a[1], dz = d[2] - a[2];
    const double determinant = (by * cz - bz * cy) * dx + (bz * cx - bx * cz) * dy + (bx * cy - by * cx) * dz;
    const double mx = maximum_of_defined(std::abs(bx), std::abs(cx), std::abs(dx));
    const double my = maximum_of_defined(std::abs(by), std::abs(cy), std::abs(dy));
    const double mz = maximum_of_defined(std::abs(bz), std::abs(cz), std::abs(dz));
    const double Mx = mx + error, My = my + error, Mz = mz + error;
    const double bound =
        volume_rounding * (Mx * My * Mz) + volume_motion * error * (My * Mz + mx * Mz + mx * my) + underflow;
    return beyond(determinant, bound);
  }

  /// The sign of (b-a) x (c-a) in the component `axis`, or undecided. Bound by the same count: 2 products * (2
  /// differences + 1 product + 1 sum) = 8 roundings, and two replaced factors.
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
    const double bound =
        9 * unit_roundoff<double> * ((mi + error) * (mj + error)) + 2.001 * error * ((mj + error) + mi) + underflow;
    return beyond(bi * cj - bj * ci, bound);
  }

  /// The sign of a[axis] - b[axis], or undecided.
  static Decision filtered_difference_sign(const Point_3& a, const Point_3& b, int axis)
  {
    const double error = a.error + b.error;
    if (error == 0) return CGAL::sign(a.image[axis] - b.image[axis]);
    return beyond(a.image[axis] - b.image[axis], 1.001 * error);
  }
};

}  // namespace tetracone::kernel

#endif
