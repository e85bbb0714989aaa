#ifndef TETRACONE_VERIFY_RELATIONS_CONVEX_BODY_H
#define TETRACONE_VERIFY_RELATIONS_CONVEX_BODY_H

#include "tetracone/covering/polyhedron.h"

namespace tetracone::verify {

/// Requires a closed polyhedron. True when its solid is the convex hull of its vertices: every face has all of them on
/// one side, which leaves one region inside, and that has a winding number, for there is a volume.
bool is_convex(const covering::Polyhedron& what);

}  // namespace tetracone::verify

#endif
