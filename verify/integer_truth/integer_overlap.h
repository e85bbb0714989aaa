#ifndef TETRACONE_VERIFY_INTEGER_TRUTH_INTEGER_OVERLAP_H
#define TETRACONE_VERIFY_INTEGER_TRUTH_INTEGER_OVERLAP_H

#include "verify/cases/case.h"

#include <gmpxx.h>

namespace tetracone::verify::integer_truth {

/// The volumes of the intersection of two solids and of their two differences.
struct Volumes {
  mpq_class both, only_a, only_b;
};

/// Returns the volumes of two placed solids. Lines along z are cut where they meet the faces, and the windings above
/// each part tell to which solids it belongs. Between critical y, the lengths on such lines are linear in y. Between
/// critical x, the areas of sections are quadratic in x. So volumes are finite sums of lengths. For few faces: the time
/// grows with the fourth power of their number. Requires det M != 0, planar faces and closed polyhedra.
Volumes volumes(const Object_case& c);

/// True when the volumes do not contradict what is said of the relation and of the overlap's volume.
bool agrees(const Volumes& volumes, const Solid_overlap& overlap);

}  // namespace tetracone::verify::integer_truth

#endif
