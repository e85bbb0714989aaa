#ifndef TETRACONE_TETRATREE_PYTHON_MOTIONS_H
#define TETRACONE_TETRATREE_PYTHON_MOTIONS_H

#include "tetracone/tetratree/door/tetracone.h"

#include <pybind11/pybind11.h>

#include <cstddef>
#include <string>
#include <vector>

namespace tetracone::python {

/// The motions of a body, from poses at t = 0 to poses at t = 1: one of either serves all of the other.
class Motions {
 public:
  /// `kind`: "linear", of poses as `Poses` takes them, or "rigid", of arrays (n, 7) or (7,), a quaternion w x y z and a
  /// translation, or of matrices that are rotations (`kernel::rotation_quaternion`). `body` is what messages call it,
  /// or nothing. Throws Error for poses that are none, with their place, for counts that do not go together, for
  /// quaternions between which one is 0, and for another kind.
  Motions(const pybind11::object& from, const pybind11::object& to, const std::string& kind, const std::string& body);

  /// True for one pose at either end.
  bool is_one() const { return is_one_; }
  std::size_t count() const { return motions_.size(); }

  /// Motion `k`, or the only one.
  const Motion& operator()(std::size_t k) const { return motions_[motions_.size() == 1 ? 0 : k]; }

 private:
  bool is_one_ = true;
  std::vector<Motion> motions_;
};

}  // namespace tetracone::python

#endif
