#ifndef TETRACONE_EXPERIMENTS_PEERS_FCL_DISTANCE_H
#define TETRACONE_EXPERIMENTS_PEERS_FCL_DISTANCE_H

#include "experiments/peers/peer.h"

#include <memory>

namespace tetracone::experiments {

/// Another library's distance of two meshes, made ready once.
class Distance_peer {
 public:
  virtual ~Distance_peer() = default;
  /// Of their surfaces, in double; what it says of meshes that meet.
  virtual double distance(const kernel::Pose& pose_a, const kernel::Pose& pose_b) = 0;
};

/// FCL's, on trees of its oriented boxes with swept spheres, or of swept spheres alone; its own defaults. Null where the
/// build has no FCL.
std::unique_ptr<Distance_peer> fcl_obbrss_distance(const Peer_mesh& a, const Peer_mesh& b);
/// The same.
std::unique_ptr<Distance_peer> fcl_rss_distance(const Peer_mesh& a, const Peer_mesh& b);

}  // namespace tetracone::experiments

#endif
