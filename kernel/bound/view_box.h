#ifndef TETRACONE_KERNEL_BOUND_VIEW_BOX_H
#define TETRACONE_KERNEL_BOUND_VIEW_BOX_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/number/interval.h"
#include "tetracone/kernel/number/number.h"

#include <CGAL/gmpxx.h>

#include <array>
#include <cmath>
#include <limits>

namespace tetracone::kernel {

/// Bounds of a part of a body in a view: of x, y, x + y, x - y, and of the height z.
struct View_box {
  static constexpr std::size_t level_axes = 4, height = 4;
  std::array<double, 5> low, high;

  /// True when the parts may be seen at one place.
  bool may_cover(const View_box& other) const
  {
    for (std::size_t k = 0; k < level_axes; ++k)
      if (low[k] > other.high[k] || other.low[k] > high[k]) return false;
    return true;
  }

  /// True when the parts may meet after a translation of at most this length along the view's axes.
  bool is_within(const View_box& other, double length) const
  {
    const double reach = 1.5 * length;  // more than the root of 2, the largest length of an axis
    for (std::size_t k = 0; k < low.size(); ++k)
      if (low[k] - other.high[k] > reach || other.low[k] - high[k] > reach) return false;
    return true;
  }

  double size() const { return (high[0] - low[0]) + (high[1] - low[1]) + (high[height] - low[height]); }
};

/// Lower bound of the rise at which a part of A may meet a part of B.
inline double least_rise(const View_box& a, const View_box& b)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return std::nextafter(b.low[View_box::height] - a.high[View_box::height], -infinity);
}
/// Upper bound of that rise.
inline double most_rise(const View_box& a, const View_box& b)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return std::nextafter(b.high[View_box::height] - a.low[View_box::height], infinity);
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
    const auto write = [&](std::size_t axis, std::size_t row) {
      offset_[axis] = m[4 * row + 3];
      for (std::size_t k = 0; k < 3; ++k) {
        offset_[axis] += m[4 * row + k] * units.origin[k];
        row_[axis][k] = m[4 * row + k] * units.unit;
      }
    };
    write(0, 0);
    write(1, 1);
    write(View_box::height, 2);
    offset_[2] = offset_[0] + offset_[1];
    offset_[3] = offset_[0] - offset_[1];
    for (std::size_t k = 0; k < 3; ++k) {
      row_[2][k] = row_[0][k] + row_[1][k];
      row_[3][k] = row_[0][k] - row_[1][k];
    }
  }

  /// Returns the view of each box. It is unlimited where coordinates are too large to bound.
  std::array<View_box, lanes> operator()(const Obb8& boxes) const
  {
    const CGAL::Protect_FPU_rounding<true> upward;
    std::array<View_box, lanes> seen;
    for (int lane = 0; lane < boxes.lane_count; ++lane)
      for (std::size_t axis = 0; axis < row_.size(); ++axis) {
        const Interval about = is_bounded_ ? range(boxes, lane, axis) : Interval::largest();
        seen[std::size_t(lane)].low[axis] = about.inf();
        seen[std::size_t(lane)].high[axis] = about.sup();
      }
    return seen;
  }

 private:
  Interval range(const Obb8& boxes, int lane, std::size_t axis) const
  {
    const auto& row = row_[axis];
    Interval middle = offset_[axis], half = 0;
    for (std::size_t k = 0; k < 3; ++k)
      middle += row[k] * (Interval(double(boxes.origin[k])) + Interval(double(boxes.centre[k][lane])));
    for (int i = 0; i < 3; ++i) {
      Interval along = 0;
      for (std::size_t k = 0; k < 3; ++k) along += row[k] * Interval(double(boxes.axis[i][k][lane]));
      half += CGAL::abs(along) * Interval(double(boxes.extent[i][lane]));
    }
    return middle + Interval(-half.sup(), half.sup());
  }

  std::array<Interval, 5> offset_;
  std::array<std::array<Interval, 3>, 5> row_;
  bool is_bounded_ = false;
};

}  // namespace tetracone::kernel

#endif
