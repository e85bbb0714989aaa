#ifndef TETRACONE_VERIFY_TRUTH_CGAL_CONTACTS_H
#define TETRACONE_VERIFY_TRUTH_CGAL_CONTACTS_H

#include "verify/cases/case.h"
#include "verify/truth/contact_pieces.h"

namespace tetracone::verify {

/// Returns all maximal pieces of the intersections of faces, sorted: the truth. CGAL triangulates the faces and
/// intersects the triangles in rationals; the parts of each pair of faces are then joined. Requires det M != 0 and
/// planar faces.
Contact_forms contacts(const Object_case& c);

}  // namespace tetracone::verify

#endif
