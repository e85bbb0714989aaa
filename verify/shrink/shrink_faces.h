#ifndef TETRACONE_VERIFY_SHRINK_SHRINK_FACES_H
#define TETRACONE_VERIFY_SHRINK_SHRINK_FACES_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/predicate/question.h"

#include <functional>
#include <optional>

namespace tetracone::verify {

/// Tries every way to make a polyhedron smaller that keeps it closed if the question is `solid`: fewer faces, loops,
/// corners, vertices. It keeps every change that `accept` accepts. `accept` is first asked of the polyhedron without
/// unused vertices, which may be the polyhedron itself; then of smaller ones. Some may have faces that are not planar.
void shrink_faces(covering::Polyhedron polyhedron, kernel::Question question,
                  const std::function<bool(const covering::Polyhedron&)>& accept);

/// Returns the polyhedron with a fan of triangles for each loop of each face that is no triangle. The boundary is
/// unchanged, but the surface differs where a face is not convex. Nothing if all faces are triangles.
std::optional<covering::Polyhedron> fanned(const covering::Polyhedron& polyhedron);

}  // namespace tetracone::verify

#endif
