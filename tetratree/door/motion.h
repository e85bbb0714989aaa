#ifndef TETRACONE_TETRATREE_DOOR_MOTION_H
#define TETRACONE_TETRATREE_DOOR_MOTION_H

#include "tetracone/tetratree/door/nearest.h"

#include <array>
#include <memory>
#include <optional>
#include <string>

namespace tetracone {

class Pose;
namespace kernel {
class Body_motion;
}

/// How a body moves over t in [0, 1], taken exactly. Immutable, cheap to copy.
class Motion {
 public:
  /// Every point moves on a line, at constant speed, from its image under the first pose to that under the second:
  /// M(t) = (1-t) M0 + t M1. In between M(t) may be singular; then the image is flat.
  static Motion linear(const Pose& from, const Pose& to);

  /// A rotation at every t: by the quaternion q(t) = (1-t) q0 + t q1, which is not normalised, so of no constant angular
  /// velocity; and a translation on a line. Seven numbers, w x y z of a quaternion of any length above 0, then the
  /// translation. Throws Error for a number that is not finite, and where q(t) = 0 for some t.
  static Motion rigid(const std::array<double, 7>& from, const std::array<double, 7>& to);

  /// Of decimals or fractions "n/d". Throws as for doubles, and for a text that is no number.
  static Motion rigid_from_text(const std::array<std::string, 7>& from, const std::array<std::string, 7>& to);

  /// The motion of the templates.
  explicit Motion(kernel::Body_motion motion);
  /// The motion of the templates.
  const kernel::Body_motion& exact() const { return *exact_; }

 private:
  std::shared_ptr<const kernel::Body_motion> exact_;
};

/// When two moving bodies first share a point.
struct First_contact {
  /// Doubles about the exact time: lo <= t <= hi, equal where t is that double, else neighbours.
  double lo, hi;

  /// A part of A and one of B that meet then: a vertex and a face, or two edges. Of several pairs one; an edge may be one
  /// between triangles of a face. Nothing where the bodies collide at t = 0.
  std::optional<std::array<Holder, 2>> holder;
};

}  // namespace tetracone

#endif
