#ifndef TETRACONE_KERNEL_BOUND_VIEW_BOX_H
#define TETRACONE_KERNEL_BOUND_VIEW_BOX_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/interval.h"
#include "tetracone/kernel/number/number.h"

#include <CGAL/gmpxx.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

namespace tetracone::kernel {

/// Bounds of a part of a body in a view: of x, y, x + y, x - y, then of the height z, z + x, z - x, z + y and z - y.
struct View_box {
  static constexpr std::size_t axes = 9, height = 4;
  std::array<double, axes> low, high;

  /// Returns bounds that say nothing.
  static View_box unlimited()
  {
    View_box box;
    box.low.fill(-std::numeric_limits<double>::infinity());
    box.high.fill(std::numeric_limits<double>::infinity());
    return box;
  }

  /// Returns the bounds of enclosed points. Requires a block of upward rounding, and at least one point.
  static View_box around(std::span<const std::array<Interval, 3>> points)
  {
    View_box box;
    box.low.fill(std::numeric_limits<double>::infinity());
    box.high.fill(-std::numeric_limits<double>::infinity());
    for (const auto& p : points) {
      const std::array<Interval, axes> at = along(p);
      for (std::size_t k = 0; k < axes; ++k) {
        box.low[k] = minimum(box.low[k], at[k].inf());
        box.high[k] = maximum(box.high[k], at[k].sup());
      }
    }
    return box;
  }

  /// Returns the nine functions' values at a point, or with `size`, upper bounds of their magnitudes within a box.
  template <class N>
  static std::array<N, axes> along(const std::array<N, 3>& p, bool size = false)
  {
    const N &x = p[0], &y = p[1], &z = p[2];
    const double sign = size ? 1 : -1;
    return {x, y, x + y, x + sign * y, z, z + x, z + sign * x, z + y, z + sign * y};
  }

  /// True when the parts may be seen at one place.
  bool may_cover(const View_box& other) const
  {
    for (std::size_t k = 0; k < height; ++k)
      if (low[k] > other.high[k] || other.low[k] > high[k]) return false;
    return true;
  }

  /// False when the parts surely do not meet for any translation of this one by centre + x with |x_k| <= half[k].
  bool may_meet(const View_box& other, const std::array<double, 3>& centre, const std::array<double, 3>& half) const
  {
    const std::array<double, axes> middle = along(centre), reach = along(half, true);
    for (std::size_t k = 0; k < low.size(); ++k) {
      const double most = reach[k] + (std::abs(middle[k]) + reach[k]) * few_roundings;
      if (low[k] + middle[k] - most > other.high[k] || high[k] + middle[k] + most < other.low[k]) return false;
    }
    return true;
  }

  /// Returns the sum of the extents along x, y and z.
  double size() const { return (high[0] - low[0]) + (high[1] - low[1]) + (high[height] - low[height]); }
};

/// Returns a lower bound of the rise at which a part of A may meet a part of B. Points that are seen at one place have
/// one x and one y, so each of the functions of the height bounds the rise.
inline double least_rise(const View_box& a, const View_box& b)
{
  double rise = b.low[View_box::height] - a.high[View_box::height];
  for (std::size_t k = View_box::height + 1; k < View_box::axes; ++k) rise = maximum(rise, b.low[k] - a.high[k]);
  return rise - std::abs(rise) * few_roundings;
}
/// Returns an upper bound of such a rise.
inline double most_rise(const View_box& a, const View_box& b)
{
  double rise = b.high[View_box::height] - a.low[View_box::height];
  for (std::size_t k = View_box::height + 1; k < View_box::axes; ++k) rise = minimum(rise, b.high[k] - a.low[k]);
  return rise + std::abs(rise) * few_roundings;
}

/// The view of the boxes of a body's tree.
class Box_view {
 public:
  /// `map` leads from the body's own coordinates into the view, a row-major 3x4 matrix.
  Box_view(const std::array<Rational, 12>& map, const Local_scale& units)
  {
    const CGAL::Protect_FPU_rounding<true> upward;
    std::array<Interval, 12> m;
    for (std::size_t k = 0; k < 12; ++k) m[k] = CGAL::to_interval(map[k]);
    is_bounded_ = units.is_in_range();
    for (const Interval& x : m) is_bounded_ = is_bounded_ && x.inf() >= -0x1p200 && x.sup() <= 0x1p200;
    std::array<std::array<Interval, 4>, View_box::axes> rows;
    for (const auto& [axis, row] : {std::pair<std::size_t, std::size_t>(0, 0), {1, 1}, {View_box::height, 2}}) {
      rows[axis][3] = m[4 * row + 3];
      for (std::size_t k = 0; k < 3; ++k) {
        rows[axis][3] += m[4 * row + k] * units.origin[k];
        rows[axis][k] = m[4 * row + k] * units.unit;
      }
    }
    for (std::size_t k = 0; k < 4; ++k) {
      rows[2][k] = rows[0][k] + rows[1][k];
      rows[3][k] = rows[0][k] - rows[1][k];
      for (std::size_t i = 0; i < 2; ++i) {
        rows[View_box::height + 1 + 2 * i][k] = rows[View_box::height][k] + rows[i][k];
        rows[View_box::height + 2 + 2 * i][k] = rows[View_box::height][k] - rows[i][k];
      }
    }
    for (std::size_t axis = 0; axis < axis_.size(); ++axis) {
      Axis& to = axis_[axis];
      const auto write = [](const Interval& x, double& middle) {
        middle = x.inf() / 2 + x.sup() / 2;
        return maximum(x.sup() - middle, middle - x.inf()) + few_roundings * maximum(x.sup(), -x.inf());
      };
      for (std::size_t k = 0; k < 3; ++k) to.relative = maximum(to.relative, write(rows[axis][k], to.row[k]));
      to.absolute = write(rows[axis][3], to.offset) + underflow_slack;
    }
  }

  /// Returns the view of each box. It is unlimited where coordinates are too large to bound.
  std::array<View_box, lanes> operator()(const Obb8& boxes) const
  {
    std::array<View_box, lanes> seen;
    for (int lane = 0; lane < boxes.lane_count; ++lane) {
      View_box& box = seen[std::size_t(lane)];
      if (!is_bounded_) {
        box = View_box::unlimited();
        continue;
      }
      double centre[3], half[3][3], reach = 0;
      for (int k = 0; k < 3; ++k) {
        centre[k] = double(boxes.origin[k]) + double(boxes.centre[k][lane]);
        reach += std::abs(double(boxes.origin[k])) + std::abs(double(boxes.centre[k][lane]));
        for (int i = 0; i < 3; ++i) {
          half[i][k] = double(boxes.axis[i][k][lane]) * double(boxes.extent[i][lane]);
          reach += std::abs(half[i][k]);
        }
      }
      for (std::size_t axis = 0; axis < axis_.size(); ++axis) {
        const Axis& along = axis_[axis];
        const auto product = [&along](const double(&x)[3]) {
          return along.row[0] * x[0] + along.row[1] * x[1] + along.row[2] * x[2];
        };
        const double middle = along.offset + product(centre),
                     most = std::abs(product(half[0])) + std::abs(product(half[1])) + std::abs(product(half[2])) +
                            (along.relative * reach + along.absolute) * 2;
        box.low[axis] = middle - most;
        box.high[axis] = middle + most;
      }
    }
    return seen;
  }

 private:
  /// A linear function of a body's local units, in rounded numbers. Its error is at most `absolute` plus `relative`
  /// times the sum of the coordinates' magnitudes. Both contain `few_roundings` of the terms, for all that is computed
  /// of them. Their own roundings are covered by taking them twice.
  struct Axis {
    std::array<double, 3> row;
    double offset, relative = 0, absolute = 0;
  };

  std::array<Axis, View_box::axes> axis_;
  bool is_bounded_ = false;
};

}  // namespace tetracone::kernel

#endif
