#ifndef TETRACONE_KERNEL_PREDICATE_ADAPTIVE_H
#define TETRACONE_KERNEL_PREDICATE_ADAPTIVE_H

#include "tetracone/kernel/number/double_double.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/int128_signs.h"
#include "tetracone/kernel/predicate/stage_counts.h"

#include <CGAL/Mpzf.h>
#include <CGAL/enum.h>
#include <CGAL/predicates/sign_of_determinant.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

namespace tetracone::kernel {

/// The adaptive kernel: exact signs of points under exact motion, at nearly the price of double.
///
/// A point is a vertex and the pose that places it; its image is never rounded, only approximated: `image` and `error`
/// enclose it. A sign is decided by the first stage that can:
///   1. filter: the double expression on the images, when it is beyond the bound on all rounding (or undecided);
///   2. zero exits: points that are the same vertex under the same pose, or exact coordinates where every product has a
///   factor 0;
///   3. grid: the expression in integers of 128 bits, where images are exact and whole numbers of a common power of two
///   (or undecided);
///   4. double-double: the same expression on images of twice the digits, when it is beyond its bound (or undecided);
///   5. exact: the expression over the exact images, in CGAL::Mpzf; poses of fractions are multiplied by their
///   denominators.
///      An image is found once a query for each vertex that asks for it.
/// A point whose error is not known, beyond the magnitude gate, goes from the zero exits straight to the exact stage.
/// Signs of points that share one pose are signs of the vertices themselves, times sign(det M).
class Adaptive {
 public:
  using Exact_image = std::array<CGAL::Mpzf, 3>;
  using Stage = Adaptive_stage;

  struct Point_3 {
    std::array<double, 3> image;  ///< the image, rounded
    double error;                 ///< per coordinate: |image - exact image| <= error; infinite: not known
    Vertex vertex;                ///< the point before it was placed
    const Pose* pose;             ///< null: not placed, the image is the vertex; else outlives the point
    std::unique_ptr<Exact_image>* slot = nullptr;  ///< where the exact image is kept once it has been asked for; null:
                                                   ///< nowhere

    double x() const { return image[0]; }
    double y() const { return image[1]; }
    double z() const { return image[2]; }
  };

  /// Beyond this magnitude the filter is not asked: within it no expression of its overflows, and what gradual
  /// underflow loses, at most 2^-1074 a product times two factors below 2^112, is far below `underflow`.
  static constexpr double magnitude_gate = 0x1p110;
  static constexpr double underflow = 0x1p-800;

  /// `vertex` where it stands.
  static Point_3 unmoved(const Vertex& vertex)
  {
    return {vertex, magnitude(vertex) <= magnitude_gate ? 0 : std::numeric_limits<double>::infinity(), vertex, nullptr};
  }

  /// `vertex` placed by `pose`, which must outlive the point.
  ///
  /// Error of a coordinate, S = |m0 x| + |m1 y| + |m2 z| + |t|: the sum rounds each product once and each of three sums
  /// once, so at most 4 roundings a term, ((1+u)^4 - 1) S <= 4.001 u S; entries that are rounded rationals add 1.001 u
  /// S. S itself is computed with at most 4 roundings down. Hence 6 u S covers both. A fraction that is rounded to a
  /// denormal, or to 0, is off by 2^-1075 instead, which vertices within the gate keep far below `underflow`; beyond it
  /// the error is not known.
  static Point_3 placed(const Vertex& vertex, const Pose& pose)
  {
    if (pose.is_translation()) return translated(vertex, pose);
    Point_3 point{{}, 0, vertex, &pose};
    double largest = 0;
    for (int row = 0; row < 3; ++row) {
      const double a = pose[4 * row] * vertex[0], b = pose[4 * row + 1] * vertex[1], c = pose[4 * row + 2] * vertex[2],
                   t = pose[4 * row + 3];
      point.image[row] = ((a + b) + c) + t;
      largest = maximum(largest, ((std::abs(a) + std::abs(b)) + std::abs(c)) + std::abs(t));
    }
    const bool known = largest <= magnitude_gate && (!pose.is_rational() || magnitude(vertex) <= magnitude_gate);
    point.error = known ? 6 * unit_roundoff<double> * largest + underflow : std::numeric_limits<double>::infinity();
    return point;
  }

  /// The image under a pose that only translates: one sum a coordinate. Relative error u; exact where TwoSum's (Knuth)
  /// remainder is 0.
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
                                             : 1.001 * unit_roundoff<double> * largest;
    return point;
  }

  /// The signs of the calling thread, by the stage that decided.
  static Stage_counts& decided_by()
  {
    static thread_local Stage_counts counts;
    return counts;
  }
  /// How often the calling thread needed the exact stage.
  static std::uint64_t exact_fallbacks() { return decided_by()[Stage::exact] + decided_by()[Stage::out_of_gate]; }

  using Decision = std::optional<CGAL::Sign>;  ///< nothing: undecided

  // --- filter -------------------------------------------------------------------------------------------------------
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

  // --- zero exits ----------------------------------------------------------------------------------------------------

  /// True when the two are one vertex under one pose. Unequal ones may still have the same image.
  static bool identical(const Point_3& a, const Point_3& b) { return a.pose == b.pose && a.vertex == b.vertex; }

  /// ZERO where det[b-a, c-a, d-a] is 0 at sight, or undecided: two points are identical, or images are exact and each
  /// of the six products has a factor 0, as on a plane across an axis. A difference of doubles is 0 only when they are
  /// equal.
  static Decision zero_volume_sign(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d)
  {
    if (identical(c, d) || identical(b, d) || identical(b, c) || identical(a, d) || identical(a, c) || identical(a, b))
      return CGAL::ZERO;
    if (!are_exact(a, b, c, d)) return std::nullopt;
    const auto is_0 = [&a](const Point_3& p, int k) { return p.image[k] == a.image[k]; };
    const auto vanishes = [&](int i, int j, int k) { return is_0(b, i) || is_0(c, j) || is_0(d, k); };
    if (vanishes(0, 1, 2) && vanishes(1, 2, 0) && vanishes(2, 0, 1) && vanishes(0, 2, 1) && vanishes(1, 0, 2) &&
        vanishes(2, 1, 0))
      return CGAL::ZERO;
    return std::nullopt;
  }

  /// The sign of component `axis` of (b-a) x (c-a), where identity or zero factors decide it.
  static Decision zero_normal_sign(const Point_3& a, const Point_3& b, const Point_3& c, int axis)
  {
    if (identical(b, c) || identical(a, c) || identical(a, b)) return CGAL::ZERO;
    if (!are_exact(a, b, c)) return std::nullopt;
    const auto is_0 = [&a](const Point_3& p, int k) { return p.image[k] == a.image[k]; };
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    if ((is_0(b, i) || is_0(c, j)) && (is_0(b, j) || is_0(c, i))) return CGAL::ZERO;
    return std::nullopt;
  }

  // --- grid ------------------------------------------------------------------------------------------------------

  /// Exact, where images are exact and on a common grid; or undecided.
  static Decision int128_volume_sign(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d)
  {
    return are_exact(a, b, c, d) ? kernel::int128_volume_sign(a.image, b.image, c.image, d.image) : std::nullopt;
  }
  static Decision int128_normal_sign(const Point_3& a, const Point_3& b, const Point_3& c, int axis)
  {
    return are_exact(a, b, c) ? kernel::int128_normal_sign(a.image, b.image, c.image, axis) : std::nullopt;
  }

  // --- double-double ------------------------------------------------------------------------------------------------
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
    for (int k = 0; k < 3; ++k) error[k] = images + 3.02 * u2 * largest[k], M[k] = largest[k] + error[k];
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

  // --- exact --------------------------------------------------------------------------------------------------------

  static CGAL::Sign exact_volume_sign(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d)
  {
    return over_exact_images(
        [](const Exact_image& p, const Exact_image& q, const Exact_image& r, const Exact_image& s) {
          return CGAL::sign_of_determinant<CGAL::Mpzf>(q[0] - p[0], q[1] - p[1], q[2] - p[2],  //
                                                       r[0] - p[0], r[1] - p[1], r[2] - p[2],  //
                                                       s[0] - p[0], s[1] - p[1], s[2] - p[2]);
        },
        a, b, c, d);
  }

  static CGAL::Sign exact_normal_sign(const Point_3& a, const Point_3& b, const Point_3& c, int axis)
  {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    return over_exact_images(
        [i, j](const Exact_image& p, const Exact_image& q, const Exact_image& r) {
          return CGAL::sign_of_determinant<CGAL::Mpzf>(q[i] - p[i], q[j] - p[j], r[i] - p[i], r[j] - p[j]);
        },
        a, b, c);
  }

  static CGAL::Sign exact_difference_sign(const Point_3& a, const Point_3& b, int axis)
  {
    return over_exact_images(
        [axis](const Exact_image& p, const Exact_image& q) { return CGAL::sign(CGAL::Mpzf(p[axis] - q[axis])); }, a, b);
  }

  // --- the kernel's signs -------------------------------------------------------------------------------------------

  static CGAL::Sign volume_sign(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d)
  {
    if (const Decision sign = filtered_volume_sign(a, b, c, d)) return ++decided_by()[Stage::filter], *sign;
    return unfiltered_volume_sign(a, b, c, d);
  }
  static CGAL::Sign normal_sign(const Point_3& a, const Point_3& b, const Point_3& c, int axis)
  {
    if (const Decision sign = filtered_normal_sign(a, b, c, axis)) return ++decided_by()[Stage::filter], *sign;
    return unfiltered_normal_sign(a, b, c, axis);
  }
  static CGAL::Sign difference_sign(const Point_3& a, const Point_3& b, int axis)
  {
    if (const Decision sign = filtered_difference_sign(a, b, axis)) return ++decided_by()[Stage::filter], *sign;
    return unfiltered_difference_sign(a, b, axis);
  }

  // The same where the filter is known to be undecided. Out of line: the filter's callers are small then, and pay
  // nothing for its being counted.

  [[gnu::noinline]] static CGAL::Sign unfiltered_volume_sign(const Point_3& a, const Point_3& b, const Point_3& c,
                                                             const Point_3& d)
  {
    if (const Decision sign = zero_volume_sign(a, b, c, d)) return ++decided_by()[Stage::zero], *sign;
    if (a.pose == b.pose && a.pose == c.pose && a.pose == d.pose && a.pose != nullptr) {
      const CGAL::Sign unplaced =
          volume_sign(unmoved(a.vertex), unmoved(b.vertex), unmoved(c.vertex), unmoved(d.vertex));
      return unplaced * a.pose->determinant_sign();
    }
    if (!in_gate(a, b, c, d)) return ++decided_by()[Stage::out_of_gate], exact_volume_sign(a, b, c, d);
    if (const Decision sign = int128_volume_sign(a, b, c, d)) return ++decided_by()[Stage::grid], *sign;
    if (const Decision sign = double_double_volume_sign(a, b, c, d)) return ++decided_by()[Stage::double_double], *sign;
    ++decided_by()[Stage::exact];
    return exact_volume_sign(a, b, c, d);
  }

  [[gnu::noinline]] static CGAL::Sign unfiltered_normal_sign(const Point_3& a, const Point_3& b, const Point_3& c,
                                                             int axis)
  {
    if (const Decision sign = zero_normal_sign(a, b, c, axis)) return ++decided_by()[Stage::zero], *sign;
    if (!in_gate(a, b, c)) return ++decided_by()[Stage::out_of_gate], exact_normal_sign(a, b, c, axis);
    if (const Decision sign = int128_normal_sign(a, b, c, axis)) return ++decided_by()[Stage::grid], *sign;
    if (const Decision sign = double_double_normal_sign(a, b, c, axis))
      return ++decided_by()[Stage::double_double], *sign;
    ++decided_by()[Stage::exact];
    return exact_normal_sign(a, b, c, axis);
  }

  [[gnu::noinline]] static CGAL::Sign unfiltered_difference_sign(const Point_3& a, const Point_3& b, int axis)
  {
    if (identical(a, b)) return ++decided_by()[Stage::zero], CGAL::ZERO;
    if (!in_gate(a, b)) return ++decided_by()[Stage::out_of_gate], exact_difference_sign(a, b, axis);
    if (const Decision sign = double_double_difference_sign(a, b, axis))
      return ++decided_by()[Stage::double_double], *sign;
    ++decided_by()[Stage::exact];
    return exact_difference_sign(a, b, axis);
  }

  /// Whether no image is rounded.
  template <class... Points>
  static bool are_exact(const Points&... points)
  {
    return ((points.error == 0) && ...);
  }

  /// Whether the errors of all points are known.
  template <class... Points>
  static bool in_gate(const Points&... points)
  {
    return ((points.error <= std::numeric_limits<double>::max()) && ...);
  }

 private:
  static double magnitude(const Vertex& v) { return maximum(std::abs(v[0]), std::abs(v[1]), std::abs(v[2])); }

  static Decision beyond(double value, double bound)
  {
    if (value > bound) return CGAL::POSITIVE;
    if (value < -bound) return CGAL::NEGATIVE;
    return std::nullopt;
  }

  /// The exact image times the weight of the pose: binary fractions. Kept in the point's slot, where it has one.
  static Exact_image exact_image(const Point_3& point)
  {
    if (point.slot != nullptr && *point.slot) return **point.slot;
    const Vertex& v = point.vertex;
    using Number = CGAL::Mpzf;
    if (point.pose == nullptr) return {Number(v[0]), Number(v[1]), Number(v[2])};
    if (point.error == 0) return {Number(point.image[0]), Number(point.image[1]), Number(point.image[2])};
    const auto row = [&](int i) -> Number {
      const Pose& m = *point.pose;
      return m.whole(i) * Number(v[0]) + m.whole(i + 1) * Number(v[1]) + m.whole(i + 2) * Number(v[2]) + m.whole(i + 3);
    };
    Exact_image image = {row(0), row(4), row(8)};
    if (point.slot != nullptr) *point.slot = std::make_unique<Exact_image>(image);
    return image;
  }

  // All images over one denominator, the product of the weights of the poses: a positive factor, which no sign sees.
  template <class Function, class... Points>
  static CGAL::Sign over_exact_images(const Function& function, const Points&... points)
  {
    const auto is_weighted = [](const Pose* pose) { return pose != nullptr && pose->is_rational(); };
    std::array<const Pose*, sizeof...(Points)> weighted{};
    std::size_t count = 0;
    const auto collect = [&](const Pose* pose) {
      if (is_weighted(pose) && std::find(weighted.begin(), weighted.begin() + count, pose) == weighted.begin() + count)
        weighted[count++] = pose;
    };
    (collect(points.pose), ...);
    const auto over_all = [&](const Point_3& point) {
      Exact_image image = exact_image(point);
      for (std::size_t k = 0; k < count; ++k)
        if (weighted[k] != point.pose)
          for (CGAL::Mpzf& x : image) x = x * weighted[k]->weight();
      return image;
    };
    return function(over_all(points)...);
  }
};

}  // namespace tetracone::kernel

#endif
