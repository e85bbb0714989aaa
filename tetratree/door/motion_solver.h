#ifndef TETRACONE_TETRATREE_DOOR_MOTION_SOLVER_H
#define TETRACONE_TETRATREE_DOOR_MOTION_SOLVER_H

#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/fast/bvh8_motion.h"

#include <memory>

namespace tetracone::detail {

/// When two bodies that move first meet.
struct Motion_solver {
  /// Throws Error where a face has no triangles, and is not flat to a line.
  Motion_solver(const std::shared_ptr<const Body_data>& a, const std::shared_ptr<const Body_data>& b);

  std::shared_ptr<const Body_data> a, b;
  tetratree::Bvh8_motion motion;
};

}  // namespace tetracone::detail

#endif
