// In the place of fcl_peer.cpp where FCL is not installed.

#include "experiments/peers/fcl.h"

namespace tetracone::experiments {

using covering::Polyhedron;

std::unique_ptr<Prepared_pair> prepare_fcl(const Polyhedron&, const Polyhedron&, double) { return nullptr; }
std::unique_ptr<Fcl_contacts> prepare_fcl_contacts(const Polyhedron&, const Polyhedron&, bool) { return nullptr; }

}  // namespace tetracone::experiments
