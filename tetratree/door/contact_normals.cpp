#include "tetracone/tetratree/door/contact_normals.h"

#include "tetracone/kernel/contact/rational_map.h"
#include "tetracone/kernel/number/nearest_root.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/door/contacts_data.h"

#include <array>
#include <cstddef>
#include <utility>

namespace tetracone {
namespace {

using kernel::Rational;
using kernel::Rational_point;

/// Returns the unit vector along the image of a face's normal n under the inverse transpose of M. Where det M < 0, the
/// placed loops turn the other way as seen from outside, and the image of n still points outward.
Enclosure placed_normal(const detail::Body_data& body, Index face, const kernel::Pose& pose)
{
  const Rational_point n = detail::exact_normal(body.polyhedron, face);
  const kernel::Rational_map map(pose);
  Rational_point along = {0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational_point column = kernel::cross(map.column(int(k + 1) % 3), map.column(int(k + 2) % 3));
    for (std::size_t i = 0; i < 3; ++i) along[i] += sgn(map.determinant()) * n[k] * column[i];
  }
  const Rational square = kernel::dot(along, along);
  Enclosure unit{};
  if (sgn(square) == 0) return unit;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [low, high] = kernel::enclosed_root_sum(std::array{Rational(along[i] * along[i] / square)});
    unit.lower[i] = sgn(along[i]) < 0 ? -high : low;
    unit.upper[i] = sgn(along[i]) < 0 ? -low : high;
  }
  return unit;
}

}  // namespace

std::array<Enclosure, 2> contact_normals(const Contacts& contacts, std::size_t k)
{
  const detail::Contacts_data& data = contacts.data();
  const tetratree::Found_piece& piece = data.found.pieces[k];
  return {placed_normal(*data.a, piece.face_a, data.pose_a), placed_normal(*data.b, piece.face_b, data.pose_b)};
}

}  // namespace tetracone
