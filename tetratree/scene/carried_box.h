#ifndef TETRACONE_TETRATREE_SCENE_CARRIED_BOX_H
#define TETRACONE_TETRATREE_SCENE_CARRIED_BOX_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/tetratree/scene/body_extent.h"
#include "tetracone/tetratree/scene/world_box.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace tetracone::tetratree {

/// A box about a body, found at one of its poses, that goes with it: about the body's place, and on every side larger by
/// what the body has turned since.
///
/// What is rounded in the sums below is less than 8 unit roundoffs of each of their terms: of a place, and of what has
/// been turned, that is added; of the box's own numbers, it is in them.
class alignas(32) Carried_box {
 public:
  Carried_box() = default;
  Carried_box(const World_box& box, const Body_place& place) : turned_(place.turned)
  {
    for (std::size_t k = 0; k < 3; ++k) {
      const double low = double(box.low[k]) - place.at[k], high = double(box.high[k]) - place.at[k];
      low_[k] = rounded_below(low - of_numbers * std::abs(low));
      high_[k] = rounded_above(high + of_numbers * std::abs(high));
    }
  }

  /// Whether the body has not turned since.
  bool is_new(const Body_place& place) const { return turned_ == place.turned; }

  /// By how much it is larger on every side than it was found.
  double grown(const Body_place& place) const
  {
    return since(place) + of_places * (std::abs(place.at[0]) + std::abs(place.at[1]) + std::abs(place.at[2]));
  }

  /// About the body.
  World_box at(const Body_place& place) const
  {
    World_box box;
    const double more = grown(place);
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = rounded_below(place.at[k] + double(low_[k]) - more);
      box.high[k] = rounded_above(place.at[k] + double(high_[k]) + more);
    }
    return box;
  }

  bool is_within(const World_box& box, const Body_place& place) const
  {
    const double more = grown(place);
    bool is_in = true;
    for (std::size_t k = 0; k < 3; ++k)
      is_in &= (place.at[k] + double(low_[k]) - more >= double(box.low[k])) &
               (place.at[k] + double(high_[k]) + more <= double(box.high[k]));
    return is_in;
  }

  /// At most how far the body is from another, along the axis on which their boxes are farthest apart; not above 0 where
  /// they meet.
  double gap(const Body_place& place, const Carried_box& other, const Body_place& other_place) const
  {
    double most = -std::numeric_limits<double>::infinity(), terms = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double between = place.at[k] - other_place.at[k],
                   above = between + double(low_[k]) - double(other.high_[k]),
                   below = double(other.low_[k]) - (between + double(high_[k]));
      most = above > most ? above : most;
      most = below > most ? below : most;
      terms += std::abs(between);
    }
    return most - since(place) - other.since(other_place) - of_places * terms;
  }

  /// The longest edge.
  double size() const
  {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) longest = kernel::maximum(longest, double(high_[k]) - double(low_[k]));
    return longest;
  }

 private:
  static constexpr double of_numbers = 0x1p-22, of_places = 0x1p-50;

  double since(const Body_place& place) const { return (place.turned - turned_) * (1 + of_places); }

  std::array<float, 3> low_{-World_box::infinity, -World_box::infinity, -World_box::infinity},
      high_{World_box::infinity, World_box::infinity, World_box::infinity};
  double turned_ = 0;  // by the body then
};

}  // namespace tetracone::tetratree

#endif
