#ifndef TETRACONE_TETRATREE_MEMORY_FRONT_POLICY_H
#define TETRACONE_TETRATREE_MEMORY_FRONT_POLICY_H

#include "tetracone/kernel/number/floating_point.h"

#include <cstddef>

namespace tetracone::tetratree {

/// Decides when a front is worth its cost. Costs are in openings of a box by a descent that keeps nothing. No answer
/// depends on it.
///
/// A front is made by a descent from the root and then followed, pose by pose. Coarse motion degrades it: parts that
/// were opened once stay open. The front is rebuilt when the present cost per pose exceeds its average since it was
/// built, building included (the classic replacement rule). Where that average is not below `pays_below` times the cost
/// of a plain descent, memory does not pay. Then descents keep nothing for a while, which doubles each time, up to
/// `longest_pause`.
class Front_policy {
 public:
  /// Costs, in openings.
  static constexpr double of_elements = 6,  ///< one pair of elements
      of_check = 0.3,                       ///< one entry tested along its axes
      of_certified = 2,                     ///< one opening that certifies
      of_pose = 4;                          ///< every pose

  /// Ratios to the cost of a plain descent.
  static constexpr double making = 1.8,             ///< cost of the descent that makes a front
      too_many = 0.6,                               ///< certain cost of following, above which the front is given up
      pays_below = 0.85;                            ///< average cost per pose below which a front pays
  static constexpr std::size_t longest_pause = 64;  ///< most descents in a row without a front

  /// Poses before the average may end a front.
  static constexpr std::size_t fewest_poses = 5;

  /// True when the next descent from the root is to make a front.
  bool makes_front()
  {
    if (pause_left_ == 0) return true;
    --pause_left_;
    return false;
  }
  /// Records a front and the cost of its descent.
  void made(double cost)
  {
    plain_ = cost + of_pose;
    spent_ = making * plain_;
    recent_ = 0;
    poses_ = 1;
  }

  /// True when following pays, given a lower bound of the openings that it needs.
  bool is_worth(std::size_t openings) const { return double(openings) <= too_many * plain_; }
  /// Records the cost of following in a pose.
  void followed(double cost)
  {
    spent_ += cost + of_pose;
    recent_ = poses_ == 1 ? cost + of_pose : 0.75 * recent_ + 0.25 * (cost + of_pose);
    ++poses_;
  }
  /// True when the front costs more than it saves, or than making it anew.
  bool is_worn() const
  {
    return recent_ > pays_below * plain_ || (poses_ >= fewest_poses && recent_ * double(poses_) > spent_);
  }

  /// Records that the front is gone.
  void ended()
  {
    if (spent_ < pays_below * plain_ * double(poses_)) {
      pause_ = 0;
      return;
    }
    pause_ = kernel::minimum(kernel::maximum(2 * pause_, std::size_t(1)), longest_pause);
    pause_left_ = pause_;
  }

 private:
  double plain_ = 0, spent_ = 0, recent_ = 0;
  std::size_t poses_ = 0, pause_ = 0, pause_left_ = 0;
};

}  // namespace tetracone::tetratree

#endif
