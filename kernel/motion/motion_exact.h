#ifndef TETRACONE_KERNEL_MOTION_MOTION_EXACT_H
#define TETRACONE_KERNEL_MOTION_MOTION_EXACT_H

#include "tetracone/kernel/motion/integer_form.h"
#include "tetracone/kernel/motion/motion_filter.h"
#include "tetracone/kernel/motion/motion_forms.h"
#include "tetracone/kernel/motion/moving_pair.h"
#include "tetracone/kernel/motion/time_root.h"

#include <array>
#include <bit>
#include <climits>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::kernel {

/// A double as an odd integer times a power of two; 0 as 0 times 2^INT_MAX.
struct Odd_double {
  explicit Odd_double(double x)
  {
    if (x == 0) return;
    const double fraction = std::frexp(x, &exponent);
    odd = static_cast<std::int64_t>(std::ldexp(fraction, 53));
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(odd));
    odd /= std::int64_t(1) << zeros;
    exponent += zeros - 53;
  }

  std::int64_t odd = 0;
  int exponent = INT_MAX;
};

/// The motion of a pair in integers, decided without rounding.
///
/// The primitives meet at a time where their boxes overlap, the four points are coplanar, and their projections along
/// each of the three axes meet in the plane. That is right for points in any position: one of the three projections is
/// injective on a plane that holds them. In the plane, a point is in the closed triangle where no two of the three turns
/// are of opposite sign, and in the triangle's box; closed segments meet where neither has both ends of the other
/// strictly on one side, and their boxes overlap. The boxes decide where all turns vanish.
///
/// The times of contact are a closed set, so its least one is 0 or a root: of the volume, where that is not zero all the
/// time, else of one of the other forms.
class Exact_motion {
 public:
  explicit Exact_motion(const Moving_pair& pair) : kind_(pair.kind)
  {
    // Contact does not change when an axis is scaled: each has a power of two of its own.
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::array<Odd_double, 8> numbers = all_along(pair, axis);
      int least = INT_MAX;
      for (const Odd_double& x : numbers) least = minimum(least, x.exponent);
      for (std::size_t k = 0; k < 4; ++k)
        points_[k][axis] = {shifted(numbers[2 * k], least), shifted(numbers[2 * k + 1], least)};
    }
    for (std::size_t k = 0; k < 3; ++k) sides_[k] = difference({0, k + 1});
    for (std::size_t axis = 0; axis < 3; ++axis) n1_[axis] = cross_form(sides_[0], sides_[1], axis);
    volume_ = Integer_form(dot_form(n1_, sides_[2]));
  }

  /// True where the four points are coplanar all the time.
  bool is_coplanar() const { return volume_.is_zero(); }

  /// Whether the pair meets, by the filter on exact forms that are rounded once. For what the filter on doubles leaves.
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

  /// The first time of contact; nothing where there is none.
  std::optional<Time_root> first_contact()
  {
    if (meets([](const Integer_form& f) { return sign_of(f.at_start()); })) return Time_root(0, 0);
    if (std::optional<Time_root> within = is_coplanar() ? first_of_all_roots() : first_of_volume()) return within;
    if (meets([](const Integer_form& f) { return sign_of(f.at_end()); })) return Time_root(1, 0);
    return std::nullopt;
  }

 private:
  static std::array<Odd_double, 8> all_along(const Moving_pair& pair, std::size_t axis)
  {
    const auto start = [&](std::size_t k) { return Odd_double(pair.points[k].start[axis]); };
    const auto end = [&](std::size_t k) { return Odd_double(pair.points[k].end[axis]); };
    return {start(0), end(0), start(1), end(1), start(2), end(2), start(3), end(3)};
  }

  static Integer shifted(const Odd_double& x, int least)
  {
    static_assert(sizeof(long) == sizeof(std::int64_t));
    Integer result(static_cast<long>(x.odd));
    if (x.odd != 0) result <<= static_cast<unsigned>(x.exponent - least);
    return result;
  }

  /// The form in doubles, times the power of two that takes its largest coefficient into [1/2, 1).
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

  Linear_vector<Integer> difference(const Between& between) const
  {
    Linear_vector<Integer> d;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t k = 0; k < 2; ++k) d[axis][k] = points_[between.to][axis][k] - points_[between.from][axis][k];
    return d;
  }

  /// The turns n1, n2, n3 and, of two edges, their sum, along an axis; made when first asked for.
  const std::array<Integer_form, 4>& turns(std::size_t axis)
  {
    if (!turns_[axis]) {
      const auto& [a, b, c] = sides_;
      const auto n2 = cross_form(b, c, axis), n3 = cross_form(c, a, axis);
      Quadratic_form<Integer> sum;
      for (std::size_t k = 0; k < 3; ++k) sum[k] = n1_[axis][k] + n2[k] + n3[k];
      turns_[axis] = {Integer_form(n1_[axis]), Integer_form(n2), Integer_form(n3), Integer_form(sum)};
    }
    return *turns_[axis];
  }

  /// Whether the primitives meet at the time at which `sign` tells the signs of forms, of the volume too.
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

  Integer_form along(const Between& d, std::size_t axis) const
  {
    const auto &from = points_[d.from][axis], &to = points_[d.to][axis];
    return Integer_form(Linear_form<Integer>{Integer(to[0] - from[0]), Integer(to[1] - from[1])});
  }

  std::optional<Time_root> first_of_volume()
  {
    for (Time_root& root : roots_within(volume_))
      if (meets_if_coplanar([&](const Integer_form& f) { return root.sign(f); })) return root;
    return std::nullopt;
  }

  std::optional<Time_root> first_of_all_roots()
  {
    std::optional<Time_root> first;
    const auto try_roots_of = [&](const Integer_form& form) {
      if (form.is_zero()) return;
      for (Time_root& root : roots_within(form)) {
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
  std::array<Linear_vector<Integer>, 4> points_;
  std::array<Linear_vector<Integer>, 3> sides_;
  std::array<Quadratic_form<Integer>, 3> n1_;
  Integer_form volume_;
  std::array<std::optional<std::array<Integer_form, 4>>, 3> turns_;
};

}  // namespace tetracone::kernel

#endif
