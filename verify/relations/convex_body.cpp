#include "verify/relations/convex_body.h"

#include "tetracone/covering/covering.h"
#include "tetracone/kernel/predicate/adaptive.h"

namespace tetracone::verify {

using covering::Index;
using kernel::Adaptive;

bool is_convex(const covering::Polyhedron& what)
{
  const covering::Covering covering(what);
  for (Index f = 0; f < what.face_count(); ++f) {
    const auto& base = covering.plane_basis(f);
    if (!base) return false;
    const auto point = [&](Index v) { return Adaptive::unmoved(what.vertices[v]); };
    CGAL::Sign side = CGAL::ZERO;
    for (const auto& [from, to] : covering.edges())
      for (const Index v : {from, to}) {
        const CGAL::Sign of_v =
            Adaptive::volume_sign(point((*base)[0]), point((*base)[1]), point((*base)[2]), point(v));
        if (of_v * side == CGAL::NEGATIVE) return false;
        if (of_v != CGAL::ZERO) side = of_v;
      }
  }
  return covering::volume(what) != 0;
}

}  // namespace tetracone::verify
