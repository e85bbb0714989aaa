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

/// The motion of a body over t in [0, 1], taken exactly. Immutable; copies are cheap. Making one of poses or numbers
/// throws Error when the thread's floating point is not as exact answers need it.
class Motion {
 public:
  /// Returns the motion in which every point moves on a line, at constant speed, from its image under `from` to its
  /// image under `to`: M(t) = (1-t) M0 + t M1. Between them M(t) may be singular; then the image is flat.
  static Motion linear(const Pose& from, const Pose& to);

  /// Returns the motion that rotates by the quaternion q(t) = (1-t) q0 + t q1 and translates on a line. q(t) is not
  /// normalised, so the angular velocity is not constant. An argument is w x y z of a quaternion of any length above 0,
  /// then the translation. Throws Error for a number that is not finite, and where q(t) = 0 for some t.
  static Motion rigid(const std::array<double, 7>& from, const std::array<double, 7>& to);

  /// Returns `rigid` of decimals, which stand for the nearest doubles, or fractions "n/d". Throws Error as `rigid`, and
  /// for a text that is no number.
  static Motion rigid_from_text(const std::array<std::string, 7>& from, const std::array<std::string, 7>& to);

  /// A motion as the library's templates take it.
  explicit Motion(kernel::Body_motion motion);
  /// Returns the motion as the library's templates take it.
  const kernel::Body_motion& exact() const { return *exact_; }

 private:
  std::shared_ptr<const kernel::Body_motion> exact_;
};

/// The first time at which two moving bodies share a point.
struct First_contact {
  double lo;  ///< lo <= t; equal to hi where t is a double
  double hi;  ///< t <= hi, the next double after lo where they differ

  /// A part of A and a part of B that meet then: a vertex and a face, or two edges. An edge without length is a vertex.
  /// Where several pairs meet, it is one of them. An edge may be a diagonal, between two triangles of one face. Nothing
  /// where the bodies collide at t = 0.
  std::optional<std::array<Holder, 2>> holder;
};

}  // namespace tetracone

#endif
