#ifndef TETRACONE_VERIFY_TRUTH_EXIT_TRUTH_H
#define TETRACONE_VERIFY_TRUTH_EXIT_TRUTH_H

#include "verify/cases/case.h"
#include "verify/cases/exact_map.h"

#include <optional>

/// Two formulations tell how far A must move along a direction to leave B, and two others the least translation. All
/// are in rationals.
namespace tetracone::verify {

/// Returns the exits, by all events of all pairs. An event is a shift at which a vertex is on a triangle, or an edge on
/// an edge; between two of them nothing changes. At each event, in order, the pieces of both surfaces tell whether the
/// interiors share a point. The time grows fast with the faces. Requires planar faces, closed polyhedra, det M != 0 and
/// a direction that is not 0. Throws std::invalid_argument for a face that is not exactly planar, and for an open
/// surface.
Solid_exits exits_by_events(const Object_case& c, const object_family::Exact_vector& direction);

/// Returns the exit of convex solids whose interiors share a point, else 0. It is the least exit by a normal of the
/// Minkowski difference: of a face, or a product of two edges. Requires convex solids.
kernel::Rational convex_exit(const Object_case& c, const object_family::Exact_vector& direction);

/// Returns the squared length of the least translation that parts convex solids: the least over the same normals; 0
/// where the interiors share no point. Requires convex solids.
kernel::Rational convex_squared_depth(const Object_case& c);

/// Returns the squared length of the least translation of A after which the interiors share no point; 0 where they
/// share none. The translations that leave a common point are the Minkowski sum of the interiors of B and of -A. It is
/// open, so exact fits are slits in it. The depth is the distance of 0 from its complement.
///
/// Returns nothing where a surface is not one connected manifold that is free of self-intersections. The time grows
/// with the product of the convex parts: 0.1 s for two prisms over an L. Requires planar faces and det M != 0.
std::optional<kernel::Rational> minkowski_squared_depth(const Object_case& c);

}  // namespace tetracone::verify

#endif
