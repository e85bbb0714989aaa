#ifndef TETRACONE_KERNEL_CONTACT_CROSSING_POLYTOPE_H
#define TETRACONE_KERNEL_CONTACT_CROSSING_POLYTOPE_H

#include "tetracone/kernel/contact/shift_range.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/products.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace tetracone::kernel {

/// A box of translations of A, along the axes: all centre + x with |x_k| <= half[k].
struct Translation_box {
  std::array<double, 3> centre, half;

  /// Returns a lower bound of the length of its translations.
  double least_length() const
  {
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = maximum(std::abs(centre[k]) - half[k], 0.0);
      square += x * x;
    }
    return std::sqrt(square) * (1 - few_roundings);
  }
};

/// The translations v for which piece a of A, moved by v, shares a point with piece b of B. They are the Minkowski
/// difference b - a. Where the planes of the pieces are not parallel, a goes through b for every v in its inside.
///
/// It keeps half-spaces n . v < limit. It drops those that hold all of a ball about 0. Numbers are rounded; `inner` is
/// a limit that is surely small enough, `outer` one that is surely large enough.
class Crossing_polytope {
 public:
  /// Requires a block of upward rounding. With pieces that are not bounded (`are_bounded` is false), it holds no
  /// translation and may meet every box. `radius` is an upper bound of the ball's radius. Translations that are asked
  /// for have coordinates of at most `most`. `axes` answers questions about the exact pieces. `is_zero(axis)` says
  /// whether an axis is the direction 0. `is_outside_ball(axis, sign)` is true when a half-space's plane misses the
  /// open ball.
  template <class Exact_axes>
  Crossing_polytope(const Rounded_piece& a, const Rounded_piece& b, bool are_bounded, double radius, double most,
                    const Exact_axes& axes)
  {
    if (!are_bounded) {
      half_spaces_.push_back({{0, 0, 0}, -HUGE_VAL, HUGE_VAL, {}, 1});
      return;
    }
    const Corner_errors errors(a.errors, b.errors);
    const double slack = errors.off_step() + few_roundings * most;  // also for a box's own ends
    for (std::size_t k = 0; k < 3; ++k) {
      const auto range_of = [k](const Rounded_piece& piece) {
        std::array<double, 2> range = {piece.corner[0][k], piece.corner[0][k]};
        for (int i = 1; i < piece.count; ++i) {
          range[0] = minimum(range[0], piece.corner[i][k]);
          range[1] = maximum(range[1], piece.corner[i][k]);
        }
        return range;
      };
      const auto of_a = range_of(a), of_b = range_of(b);
      low_[k] = -(of_a[1] - of_b[0] + slack);
      high_[k] = of_b[1] - of_a[0] + slack;
    }
    const Interval off(-errors.off_normal(), errors.off_normal());
    detail::for_shift_axes(a, b, [&](const Shift_axis& axis) {
      if (axis.kind == Shift_axis::Kind::edge_of_a || axis.kind == Shift_axis::Kind::edge_of_b) return true;
      const detail::Allowed<Interval> allowed(axis, a, b, errors);
      if (allowed.may_say_nothing && axes.is_zero(axis)) return true;
      const Number_point<double> about = detail::direction<double>(axis, a, b);
      const Number_point<Interval> n = {about[0] + off, about[1] + off, about[2] + off};
      add(axis, 1, n, allowed.high, radius, most, axes);
      add(axis, -1, n, -allowed.low, radius, most, axes);
      return !is_beyond_;
    });
  }

  /// True when the polytope surely has no point in the ball.
  bool is_beyond() const { return is_beyond_; }

  /// False when it surely has no translation of the box. It is a quick test, by the least box around the polytope.
  bool is_near(const Translation_box& box) const
  {
    for (std::size_t k = 0; k < 3; ++k)
      if (box.centre[k] - box.half[k] > high_[k] || box.centre[k] + box.half[k] < low_[k]) return false;
    return true;
  }

  /// True when the polytope's inside surely has all translations of the box that are inside the ball.
  bool holds(const Translation_box& box) const
  {
    for (const Half_space& h : half_spaces_)
      if (!(h.middle(box) + h.reach(box) <= h.inner)) return false;
    return true;
  }

  /// Calls what(normal, limit, axis, sign) for each half-space whose plane may cut the box. The numbers are rounded;
  /// the axis and its sign tell the exact ones.
  template <class What>
  void for_planes(const Translation_box& box, const What& what) const
  {
    for (const Half_space& h : half_spaces_)
      if (const double middle = h.middle(box), reach = h.reach(box);
          middle - reach <= h.outer && middle + reach >= h.inner && std::isfinite(h.outer))
        what(h.normal, h.outer, h.axis, h.sign);
  }

  /// True when the polytope may have a translation of the box.
  bool may_meet(const Translation_box& box) const
  {
    for (const Half_space& h : half_spaces_)
      if (h.middle(box) - h.reach(box) > h.outer) return false;
    return true;
  }

 private:
  struct Half_space {
    std::array<double, 3> normal;
    double inner, outer;
    Shift_axis axis;
    int sign;

    double middle(const Translation_box& box) const { return dot(normal, box.centre); }
    double reach(const Translation_box& box) const
    {
      return std::abs(normal[0]) * box.half[0] + std::abs(normal[1]) * box.half[1] + std::abs(normal[2]) * box.half[2];
    }
  };

  template <class Exact_axes>
  void add(const Shift_axis& axis, int sign, const Number_point<Interval>& n, const Interval& limit, double radius,
           double most, const Exact_axes& axes)
  {
    Half_space h{{}, 0, 0, axis, sign};
    // Upper bound of the error of a product with the rounded normal, for all translations that are asked for.
    Interval off = 0, magnitude = 0, square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Interval x = sign > 0 ? n[k] : -n[k];
      h.normal[k] = x.inf() / 2 + x.sup() / 2;
      off += Interval(x.sup()) - Interval(x.inf());
      magnitude += Interval(maximum(std::abs(x.inf()), std::abs(x.sup())));
      square += x * x;
    }
    const Interval slack = (off + magnitude * few_roundings) * most + CGAL::abs(limit) * few_roundings;
    h.inner = (limit - slack).inf();
    h.outer = (limit + slack).sup();
    // The largest product with a translation of the ball.
    const Interval length = CGAL::sqrt(square), largest = length * radius;
    if (largest.sup() <= limit.inf()) return;
    if (-largest.inf() > limit.sup() && length.inf() > 0) is_beyond_ = true;
    const bool is_tangent = limit.sup() >= largest.inf() * (1 - tangent);
    if (is_tangent && axes.is_outside_ball(axis, sign)) return;
    half_spaces_.push_back(h);
  }

  /// A plane is compared exactly with the ball unless its distance from 0 is surely less than the radius, by at least
  /// this share.
  static constexpr double tangent = 0x1p-30;

  std::array<double, 3> low_ = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, high_ = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
  std::vector<Half_space> half_spaces_;
  bool is_beyond_ = false;
};

}  // namespace tetracone::kernel

#endif
