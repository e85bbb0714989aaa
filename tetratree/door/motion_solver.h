#ifndef TETRACONE_TETRATREE_DOOR_MOTION_SOLVER_H
#define TETRACONE_TETRATREE_DOOR_MOTION_SOLVER_H

#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/door/query_options.h"
#include "tetracone/tetratree/fast/bvh8_motion.h"

#include <memory>
#include <string>

namespace tetracone::detail {

/// Throws Error for a kernel that follows no motion.
void require_motion_kernel(const Query_options& options);

/// The tree of a body that motions can follow. Throws Error, of `who`, where a face has no triangles and is not flat to
/// a line: motions know no test for a face as a whole.
const tetratree::Bvh8& triangulated_tree(const Body_data& body, const std::string& who);

/// When two bodies that move first meet.
struct Motion_solver {
  /// Throws Error as `triangulated_tree`.
  Motion_solver(const std::shared_ptr<const Body_data>& a, const std::shared_ptr<const Body_data>& b);

  std::shared_ptr<const Body_data> a, b;
  tetratree::Bvh8_motion motion;
  bool began_in_contact = true;  // the last motion asked for; before the first one what costs little is asked first
};

}  // namespace tetracone::detail

#endif
