#ifndef TETRACONE_VERIFY_TEST_VERIFY_SAME_BODY_H
#define TETRACONE_VERIFY_TEST_VERIFY_SAME_BODY_H

#include "tetracone/covering/polyhedron.h"

#include <algorithm>
#include <cstddef>

namespace tetracone::verify {

/// True when two bodies have equal vertices, and faces of equal loops, in the same order.
inline bool same(const covering::Polyhedron& a, const covering::Polyhedron& b)
{
  if (a.vertices != b.vertices || a.face_count() != b.face_count()) return false;
  for (covering::Index f = 0; f < a.face_count(); ++f) {
    if (a.loop_count(f) != b.loop_count(f)) return false;
    for (std::size_t l = 0; l < a.loop_count(f); ++l)
      if (!std::ranges::equal(a.loop(f, l), b.loop(f, l))) return false;
  }
  return true;
}

}  // namespace tetracone::verify

#endif
