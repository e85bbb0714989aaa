#ifndef TETRACONE_COVERING_INCLUSION_H
#define TETRACONE_COVERING_INCLUSION_H

#include "tetracone/covering/location.h"
#include "tetracone/covering/model.h"
#include "tetracone/kernel/predicate/signs.h"

namespace tetracone::covering {

/// Returns +1 or -1 when the tetrahedron O W A B of the covering holds p, by its sign, else 0. This answer and those
/// below are exact where K's signs are.
///
/// p is moved by the infinitesimal (e, e^2, e^3) first, so it lies on no plane of any tetrahedron. The sum of the
/// results over the covering is the winding number of the moved point, and of p if p lies on no face. (Weights of 1/2
/// on shared facets, as often proposed, are wrong where p lies on an inner edge of the covering.)
template <class K>
int signed_inclusion(const kernel::Point<K>& p, const kernel::Point<K>& o, const kernel::Point<K>& w,
                     const kernel::Point<K>& a, const kernel::Point<K>& b)
{
  const kernel::Sign volume = kernel::volume_sign<K>(o, w, a, b);
  if (volume == kernel::ZERO) return 0;
  // The signs of p's barycentric coordinates of A, W, B and O: p must see each facet as the opposite corner does.
  const bool inside =
      kernel::perturbed_side<K>(o, b, w, p) == volume && kernel::perturbed_side<K>(o, a, b, p) == volume &&
      kernel::perturbed_side<K>(o, w, a, p) == volume && kernel::perturbed_side<K>(w, a, b, p) == -volume;
  return inside ? static_cast<int>(volume) : 0;
}

/// Returns the winding number of the placed polyhedron about p, as the signed sum over its covering (JS08 Theorem 1).
/// Requires p on no face and the polyhedron closed. A pose with det M < 0 reverses the sign.
template <class K>
int winding_number(const kernel::Point<K>& p, Placed_model<K>& body)
{
  const kernel::Point<K> origin = body.frame()(body.model().origin());
  int winding = 0;
  for (const Covering_triangle& t : body.model().covering().triangles())
    winding +=
        signed_inclusion<K>(p, origin, body.point(t.corner[0]), body.point(t.corner[1]), body.point(t.corner[2]));
  return winding;
}

/// Returns where p is relative to the placed solid, by the surface first, then the winding number. Requires the
/// polyhedron closed.
template <class K>
Location locate(const kernel::Point<K>& p, Placed_model<K>& body)
{
  for (Index f = 0; f < body.model().face_count(); ++f)
    if (segment_face<K>(p, p, body, f) != kernel::Contact::none) return Location::on_surface;
  return winding_number<K>(p, body) != 0 ? Location::inside : Location::outside;
}

}  // namespace tetracone::covering

#endif
