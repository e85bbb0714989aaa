#ifndef TETRACONE_TETRATREE_DOOR_MOTION_SOLVER_H
#define TETRACONE_TETRATREE_DOOR_MOTION_SOLVER_H

#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/door/query_options.h"
#include "tetracone/tetratree/query/bvh8_motion.h"

#include <memory>
#include <string>

namespace tetracone::detail {

/// Throws Error for a kernel that cannot follow motions.
void require_motion_kernel(const Query_options& options);

/// Returns the fast tree of a body that motions can follow. Throws Error, in the name of `who`, where a face has no
/// triangles and is not on a line. Motions have no test for a face as a whole.
const tetratree::Bvh8& triangulated_tree(const Body_data& body, const std::string& who);

/// Finds when two moving bodies first meet. Compiled in solver/, as `triangulated_tree` is.
struct Motion_solver {
  /// Throws Error as `triangulated_tree`.
  Motion_solver(const std::shared_ptr<const Body_data>& a, const std::shared_ptr<const Body_data>& b);

  std::shared_ptr<const Body_data> a, b;
  tetratree::Bvh8_motion motion;
  bool began_in_contact = true;  // whether the last motion did; true at first, since the start costs little to ask
};

}  // namespace tetracone::detail

#endif
