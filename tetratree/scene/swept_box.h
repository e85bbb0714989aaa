#ifndef TETRACONE_TETRATREE_SCENE_SWEPT_BOX_H
#define TETRACONE_TETRATREE_SCENE_SWEPT_BOX_H

#include "tetracone/kernel/motion/control_poses.h"
#include "tetracone/tetratree/scene/world_box.h"

namespace tetracone::tetratree {

/// Returns a box that holds the body at every time of its motion; all of space where there is no bound. It is the least
/// box about `box_of(pose)` for all control poses, whose hull holds the motion. `box_of` returns a box about the body's
/// image under a pose, which may be singular.
///
/// No error bound of its own is needed: a box is convex, so one that holds a point's images holds their hull.
template <class Box_of>
World_box swept_box(const kernel::Body_motion& motion, const Box_of& box_of)
{
  const auto poses = kernel::control_poses(motion);
  if (!poses) return {};
  World_box box = box_of(poses->front());
  for (std::size_t k = 1; k < poses->size(); ++k) box = box.joined(box_of((*poses)[k]));
  return box;
}

}  // namespace tetracone::tetratree

#endif
