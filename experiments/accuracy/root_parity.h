#ifndef TETRACONE_EXPERIMENTS_ACCURACY_ROOT_PARITY_H
#define TETRACONE_EXPERIMENTS_ACCURACY_ROOT_PARITY_H

#include "tetracone/kernel/motion/moving_pair.h"

namespace tetracone::experiments {

/// True when the moving primitives meet an odd number of times, by Brochu, Edwards and Bridson (2012). The differences
/// of their points, over time and both primitives' parameters, form a body whose boundary consists of triangles and
/// bilinear patches. A ray from the origin crosses it an odd number of times if an odd number of roots is within. An
/// origin on the boundary is a contact. It computes in rationals, without rounding. It does not notice an even number
/// of contacts.
bool meet_by_root_parity(const kernel::Moving_pair& pair);

}  // namespace tetracone::experiments

#endif
