#ifndef TETRACONE_EXPERIMENTS_ACCURACY_ROOT_PARITY_H
#define TETRACONE_EXPERIMENTS_ACCURACY_ROOT_PARITY_H

#include "tetracone/kernel/motion/moving_pair.h"

namespace tetracone::experiments {

/// Whether the moving primitives meet an odd number of times, by Brochu, Edwards and Bridson (2012): the differences of
/// their points, over time and both primitives' parameters, are a body whose boundary is made of triangles and bilinear
/// patches; a ray from the origin crosses it an odd number of times where an odd number of roots is within. An origin
/// on the boundary is a contact. In rationals, without rounding. An even number of contacts is not noticed.
bool meet_by_root_parity(const kernel::Moving_pair& pair);

}  // namespace tetracone::experiments

#endif
