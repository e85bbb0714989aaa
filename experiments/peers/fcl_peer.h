#ifndef TETRACONE_EXPERIMENTS_PEERS_FCL_PEER_H
#define TETRACONE_EXPERIMENTS_PEERS_FCL_PEER_H

#include "experiments/peers/prepared_pair.h"
#include "tetracone/covering/polyhedron.h"

#include <memory>

namespace tetracone::experiments {

/// FCL (Debian's package) on BVHModel<OBBRSS> of doubles, as its users run it: one contact, no cost. It always answers
/// the *surface* question, since it has no solids. Faces are triangulated. Its transforms are rigid, so a pose must be
/// a rotation times a power of two; the scale is applied to the body's vertices, exactly. Null when the program was
/// built without FCL.
std::unique_ptr<Prepared_pair> prepare_fcl(const covering::Polyhedron& a, const covering::Polyhedron& b,
                                           double scale_b);

}  // namespace tetracone::experiments

#endif
