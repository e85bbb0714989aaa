#ifndef TETRACONE_VERIFY_TRUTH_OVERLAP_TRUTH_H
#define TETRACONE_VERIFY_TRUTH_OVERLAP_TRUTH_H

#include "verify/cases/case.h"

namespace tetracone::verify {

/// Returns the truth, in rationals, for all legal bodies: the relation of two placed solids, the dimension of what
/// their surfaces share, and their overlap. The surfaces are cut along each other and along themselves. The winding
/// numbers on both sides of each piece then say everything:
///
/// 1. A region of space between the surfaces is bounded by pieces, which say whether A and B have it. The region that
///    goes to infinity belongs to neither.
/// 2. A solid's interior is bounded by those pieces of its surface that have winding number 0 on a side. Its segments
///    and points where that number is 0 bound it too.
/// 3. A lies in B when no region is of A alone, and no piece of A's surface is off B.
///
/// Requires det M != 0 and planar faces. Throws std::invalid_argument when a body is not closed.
Solid_overlap solid_overlap(const Object_case& c);

/// Does the same, and stores the area that the surfaces share. A piece that lies on several triangles counts once.
Solid_overlap solid_overlap(const Object_case& c, Shared_area& shared);

}  // namespace tetracone::verify

#endif
