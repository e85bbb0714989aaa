#ifndef TETRACONE_VERIFY_TRUTH_MINKOWSKI_TRUTH_H
#define TETRACONE_VERIFY_TRUTH_MINKOWSKI_TRUTH_H

#include "tetracone/kernel/number/number.h"
#include "verify/cases/case.h"

#include <optional>

/// The depth of non-convex solids, by CGAL's Minkowski sum of Nef polyhedra.
namespace tetracone::verify {

/// Returns the squared length of the least translation of A after which the interiors share no point; 0 where they
/// share none. The translations that leave a common point are the Minkowski sum of the interiors of B and of -A. It is
/// open, so exact fits are slits in it. The depth is the distance of 0 from its complement.
///
/// Returns nothing where a surface is not one connected manifold that is free of self-intersections. The time grows
/// with the product of the convex parts: 0.1 s for two prisms over an L. Requires planar faces and det M != 0.
std::optional<kernel::Rational> minkowski_squared_depth(const Object_case& c);

}  // namespace tetracone::verify

#endif
