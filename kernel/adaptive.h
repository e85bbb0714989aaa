#ifndef TETRACONE_KERNEL_ADAPTIVE_H
#define TETRACONE_KERNEL_ADAPTIVE_H

#include "kernel/floating_point.h"
#include "kernel/number.h"
#include "kernel/pose.h"

#include <CGAL/Mpzf.h>
#include <CGAL/predicates/sign_of_determinant.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace tetracone::kernel {

/// The adaptive kernel: exact signs of points under exact motion, at nearly the price of double.
///
/// A point is a vertex and the pose that places it; its image is never rounded, only approximated: `image` and `error`
/// enclose it. A sign is decided by the first stage that can:
///   1. filter: the double expression on the images, when it is beyond the bound on all rounding (or undecided);
///   2. exact: the expression over the exact images, in CGAL::Mpzf (poses of doubles) or Rational (poses of fractions).
/// Signs of points that share one pose are signs of the vertices themselves, times sign(det M).
class Adaptive {
 public:
  struct Point_3 {
    std::array<double, 3> image;   ///< the image, rounded
    double error;                  ///< per coordinate: |image - exact image| <= error; infinite: not known
    Vertex vertex;                 ///< the point before it was placed
    const Pose* pose;              ///< null: not placed, the image is the vertex; else outlives the point

    double x() const { return image[0]; }
    double y() const { return image[1]; }
    double z() const { return image[2]; }
  };

  /// Beyond this magnitude the filter is not asked: within it no expression of its overflows, and what gradual underflow
  /// loses, at most 2^-1074 a product times two factors below 2^112, is far below `underflow`.
  static constexpr double magnitude_gate = 0x1p110;
  static constexpr double underflow = 0x1p-800;

  /// `vertex` where it stands.
  static Point_3 unmoved(const Vertex& vertex)
  {
    return {vertex, magnitude(vertex) <= magnitude_gate ? 0 : std::numeric_limits<double>::infinity(), vertex, nullptr};
  }

  /// `vertex` placed by `pose`, which must outlive the point.
  ///
  /// Error of a coordinate, S = |m0 x| + |m1 y| + |m2 z| + |t|: the sum rounds each product once and each of three sums once,
  /// so at most 4 roundings a term, ((1+u)^4 - 1) S <= 4.001 u S; entries that are rounded rationals add 1.001 u S. S itself
  /// is computed with at most 4 roundings down. Hence 6 u S covers both. A fraction that is rounded to a denormal, or to 0, is off
  /// by 2^-1075 instead, which vertices within the gate keep far below `underflow`; beyond it the error is not known.
  static Point_3 placed(const Vertex& vertex, const Pose& pose)
  {
    Point_3 point{{}, 0, vertex, &pose};
    double largest = 0;
    for (int row = 0; row < 3; ++row) {
      const double a = pose[4 * row] * vertex[0], b = pose[4 * row + 1] * vertex[1], c = pose[4 * row + 2] * vertex[2],
                   t = pose[4 * row + 3];
      point.image[row] = ((a + b) + c) + t;
      largest = std::max(largest, ((std::abs(a) + std::abs(b)) + std::abs(c)) + std::abs(t));
    }
    const bool known = largest <= magnitude_gate && (!pose.is_rational() || magnitude(vertex) <= magnitude_gate);
    point.error = known ? 6 * unit_roundoff<double> * largest + underflow : std::numeric_limits<double>::infinity();
    return point;
  }

  /// How often the calling thread needed the exact stage.
  static std::uint64_t& exact_fallbacks()
  {
    static thread_local std::uint64_t count = 0;
    return count;
  }

  template <class Number>
  using Image = std::array<Number, 3>;  ///< an exact image

  using Decision = std::optional<CGAL::Sign>;  ///< nothing: undecided

  // --- filter -------------------------------------------------------------------------------------------------------
  // Let a^ = fl(p^ - p0^) be the computed differences, m_k >= |a^_jk| and d >= error(p) + error(p0), so that the exact
  // difference a satisfies |a_jk - a^_jk| <= u m_k (1+2u) + d and |a_jk| <= (m_k + d)(1+2u) =: M_k (1+2u). Then
  //   |det a^ computed - det a| <= 48 u (1+64u) Mx My Mz + 6 (1+64u) (d My Mz + mx d Mz + mx my d):
  // 48 = 6 products * (3 differences + 1 product + 1 minor + 1 product + 2 sums) roundings; the second term telescopes the
  // six exact products over the three replaced factors. The bound is itself computed with at most 12 roundings, which
  // 49 u and 6.001 absorb. A comparison with an infinite or undefined bound is false: undecided.
  // The tests derive every constant of this class again, in exact rationals, and pin the literals to what they derive from.

  /// The sign of det[b-a, c-a, d-a], or undecided.
  static Decision filtered_volume_sign(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d)
  {
    return filtered_volume_sign(a.image, b.image, c.image, d.image, a.error + std::max({b.error, c.error, d.error}));
  }
  static Decision filtered_volume_sign(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d, double error)
  {
    const double bx = b[0] - a[0], by = b[1] - a[1], bz = b[2] - a[2];
    const double cx = c[0] - a[0], cy = c[1] - a[1], cz = c[2] - a[2];
    const double dx = d[0] - a[0], dy = d[1] - a[1], dz = d[2] - a[2];
    const double determinant = (by * cz - bz * cy) * dx + (bz * cx - bx * cz) * dy + (bx * cy - by * cx) * dz;
    const double mx = std::max({std::abs(bx), std::abs(cx), std::abs(dx)});
    const double my = std::max({std::abs(by), std::abs(cy), std::abs(dy)});
    const double mz = std::max({std::abs(bz), std::abs(cz), std::abs(dz)});
    const double Mx = mx + error, My = my + error, Mz = mz + error;
    const double bound = 49 * unit_roundoff<double> * (Mx * My * Mz) +
                         6.001 * error * (My * Mz + mx * Mz + mx * my) + underflow;
    return beyond(determinant, bound);
  }

  /// The sign of (b-a) x (c-a) in the component `axis`, or undecided. Bound by the same count: 2 products * (2 differences +
  /// 1 product + 1 sum) = 8 roundings, and two replaced factors.
  static Decision filtered_normal_sign(const Point_3& a, const Point_3& b, const Point_3& c, int axis)
  {
    return filtered_normal_sign(a.image, b.image, c.image, axis, a.error + std::max(b.error, c.error));
  }
  static Decision filtered_normal_sign(const Vertex& a, const Vertex& b, const Vertex& c, int axis, double error)
  {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    const double bi = b[i] - a[i], bj = b[j] - a[j], ci = c[i] - a[i], cj = c[j] - a[j];
    const double mi = std::max(std::abs(bi), std::abs(ci)), mj = std::max(std::abs(bj), std::abs(cj));
    const double bound = 9 * unit_roundoff<double> * ((mi + error) * (mj + error)) +
                         2.001 * error * ((mj + error) + mi) + underflow;
    return beyond(bi * cj - bj * ci, bound);
  }

  /// The sign of a[axis] - b[axis], or undecided.
  static Decision filtered_difference_sign(const Point_3& a, const Point_3& b, int axis)
  {
    const double error = a.error + b.error;
    if (error == 0) return CGAL::sign(a.image[axis] - b.image[axis]);
    return beyond(a.image[axis] - b.image[axis], 1.001 * error);
  }

  // --- identity -----------------------------------------------------------------------------------------------------

  /// True when the two are one vertex under one pose. Unequal ones may still have the same image.
  static bool identical(const Point_3& a, const Point_3& b) { return a.pose == b.pose && a.vertex == b.vertex; }

  // --- exact --------------------------------------------------------------------------------------------------------

  static CGAL::Sign exact_volume_sign(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d)
  {
    return over_exact_images(
        []<class N>(const Image<N>& p, const Image<N>& q, const Image<N>& r, const Image<N>& s) {
          return CGAL::sign_of_determinant<N>(q[0] - p[0], q[1] - p[1], q[2] - p[2],  //
                                              r[0] - p[0], r[1] - p[1], r[2] - p[2],  //
                                              s[0] - p[0], s[1] - p[1], s[2] - p[2]);
        },
        a, b, c, d);
  }

  static CGAL::Sign exact_normal_sign(const Point_3& a, const Point_3& b, const Point_3& c, int axis)
  {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    return over_exact_images(
        [i, j]<class N>(const Image<N>& p, const Image<N>& q, const Image<N>& r) {
          return CGAL::sign_of_determinant<N>(q[i] - p[i], q[j] - p[j], r[i] - p[i], r[j] - p[j]);
        },
        a, b, c);
  }

  static CGAL::Sign exact_difference_sign(const Point_3& a, const Point_3& b, int axis)
  {
    return over_exact_images(
        [axis]<class N>(const Image<N>& p, const Image<N>& q) { return CGAL::sign(N(p[axis] - q[axis])); }, a, b);
  }

  // --- the kernel's signs -------------------------------------------------------------------------------------------

  static CGAL::Sign volume_sign(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d)
  {
    if (const Decision sign = filtered_volume_sign(a, b, c, d)) return *sign;
    if (identical(c, d) || identical(b, d) || identical(b, c) || identical(a, d) || identical(a, c) || identical(a, b)) return CGAL::ZERO;
    if (a.pose == b.pose && a.pose == c.pose && a.pose == d.pose && a.pose != nullptr) {
      const CGAL::Sign unplaced = volume_sign(unmoved(a.vertex), unmoved(b.vertex), unmoved(c.vertex), unmoved(d.vertex));
      return unplaced * a.pose->determinant_sign();
    }
    ++exact_fallbacks();
    return exact_volume_sign(a, b, c, d);
  }

  static CGAL::Sign normal_sign(const Point_3& a, const Point_3& b, const Point_3& c, int axis)
  {
    if (const Decision sign = filtered_normal_sign(a, b, c, axis)) return *sign;
    if (identical(b, c) || identical(a, c) || identical(a, b)) return CGAL::ZERO;
    ++exact_fallbacks();
    return exact_normal_sign(a, b, c, axis);
  }

  static CGAL::Sign difference_sign(const Point_3& a, const Point_3& b, int axis)
  {
    if (const Decision sign = filtered_difference_sign(a, b, axis)) return *sign;
    if (identical(a, b)) return CGAL::ZERO;
    ++exact_fallbacks();
    return exact_difference_sign(a, b, axis);
  }

 private:
  static double magnitude(const Vertex& v) { return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}); }

  static Decision beyond(double value, double bound)
  {
    if (value > bound) return CGAL::POSITIVE;
    if (value < -bound) return CGAL::NEGATIVE;
    return std::nullopt;
  }

  template <class Number>
  static Image<Number> exact_image(const Point_3& point)
  {
    const Vertex& v = point.vertex;
    if (point.pose == nullptr) return {Number(v[0]), Number(v[1]), Number(v[2])};
    const auto entry = [&pose = *point.pose](int k) {
      if constexpr (std::is_same_v<Number, Rational>)
        return pose.exact(k);
      else
        return Number(pose[k]);
    };
    const auto row = [&](int i) -> Number {
      return entry(4 * i) * Number(v[0]) + entry(4 * i + 1) * Number(v[1]) + entry(4 * i + 2) * Number(v[2]) + entry(4 * i + 3);
    };
    return {row(0), row(1), row(2)};
  }

  // Poses of doubles keep every image a binary fraction: the ring Mpzf is enough. Poses of fractions need the field.
  template <class Function, class... Points>
  static CGAL::Sign over_exact_images(const Function& function, const Points&... points)
  {
    const auto fractional = [](const Point_3& point) { return point.pose != nullptr && point.pose->is_rational(); };
    if ((fractional(points) || ...)) return function(exact_image<Rational>(points)...);
    return function(exact_image<CGAL::Mpzf>(points)...);
  }
};

}  // namespace tetracone::kernel

#endif
