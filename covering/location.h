#ifndef TETRACONE_COVERING_LOCATION_H
#define TETRACONE_COVERING_LOCATION_H

namespace tetracone::covering {

/// The position of a point relative to a solid.
enum class Location { outside = -1, on_surface = 0, inside = 1 };

}  // namespace tetracone::covering

#endif
