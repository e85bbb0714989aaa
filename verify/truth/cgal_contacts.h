#ifndef TETRACONE_VERIFY_TRUTH_CGAL_CONTACTS_H
#define TETRACONE_VERIFY_TRUTH_CGAL_CONTACTS_H

#include "verify/cases/case.h"
#include "verify/truth/contact_pieces.h"

namespace tetracone::verify {

/// All maximal pieces of what pairs of faces share, sorted: the truth. Faces are triangulated by CGAL, triangles are
/// intersected by CGAL in rationals, and the parts of a pair of faces are joined. Requires det M != 0 and planar faces.
Contact_forms contacts(const Object_case& c);

}  // namespace tetracone::verify

#endif
