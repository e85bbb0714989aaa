#ifndef TETRACONE_TETRATREE_DOOR_CONTACT_NORMALS_H
#define TETRACONE_TETRATREE_DOOR_CONTACT_NORMALS_H

#include "tetracone/tetratree/door/contacts.h"

#include <array>
#include <cstddef>

namespace tetracone {

/// Returns the unit normals of the placed faces of A and of B of piece k: outward where faces are oriented outward, also
/// under a pose that mirrors. Bounds of a coordinate are equal or neighbours. All are 0 for a face without area.
/// Requires k < contacts.size().
std::array<Enclosure, 2> contact_normals(const Contacts& contacts, std::size_t k);

}  // namespace tetracone

#endif
