#ifndef TETRACONE_VERIFY_FAMILIES_OBJECT_CORPUS_H
#define TETRACONE_VERIFY_FAMILIES_OBJECT_CORPUS_H

#include "tetracone/kernel/number/number.h"

#include <array>
#include <vector>

/// Small configurations that some subject answered wrongly: two tetrahedra each, without poses.
namespace tetracone::verify::object_family {

struct Corpus_entry {
  const char* what;
  std::array<kernel::Vertex, 4> a, b;
};

inline const std::vector<Corpus_entry>& object_corpus()
{
  static const std::vector<Corpus_entry> entries = {
      {"a segment whose first end is on the triangle's plane, outside its solid side: dropped by a sign test with one "
       "sign turned",
       {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -4}}},
       {{{1, 1, 0}, {2, 1, 3}, {1, 2, 3}, {0, 0, 3}}}},
      {"coplanar triangles that share a vertex: rejected with all coplanar segments",
       {{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, -2}}},
       {{{0, 0, 0}, {-3, 0, 0}, {0, -3, 0}, {-1, -1, 2}}}},
      {"0.1 + 0.2 against 0.3: the face is past the vertex by an ulp",
       {{{0.3, -1, -1}, {0.3, 1, -1}, {0.3, 0, 1}, {-1, 0, 0}}},
       {{{0.1 + 0.2, 0, 0}, {2, 1, 0}, {2, -1, 0}, {2, 0, 1}}}},
      {"a vertex on the diagonal of thirds, which no double meets",
       {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
       {{{1 / 3.0, 1 / 3.0, 1 / 3.0}, {1, 1, 1}, {2, 1, 1}, {1, 2, 1}}}},
      {"nested, surfaces far from each other: no contact to be found",
       {{{-9, -9, -9}, {27, -9, -9}, {-9, 27, -9}, {-9, -9, 27}}},
       {{{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}}}},
      {"edges that cross in the middle of both: all five volumes but two are zero",
       {{{-1, 0, 0}, {1, 0, 0}, {0, 1, -1}, {0, -1, -1}}},
       {{{0, -1, 0}, {0, 1, 0}, {1, 0, 1}, {-1, 0, 1}}}},
      {"a tetrahedron of no volume on a face: its own cones are flat",
       {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}}},
       {{{0.5, 0.5, 0}, {1, 0.5, 0}, {0.5, 1, 0}, {0.25, 0.25, 0}}}},
      {"a flat tetrahedron with corners on one line, through a vertex",
       {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}}},
       {{{-1, -1, -1}, {0, 0, 0}, {-2, -2, -2}, {-3, -3, -2}}}},
      {"heights whose products underflow",
       {{{0, 0, 0}, {0x1p-400, 0, 0}, {0, 0x1p-400, 0}, {0, 0, -0x1p-400}}},
       {{{0x1p-402, 0x1p-402, 0}, {0, 0, 0x1p-400}, {0x1p-400, 0, 0x1p-400}, {0, 0x1p-400, 0x1p-400}}}},
      {"a long thin face and a vertex near its end, on its line",
       {{{0, 0, 0}, {1, 1, 1}, {0x1.0000000000001p0, 1, 1}, {0, 0, -1}}},
       {{{0.75, 0.75, 0.75}, {1, 0, 3}, {0, 1, 3}, {1, 1, 4}}}},
  };
  return entries;
}

}  // namespace tetracone::verify::object_family

#endif
