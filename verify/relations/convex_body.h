#ifndef TETRACONE_VERIFY_RELATIONS_CONVEX_BODY_H
#define TETRACONE_VERIFY_RELATIONS_CONVEX_BODY_H

#include "tetracone/covering/polyhedron.h"

namespace tetracone::verify {

/// True only when a polyhedron's solid is the convex hull of the vertices of its edges, and no face lies on one line.
/// It is false for some of these, such as one with a membrane inside.
///
/// Every face then has all vertices on one side of its plane, which leaves one region inside. That has a winding number
/// other than 0, since there is a volume. Requires a closed polyhedron.
bool is_convex(const covering::Polyhedron& what);

}  // namespace tetracone::verify

#endif
