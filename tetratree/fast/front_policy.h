#ifndef TETRACONE_TETRATREE_FAST_FRONT_POLICY_H
#define TETRACONE_TETRATREE_FAST_FRONT_POLICY_H

#include "tetracone/kernel/number/floating_point.h"

#include <cstddef>

namespace tetracone::tetratree {

/// When a front is worth what it costs. A cost is in openings of a box by a descent that keeps nothing; nothing here
/// changes an answer.
///
/// A front is made by a descent from the root and then followed, pose by pose. Coarse motion wears it: parts that were
/// opened once stay open. As of a machine that wears, its least cost a pose is had by renewing it when the present cost
/// is above the mean of all since it was new, its making included. Where that mean is no less than what descents cost
/// that keep nothing, memory does not pay: descents keep nothing for a while, twice as long each time.
class Front_policy {
 public:
  /// Of one pair of elements, of an entry's axes, of an opening that certifies, and of what every pose costs.
  static constexpr double of_elements = 6, of_check = 0.3, of_certified = 2, of_pose = 4;

  /// How much dearer a descent is that makes a front; the share of a plain descent that one that follows may cost for
  /// certain before it is given up; below which mean memory pays; how many poses at most are asked without.
  static constexpr double making = 1.8, too_many = 0.6, pays_below = 0.85;
  static constexpr std::size_t longest_pause = 64;

  /// Before a front is taken for worn by the mean.
  static constexpr std::size_t fewest_poses = 5;

  /// Whether the next descent from the root is to make a front.
  bool makes_front()
  {
    if (pause_left_ == 0) return true;
    --pause_left_;
    return false;
  }
  void made(double cost)
  {
    plain_ = cost + of_pose;
    spent_ = making * plain_;
    recent_ = 0;
    poses_ = 1;
  }

  /// Whether to follow, where so many openings are needed for certain.
  bool is_worth(std::size_t openings) const { return double(openings) <= too_many * plain_; }
  void followed(double cost)
  {
    spent_ += cost + of_pose;
    recent_ = poses_ == 1 ? cost + of_pose : 0.75 * recent_ + 0.25 * (cost + of_pose);
    ++poses_;
  }
  bool is_worn() const
  {
    return recent_ > pays_below * plain_ || (poses_ >= fewest_poses && recent_ * double(poses_) > spent_);
  }

  /// The front is gone.
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
