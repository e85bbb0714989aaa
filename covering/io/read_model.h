#ifndef TETRACONE_COVERING_IO_READ_MODEL_H
#define TETRACONE_COVERING_IO_READ_MODEL_H

#include "tetracone/covering/polyhedron.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tetracone::covering {

/// A polyhedron as a file gave it, and the changes that reading made.
struct Read_model {
  std::string name;  ///< the file's name without its folder
  Polyhedron polyhedron;
  std::size_t loops_turned = 0;    ///< hole loops of a .poly file that were turned against their outer loop
  std::size_t facets_turned = 0;   ///< facets of a .poly file that were oriented across their edges
  std::vector<std::string> notes;  ///< what else a user should know, one sentence each
};

}  // namespace tetracone::covering

#endif
