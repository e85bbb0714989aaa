#include "tetracone/tetratree/relation/solid_sides.h"

#include "tetracone/tetratree/door/body_data.h"

#include <memory>
#include <mutex>

namespace tetracone {

const tetratree::Solid_sides& detail::Body_data::solid_sides() const
{
  std::call_once(solid_sides_once_,
                 [this] { solid_sides_ = std::make_shared<const tetratree::Solid_sides>(bvh8(), polyhedron); });
  return *solid_sides_;
}

}  // namespace tetracone
