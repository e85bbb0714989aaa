#ifndef TETRACONE_TETRATREE_SCENE_BODY_BOX_H
#define TETRACONE_TETRATREE_SCENE_BODY_BOX_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/tetratree/scene/body_extent.h"
#include "tetracone/tetratree/scene/world_box.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace tetracone::tetratree {

/// Upper bound of the error of the sums of a body's box, as a fraction of the sum of their terms' magnitudes
/// (verify/proofs/scene_proofs.h).
inline constexpr double body_box_rounding = 0x1p-49;

/// Returns the gap along an axis, from the upper side `high` of a box to the lower side `low` of another. Sides are
/// relative to the centres; `between` is the other's centre minus the first's.
template <class Number>
Number gap_along(const Number& between, const Number& low, const Number& high)
{
  return between + low - high;
}

/// Returns a gap less the rotation of both bodies and `slack`.
template <class Number>
Number less_turned(const Number& gap, const Number& turned, const Number& other_turned, const Number& slack)
{
  return gap - turned - other_turned - slack;
}

/// Returns the lower side of a box that has grown by `grown`, with its body at `place`.
template <class Number>
Number lower_side(const Number& place, const Number& low, const Number& grown)
{
  return place + low - grown;
}
/// Returns the upper side of the box.
template <class Number>
Number upper_side(const Number& place, const Number& high, const Number& grown)
{
  return place + high + grown;
}

/// A box about a body that moves with it. It is found at one pose and stored relative to the body's centre. On every
/// side it is larger by the growth of the body's `turned` since.
///
/// The roundings of the centre, and of `turned`, are added at use. The stored sides include their own roundings.
class alignas(32) Body_box {
 public:
  Body_box() = default;
  Body_box(const World_box& box, const Body_place& place) : turned_(place.turned)
  {
    for (std::size_t k = 0; k < 3; ++k) {
      const double low = double(box.low[k]) - place.at[k], high = double(box.high[k]) - place.at[k];
      low_[k] = rounded_below(low - body_box_rounding * std::abs(low));
      high_[k] = rounded_above(high + body_box_rounding * std::abs(high));
    }
  }

  /// True when the body has not turned since the box was found.
  bool is_new(const Body_place& place) const { return turned_ == place.turned; }

  /// Returns by how much the box is larger on every side than when it was found.
  double grown(const Body_place& place) const
  {
    return since(place) + body_box_rounding * (std::abs(place.at[0]) + std::abs(place.at[1]) + std::abs(place.at[2]));
  }

  /// Returns a box about the body where it is now.
  World_box at(const Body_place& place) const
  {
    World_box box;
    const double more = grown(place);
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = rounded_below(lower_side(place.at[k], double(low_[k]), more));
      box.high[k] = rounded_above(upper_side(place.at[k], double(high_[k]), more));
    }
    return box;
  }

  /// True when the box about the body, where it is now, is within another.
  bool is_within(const World_box& box, const Body_place& place) const
  {
    const double more = grown(place);
    bool is_in = true;
    for (std::size_t k = 0; k < 3; ++k) {
      is_in &= lower_side(place.at[k], double(low_[k]), more) >= double(box.low[k]);
      is_in &= upper_side(place.at[k], double(high_[k]), more) <= double(box.high[k]);
    }
    return is_in;
  }

  /// Returns a lower bound of the distance of two bodies, along the axis with the largest gap of their boxes. It is not
  /// above 0 where the boxes meet.
  double gap(const Body_place& place, const Body_box& other, const Body_place& other_place) const
  {
    double most = -std::numeric_limits<double>::infinity(), terms = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double between = place.at[k] - other_place.at[k],
                   above = gap_along(between, double(low_[k]), double(other.high_[k])),
                   below = gap_along(-between, double(other.low_[k]), double(high_[k]));
      most = above > most ? above : most;
      most = below > most ? below : most;
      terms += std::abs(between);
    }
    return less_turned(most, since(place), other.since(other_place), body_box_rounding * terms);
  }

  /// Returns the longest edge of the box as it was found.
  double size() const
  {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) longest = kernel::maximum(longest, double(high_[k]) - double(low_[k]));
    return longest;
  }

 private:
  double since(const Body_place& place) const { return (place.turned - turned_) * (1 + body_box_rounding); }

  std::array<float, 3> low_{-World_box::infinity, -World_box::infinity, -World_box::infinity},
      high_{World_box::infinity, World_box::infinity, World_box::infinity};
  double turned_ = 0;  // the body's `turned` then
};

}  // namespace tetracone::tetratree

#endif
