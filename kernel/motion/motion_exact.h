#ifndef TETRACONE_KERNEL_MOTION_MOTION_EXACT_H
#define TETRACONE_KERNEL_MOTION_MOTION_EXACT_H

#include "tetracone/kernel/motion/integer_form.h"
#include "tetracone/kernel/motion/motion_filter.h"
#include "tetracone/kernel/motion/moving_pair.h"
#include "tetracone/kernel/motion/odd_double.h"
#include "tetracone/kernel/motion/time_root.h"
#include "tetracone/kernel/motion/times_before.h"

#include <array>
#include <climits>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace tetracone::kernel {

/// A moving point or vector: its three coordinates.
using Form_vector = std::array<Integer_form, 3>;

/// Returns the component along `axis` of a x b.
inline Integer_form cross_form(const Form_vector& a, const Form_vector& b, std::size_t axis)
{
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  return a[i] * b[j] - a[j] * b[i];
}

/// The motion of a pair in integers, decided without rounding.
///
/// The primitives meet at a time where three things hold. Their boxes overlap, the four points are coplanar, and their
/// projections along each of the three axes meet. That is right for points in any position, since one of the three
/// projections is injective on a plane that contains them. In the plane, a point is in the closed triangle where no two
/// of the three turns have opposite signs. It must also be in the triangle's box. Closed segments meet where neither
/// has both ends of the other strictly on one side, and their boxes overlap. The boxes decide where all turns vanish.
///
/// The times of contact are a closed set. So the first of them is the first time asked about or a root. The root
/// belongs to the volume or, where that is zero all the time, to another form.
class Exact_motion {
 public:
  explicit Exact_motion(const Moving_pair& pair) : Exact_motion(pair.kind, points_of(pair), Integer_form()) {}

  /// The motion of points whose coordinates are forms of one degree, at least 1, over a common divisor without roots in
  /// [0, 1]. `square` is empty, or a primitive form without such roots that divides the volume's numerator.
  Exact_motion(Moving_kind kind, std::array<Form_vector, 4> points, const Integer_form& square)
      : kind_(kind), points_(std::move(points))
  {
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t axis = 0; axis < 3; ++axis) sides_[k][axis] = points_[k + 1][axis] - points_[0][axis];
    for (std::size_t axis = 0; axis < 3; ++axis) n1_[axis] = cross_form(sides_[0], sides_[1], axis);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Integer_form product = n1_[axis] * sides_[2][axis];
      volume_ = axis == 0 ? product : volume_ + product;
    }
    if (square.size() > 0 && !volume_.is_zero()) volume_ = quotient(volume_, square);
  }

  /// True where the four points are coplanar all the time.
  bool is_coplanar() const { return volume_.is_zero(); }

  /// True when signs of forms tell that the primitives share no point at any of these times, over which their points
  /// are given. It makes no root.
  bool is_apart(Times_before& times)
  {
    if (times.sign(volume_) != CGAL::ZERO) return true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& n = turns(axis);
      const CGAL::Sign n1 = times.sign(n[0]), n2 = times.sign(n[1]), n3 = times.sign(n[2]);
      if (n1 * n3 < 0) return true;
      if (kind_ == Moving_kind::vertex_face ? n1 * n2 < 0 || n2 * n3 < 0 : n2 != 0 && n2 * times.sign(n[3]) > 0)
        return true;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      int all = 2;  // the sign of all differences so far
      if (all_differences(kind_, [&](const Between& d) {
            const int side = times.sign(along(d, axis));
            const bool agrees = side != 0 && (all == 2 || all == side);
            all = side;
            return agrees;
          }))
        return true;
    }
    return false;
  }

  /// Returns whether the pair meets, by the filter on exact forms that are rounded once. It serves the pairs that the
  /// filter on doubles left uncertain. Requires points of degree 1.
  Moving_contact rounded_contact()
  {
    motion_filter::Span span;
    motion_filter::Errors errors;
    span.volume = rounded<4>(volume_, errors.volume);
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t k = 0; k < 4; ++k) span.turns[axis][k] = rounded<3>(turns(axis)[k], errors.turns[axis][k]);
    const Volume known = is_coplanar() ? Volume::zero : Volume::unknown;
    return motion_filter::decide(kind_, known, span, errors, motion_filter::halvings);
  }

  /// Returns the first time of contact in the closed cell; nothing where there is none.
  std::optional<Time_root> first_contact(const Time_cell& cell = {})
  {
    const auto meets_at = [&](Time_root time) { return meets([&](const Integer_form& f) { return time.sign(f); }); };
    const Time_root start(cell.m, cell.k), end(cell.m + 1, cell.k);
    if (meets_at(start)) return start;
    if (std::optional<Time_root> within = is_coplanar() ? first_of_all_roots(cell) : first_of_volume(cell))
      return within;
    if (meets_at(end)) return end;
    return std::nullopt;
  }

 private:
  /// Contact does not change when an axis is scaled: each has a power of two of its own.
  static std::array<Form_vector, 4> points_of(const Moving_pair& pair)
  {
    std::array<Form_vector, 4> points;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::array<Odd_double, 8> numbers = all_along(pair, axis);
      int least = INT_MAX;
      for (const Odd_double& x : numbers) least = minimum(least, x.exponent);
      for (std::size_t k = 0; k < 4; ++k)
        points[k][axis] = Integer_form(std::array{numbers[2 * k].over(least), numbers[2 * k + 1].over(least)});
    }
    return points;
  }

  static std::array<Odd_double, 8> all_along(const Moving_pair& pair, std::size_t axis)
  {
    const auto start = [&](std::size_t k) { return Odd_double(pair.points[k].start[axis]); };
    const auto end = [&](std::size_t k) { return Odd_double(pair.points[k].end[axis]); };
    return {start(0), end(0), start(1), end(1), start(2), end(2), start(3), end(3)};
  }

  /// Returns the form in doubles, times the power of two that takes its largest coefficient into [1/2, 1).
  template <std::size_t N>
  static motion_filter::Scaled<N> rounded(const Integer_form& form, double& error)
  {
    std::array<double, N> coefficients;
    std::array<long, N> exponents;
    long largest = 0;
    for (std::size_t k = 0; k < N; ++k) {
      coefficients[k] = mpz_get_d_2exp(&exponents[k], form[k].get_mpz_t());
      largest = maximum(largest, exponents[k]);
    }
    // Below 2^-1074 a coefficient becomes 0 or a denormal number.
    for (std::size_t k = 0; k < N; ++k)
      coefficients[k] = std::ldexp(coefficients[k], static_cast<int>(exponents[k] - largest));
    error = motion_filter::rounded_error;
    return motion_filter::scaled(coefficients);
  }

  /// Returns the turns n1, n2, n3 along an axis, and their sum, for two edges. They are made when first asked for.
  const std::array<Integer_form, 4>& turns(std::size_t axis)
  {
    if (!turns_[axis]) {
      const auto& [a, b, c] = sides_;
      const auto n2 = cross_form(b, c, axis), n3 = cross_form(c, a, axis);
      turns_[axis] = {n1_[axis], n2, n3, n1_[axis] + n2 + n3};
    }
    return *turns_[axis];
  }

  /// True when the primitives meet at the time at which `sign` gives the signs of forms, also of the volume.
  template <class Sign_of>
  bool meets(const Sign_of& sign)
  {
    return sign(volume_) == CGAL::ZERO && meets_if_coplanar(sign);
  }

  template <class Sign_of>
  bool meets_if_coplanar(const Sign_of& sign)
  {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& n = turns(axis);
      const CGAL::Sign n1 = sign(n[0]), n3 = sign(n[2]);
      if (n1 * n3 < 0) return false;
      const CGAL::Sign n2 = sign(n[1]);
      if (n2 == CGAL::ZERO) continue;
      if (kind_ == Moving_kind::vertex_face ? n1 * n2 < 0 || n2 * n3 < 0 : n2 * sign(n[3]) > 0) return false;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      bool positive = true, negative = true;
      all_differences(kind_, [&](const Between& d) {
        const CGAL::Sign side = sign(along(d, axis));
        positive = positive && side > 0;
        negative = negative && side < 0;
        return positive || negative;
      });
      if (positive || negative) return false;
    }
    return true;
  }

  Integer_form along(const Between& d, std::size_t axis) const { return points_[d.to][axis] - points_[d.from][axis]; }

  std::optional<Time_root> first_of_volume(const Time_cell& cell)
  {
    for (Time_root& root : roots_within(volume_, cell))
      if (meets_if_coplanar([&](const Integer_form& f) { return root.sign(f); })) return root;
    return std::nullopt;
  }

  std::optional<Time_root> first_of_all_roots(const Time_cell& cell)
  {
    std::optional<Time_root> first;
    const auto try_roots_of = [&](const Integer_form& form) {
      if (form.is_zero()) return;
      for (Time_root& root : roots_within(form, cell)) {
        if (first && !root.is_before(*first)) return;
        if (!meets_if_coplanar([&](const Integer_form& f) { return root.sign(f); })) continue;
        first = root;
        return;
      }
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const Integer_form& turn : turns(axis)) try_roots_of(turn);
    for (std::size_t axis = 0; axis < 3; ++axis)
      all_differences(kind_, [&](const Between& d) {
        try_roots_of(along(d, axis));
        return true;
      });
    return first;
  }

  Moving_kind kind_;
  std::array<Form_vector, 4> points_;
  std::array<Form_vector, 3> sides_;
  Form_vector n1_;
  Integer_form volume_;
  std::array<std::optional<std::array<Integer_form, 4>>, 3> turns_;
};

}  // namespace tetracone::kernel

#endif
