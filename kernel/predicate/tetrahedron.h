#ifndef TETRACONE_KERNEL_PREDICATE_TETRAHEDRON_H
#define TETRACONE_KERNEL_PREDICATE_TETRAHEDRON_H

#include "tetracone/kernel/predicate/signs.h"

#include <array>

namespace tetracone::kernel {

/// The place of a point relative to a closed tetrahedron, with the kind of the element of its boundary that holds it.
enum class In_tetrahedron { outside, vertex, edge, face, inside, flat };

/// The signs of the barycentric coordinates of a point with regard to the tetrahedron v0 v1 v2 v3: coordinate i is the
/// signed volume of the tetrahedron with v_i replaced by the point, over the volume of the tetrahedron (JS08
/// section 2.2.1).
struct Barycentric_signs {
  std::array<Sign, 4> coordinate;  ///< all ZERO when the tetrahedron is flat
  Sign volume;                     ///< of the tetrahedron: its orientation

  /// Returns the element that holds the point: a face for one coordinate ZERO, an edge for two, a vertex for three.
  In_tetrahedron feature() const
  {
    if (volume == ZERO) return In_tetrahedron::flat;
    int zeros = 0;
    for (const Sign sign : coordinate) {
      if (sign == NEGATIVE) return In_tetrahedron::outside;
      zeros += sign == ZERO;
    }
    constexpr std::array features = {In_tetrahedron::inside, In_tetrahedron::face, In_tetrahedron::edge,
                                     In_tetrahedron::vertex};
    return zeros < 4 ? features[zeros] : In_tetrahedron::outside;  // the coordinates sum to 1: not all are zero
  }
};

template <class K>
Barycentric_signs barycentric_signs(const Point<K>& p, const Point<K>& v0, const Point<K>& v1, const Point<K>& v2,
                                    const Point<K>& v3)
{
  const Sign volume = volume_sign<K>(v0, v1, v2, v3);
  return {{volume_sign<K>(p, v1, v2, v3) * volume, volume_sign<K>(v0, p, v2, v3) * volume,
           volume_sign<K>(v0, v1, p, v3) * volume, volume_sign<K>(v0, v1, v2, p) * volume},
          volume};
}

/// True when p lies in the closed tetra-cone of the positively oriented tetrahedron v0 v1 v2 v3: three of the four
/// signs, those at v1, v2 and v3 (JS08 Definition 3 and section 2.2.1).
template <class K>
bool is_in_tetra_cone(const Point<K>& p, const Point<K>& v0, const Point<K>& v1, const Point<K>& v2, const Point<K>& v3)
{
  return volume_sign<K>(v0, p, v2, v3) != NEGATIVE && volume_sign<K>(v0, v1, p, v3) != NEGATIVE &&
         volume_sign<K>(v0, v1, v2, p) != NEGATIVE;
}

}  // namespace tetracone::kernel

#endif
