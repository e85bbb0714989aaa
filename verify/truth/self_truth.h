#ifndef TETRACONE_VERIFY_TRUTH_SELF_TRUTH_H
#define TETRACONE_VERIFY_TRUTH_SELF_TRUTH_H

#include "tetracone/covering/polyhedron.h"
#include "verify/cases/case.h"
#include "verify/truth/contact_pieces.h"

namespace tetracone::verify {

/// Returns the pieces of `all` that are self-intersections of the body, face_a < face_b. A piece is none where a common
/// vertex of both faces holds it, or the union of their common edges. Vertices of equal coordinates are one. `all` is a
/// truth's list of contacts of the body with itself (`with_itself`).
Contact_forms improper_pieces(const Contact_forms& all, const covering::Polyhedron& body);

/// Returns the body and itself, both unmoved.
Object_case with_itself(const covering::Polyhedron& body);

}  // namespace tetracone::verify

#endif
