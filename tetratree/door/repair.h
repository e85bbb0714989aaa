#ifndef TETRACONE_TETRATREE_DOOR_REPAIR_H
#define TETRACONE_TETRATREE_DOOR_REPAIR_H

// This uses parts of CGAL that are GPL, so whatever links tetracone::repair is GPL too.

#include "tetracone/tetratree/door/tetracone.h"

#include <filesystem>
#include <vector>

namespace tetracone {

/// A repaired polyhedron, and the changes.
struct Repaired {
  Polyhedron polyhedron;  ///< each face is exactly planar; an open surface may stay open
  std::vector<covering::Index>
      replaced;         ///< faces that were not planar, by their old numbers; each is now some triangles
  bool turned = false;  ///< faces were turned round so that the surface closes
};

/// Returns the polyhedron repaired. Each face that is not exactly planar, and no other, is replaced by triangles with
/// the same edges. Faces are turned round where that alone closes an open surface.
Repaired repaired(Polyhedron polyhedron);

/// Returns the body with its polygons triangulated where that is possible without new vertices. The triangles make
/// queries faster and change no answer. Throws as `Body`.
Body triangulated_body(Polyhedron polyhedron);

/// Returns the model of a file, repaired and triangulated. It reads and throws as `read_body`, but refuses saved
/// bodies.
Body read_repaired_body(const std::filesystem::path& file);

}  // namespace tetracone

#endif
