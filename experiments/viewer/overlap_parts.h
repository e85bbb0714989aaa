#ifndef TETRACONE_EXPERIMENTS_VIEWER_OVERLAP_PARTS_H
#define TETRACONE_EXPERIMENTS_VIEWER_OVERLAP_PARTS_H

#include "tetracone/kernel/number/pose.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <array>
#include <memory>
#include <vector>

namespace tetracone::experiments {

/// The parts of the faces of two solids that bound their overlap. The library makes no mesh of an overlap.
class Overlap_parts {
 public:
  using Corners = std::vector<std::array<double, 3>>;  // three or four, of which two may be equal

  /// Requires closed bodies.
  Overlap_parts(const Body& a, const Body& b);
  ~Overlap_parts();

  /// Returns convex parts of faces, each point of the overlap's surface with area in one of them. Corners are the
  /// nearest doubles, anticlockwise as seen from outside the overlap. Requires det M != 0.
  std::vector<Corners> at(const kernel::Pose& pose_a, const kernel::Pose& pose_b);

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace tetracone::experiments

#endif
