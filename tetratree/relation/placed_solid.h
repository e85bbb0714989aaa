#ifndef TETRACONE_TETRATREE_RELATION_PLACED_SOLID_H
#define TETRACONE_TETRATREE_RELATION_PLACED_SOLID_H

#include "tetracone/covering/location.h"
#include "tetracone/covering/polyhedron.h"
#include "tetracone/covering/side_windings.h"
#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/contact/rational_map.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/tetratree/locator/point_locator.h"
#include "tetracone/tetratree/relation/solid_sides.h"

#include <map>
#include <optional>

namespace tetracone::tetratree {

using kernel::difference;
using kernel::dot;
using kernel::is_zero;
using kernel::Rational;
using kernel::Rational_face;
using kernel::Rational_point;

/// Whether a solid is beside a point of a face: on the side to which a normal points (`along`), and on the other.
struct Normal_sides {
  bool along = false, against = false;

  /// True when some side of the point is not in the solid.
  bool any_out() const { return !along || !against; }
};

/// A solid under a pose, in rationals. The polyhedron, sides and locator that it is made of must outlive it.
class Placed_solid {
 public:
  /// All three are of one body.
  Placed_solid(const covering::Polyhedron& polyhedron, const Solid_sides& sides, const Point_locator& locator)
      : polyhedron_(&polyhedron), sides_(&sides), locator_(&locator)
  {}

  /// Moves the solid. Requires det M != 0.
  void place(const kernel::Pose& pose)
  {
    pose_ = pose;
    map_.reset();
    faces_.clear();
  }

  const covering::Polyhedron& polyhedron() const { return *polyhedron_; }
  const Solid_sides& sides() const { return *sides_; }
  const kernel::Pose& pose() const { return pose_; }

  /// Returns the pose in rationals, which is made when it is first asked for.
  const kernel::Rational_map& map() const
  {
    if (!map_) map_.emplace(pose_);
    return *map_;
  }

  /// Returns a placed face. The reference is valid until `place`.
  const Rational_face& face(Index f)
  {
    const auto known = faces_.find(f);
    if (known != faces_.end()) return known->second;
    return faces_.emplace(f, covering::rational_face(*polyhedron_, f, pose_)).first->second;
  }

  /// Returns whether a point of space is inside the placed solid, outside, or on its surface.
  covering::Location locate(const Rational_point& x) const { return locator_->locate(map().inverse(x)); }

  /// Returns the sides of a plain triangle along its placed normal.
  Normal_sides plain_sides(Index f) const
  {
    const Solid_sides::Face_sides& sides = sides_->of(f);
    return pose_.determinant_sign() > 0 ? Normal_sides{sides.front, sides.back} : Normal_sides{sides.back, sides.front};
  }

  /// Returns the sides of a point x of space along a normal. Requires that all faces with area that hold x lie in the
  /// plane of that normal, and hold x in their inside.
  Normal_sides sides_at(const Rational_point& x, const Rational_point& normal) const
  {
    Rational_point height;  // of the images of the model's axes, along the normal
    for (int k = 0; k < 3; ++k) height[k] = dot(map().column(k), normal);
    const int axis = kernel::largest_axis(height);
    const covering::Sides sides = covering::sides(*polyhedron_, map().inverse(x), axis);
    return height[axis] > 0 ? Normal_sides{sides.above, sides.below} : Normal_sides{sides.below, sides.above};
  }

 private:
  const covering::Polyhedron* polyhedron_;
  const Solid_sides* sides_;
  const Point_locator* locator_;
  kernel::Pose pose_;
  mutable std::optional<kernel::Rational_map> map_;
  std::map<Index, Rational_face> faces_;
};

}  // namespace tetracone::tetratree

#endif
