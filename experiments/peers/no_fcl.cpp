// In the place of fcl_peer.cpp where FCL is not installed.

#include "experiments/peers/fcl.h"

namespace tetracone::experiments {

using covering::Polyhedron;

std::unique_ptr<Prepared_pair> prepare_fcl(const Polyhedron&, const Polyhedron&, double) { return nullptr; }
std::unique_ptr<Fcl_contacts> prepare_fcl_contacts(const Polyhedron&, const Polyhedron&, bool) { return nullptr; }
std::unique_ptr<Distance_peer> fcl_obbrss_distance(const Peer_mesh&, const Peer_mesh&) { return nullptr; }
std::unique_ptr<Distance_peer> fcl_rss_distance(const Peer_mesh&, const Peer_mesh&) { return nullptr; }
std::unique_ptr<Motion_peer> fcl_advancement(const Peer_mesh&, const Peer_mesh&) { return nullptr; }
std::unique_ptr<Motion_peer> fcl_steps(const Peer_mesh&, const Peer_mesh&) { return nullptr; }
std::span<const Named_motion_peer> motion_peers() { return {}; }

}  // namespace tetracone::experiments
