#ifndef TETRACONE_VERIFY_SHRINK_SHRINK_FACES_H
#define TETRACONE_VERIFY_SHRINK_SHRINK_FACES_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/predicate/question.h"

#include <functional>
#include <optional>

namespace tetracone::verify {

/// Tries to make a polyhedron smaller in every way that keeps it closed where the question is `solid`: fewer faces,
/// loops, corners, vertices. Whatever `accept` accepts is kept. `accept` is asked of smaller polyhedra only; some may
/// have faces that are not planar.
void shrink_faces(covering::Polyhedron polyhedron, kernel::Question question,
                  const std::function<bool(const covering::Polyhedron&)>& accept);

/// The polyhedron with fans of triangles, one for each loop, for each face that is no triangle: the same boundary, but
/// another surface where a face is not convex. Nothing where all faces are triangles.
std::optional<covering::Polyhedron> fanned(const covering::Polyhedron& polyhedron);

}  // namespace tetracone::verify

#endif
