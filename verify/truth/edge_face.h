#ifndef TETRACONE_VERIFY_TRUTH_EDGE_FACE_H
#define TETRACONE_VERIFY_TRUTH_EDGE_FACE_H

#include "tetracone/kernel/predicate/contact.h"
#include "verify/truth/planar_face.h"

namespace tetracone::verify {

using kernel::Contact;

/// Returns how the closed edge between two points, which may be equal, meets the face.
Contact edge_face(const Exact::Point_3& from, const Exact::Point_3& to, const Planar_face& face);

}  // namespace tetracone::verify

#endif
