#ifndef TETRACONE_EXPERIMENTS_PEERS_FCL_DISTANCE_H
#define TETRACONE_EXPERIMENTS_PEERS_FCL_DISTANCE_H

#include "experiments/peers/peer.h"

#include <memory>

namespace tetracone::experiments {

/// Another library's distance of two meshes, prepared once.
class Distance_peer {
 public:
  virtual ~Distance_peer() = default;
  /// Returns the distance of the surfaces, in double; for meshes that meet, whatever the library returns.
  virtual double distance(const kernel::Pose& pose_a, const kernel::Pose& pose_b) = 0;
};

/// FCL's distance with its default settings, on trees of oriented boxes with swept spheres (OBBRSS). Null when the
/// build has no FCL.
std::unique_ptr<Distance_peer> fcl_obbrss_distance(const Peer_mesh& a, const Peer_mesh& b);
/// FCL's distance on trees of swept spheres alone (RSS), otherwise as above.
std::unique_ptr<Distance_peer> fcl_rss_distance(const Peer_mesh& a, const Peer_mesh& b);

}  // namespace tetracone::experiments

#endif
