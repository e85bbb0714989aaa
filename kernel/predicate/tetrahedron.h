#ifndef TETRACONE_KERNEL_PREDICATE_TETRAHEDRON_H
#define TETRACONE_KERNEL_PREDICATE_TETRAHEDRON_H

#include "tetracone/kernel/predicate/signs.h"

namespace tetracone::kernel {

/// True when p lies in the closed tetrahedron v0 v1 v2 v3, which is not flat: no barycentric coordinate is negative.
/// Coordinate i is the signed volume of the tetrahedron with v_i replaced by p, over its volume (JS08 section 2.2.1).
template <class K>
bool is_in_tetrahedron(const Point<K>& p, const Point<K>& v0, const Point<K>& v1, const Point<K>& v2,
                       const Point<K>& v3)
{
  const Sign volume = volume_sign<K>(v0, v1, v2, v3);
  return volume != ZERO && volume_sign<K>(p, v1, v2, v3) * volume != NEGATIVE &&
         volume_sign<K>(v0, p, v2, v3) * volume != NEGATIVE && volume_sign<K>(v0, v1, p, v3) * volume != NEGATIVE &&
         volume_sign<K>(v0, v1, v2, p) * volume != NEGATIVE;
}

/// True when p lies in the closed tetra-cone of the positively oriented tetrahedron v0 v1 v2 v3. The signs at v1, v2
/// and v3 decide (JS08 Definition 3 and section 2.2.1).
template <class K>
bool is_in_tetra_cone(const Point<K>& p, const Point<K>& v0, const Point<K>& v1, const Point<K>& v2, const Point<K>& v3)
{
  return volume_sign<K>(v0, p, v2, v3) != NEGATIVE && volume_sign<K>(v0, v1, p, v3) != NEGATIVE &&
         volume_sign<K>(v0, v1, v2, p) != NEGATIVE;
}

}  // namespace tetracone::kernel

#endif
