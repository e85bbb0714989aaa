#ifndef TETRACONE_VERIFY_INTEGER_TRUTH_INTEGER_FEATURES_H
#define TETRACONE_VERIFY_INTEGER_TRUTH_INTEGER_FEATURES_H

#include "tetracone/kernel/predicate/contact.h"
#include "verify/cases/case.h"

#include <vector>

namespace tetracone::verify::integer_truth {

/// Returns all pairs (edge of one body, face of the other) that share a point, in both directions, with their kinds,
/// sorted. It is the second truth of `features` of `cgal_truth.h`. The first truth cuts an edge in a face's plane at
/// the loops and tests the middles of its parts. This one counts the different points of the edge that are on loops.
/// Requires det M != 0 and planar faces.
std::vector<kernel::Feature_pair> features(const Object_case& c);

}  // namespace tetracone::verify::integer_truth

#endif
