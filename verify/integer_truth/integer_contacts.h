#ifndef TETRACONE_VERIFY_INTEGER_TRUTH_INTEGER_CONTACTS_H
#define TETRACONE_VERIFY_INTEGER_TRUTH_INTEGER_CONTACTS_H

#include "verify/cases/case.h"
#include "verify/truth/contact_pieces.h"

namespace tetracone::verify::integer_truth {

/// Returns the contacts by the second truth, sorted, with the polygons of a pair of faces joined into one.
/// `cgal_truth.h` has the first. Nothing is triangulated: edges are cut where they meet the other face or each other.
/// The turns of the loops about a part's middle tell which areas beside it, or in it, are shared. Requires det M != 0
/// and planar faces.
Contact_forms contacts(const Object_case& c);

}  // namespace tetracone::verify::integer_truth

#endif
