#ifndef TETRACONE_COVERING_IO_WRITE_H
#define TETRACONE_COVERING_IO_WRITE_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/number.h"

#include <cassert>
#include <string>

namespace tetracone::covering {

namespace write {

/// Returns "x y z", each the shortest decimal that reads back as exactly that double.
inline std::string coordinates(const Vertex& v)
{
  return kernel::shortest(v[0]) + ' ' + kernel::shortest(v[1]) + ' ' + kernel::shortest(v[2]);
}

}  // namespace write

/// Returns the polyhedron as the text of an OFF file; `read` gives exactly the same vertices and faces. Requires faces
/// of one loop each, since OFF has no holes.
inline std::string write_off(const Polyhedron& polyhedron)
{
  std::string text =
      "OFF\n" + std::to_string(polyhedron.vertices.size()) + ' ' + std::to_string(polyhedron.face_count()) + " 0\n";
  for (const Vertex& v : polyhedron.vertices) text += write::coordinates(v) + '\n';
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    assert(polyhedron.loop_count(f) == 1);
    const Loop loop = polyhedron.loop(f, 0);
    text += std::to_string(loop.size());
    for (const Index v : loop) text += ' ' + std::to_string(v);
    text += '\n';
  }
  return text;
}

}  // namespace tetracone::covering

#endif
