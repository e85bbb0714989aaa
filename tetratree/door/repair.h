#ifndef TETRACONE_TETRATREE_DOOR_REPAIR_H
#define TETRACONE_TETRATREE_DOOR_REPAIR_H

// By parts of CGAL that are GPL, and so is what links this: tetracone::repair.

#include "tetracone/tetratree/door/tetracone.h"

#include <filesystem>
#include <vector>

namespace tetracone {

/// A polyhedron made legal, and what was done to it.
struct Repaired {
  Polyhedron polyhedron;                  ///< what is legal now
  std::vector<covering::Index> replaced;  ///< faces that were not planar, each now some triangles; numbers of before
  bool turned = false;                    ///< faces were turned round so that the surface closes
};

/// Replaces each face that is not exactly planar, that face alone, by triangles with the same edges; turns faces round
/// where that alone closes an open surface.
Repaired repaired(Polyhedron polyhedron);

/// The body with its polygons triangulated where that is possible without new vertices, which makes queries faster and
/// changes no answer. Throws as `Body`.
Body triangulated_body(Polyhedron polyhedron);

/// Reads a model as `read_body` does, repaired and triangulated.
Body read_repaired_body(const std::filesystem::path& file);

}  // namespace tetracone

#endif
