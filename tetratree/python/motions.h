#ifndef TETRACONE_TETRATREE_PYTHON_MOTIONS_H
#define TETRACONE_TETRATREE_PYTHON_MOTIONS_H

#include "tetracone/tetratree/door/tetracone.h"

#include <pybind11/pybind11.h>

#include <cstddef>
#include <string>
#include <vector>

namespace tetracone::python {

/// The motions of a body, from poses at t = 0 to poses at t = 1. One pose at one end serves all poses at the other.
class Motions {
 public:
  /// Takes the poses at both ends. Messages call the body `body`; an empty text leaves the name out.
  ///
  /// - `kind` "linear": poses as `Poses` takes them.
  /// - `kind` "rigid": arrays (n, 7) or (7,) of a quaternion w x y z and a translation, or matrices that are rotations
  ///   (`kernel::rotation_quaternion`).
  ///
  /// Throws Error for anything but poses, with their place, and for counts that do not go together. Throws it also for
  /// quaternions between which one is 0, and for another kind.
  Motions(const pybind11::object& from, const pybind11::object& to, const std::string& kind, const std::string& body);

  /// True for one pose at both ends.
  bool is_one() const { return is_one_; }
  std::size_t count() const { return motions_.size(); }

  /// Returns motion `k`, or the only one.
  const Motion& operator()(std::size_t k) const { return motions_[motions_.size() == 1 ? 0 : k]; }

 private:
  bool is_one_ = true;
  std::vector<Motion> motions_;
};

}  // namespace tetracone::python

#endif
