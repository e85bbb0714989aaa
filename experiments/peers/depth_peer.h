#ifndef TETRACONE_EXPERIMENTS_PEERS_DEPTH_PEER_H
#define TETRACONE_EXPERIMENTS_PEERS_DEPTH_PEER_H

#include "experiments/peers/peer.h"

namespace tetracone::experiments {

/// Another library's penetration of two convex meshes, prepared once.
class Depth_peer {
 public:
  virtual ~Depth_peer() = default;
  /// Returns how deep the meshes penetrate each other under rigid poses, as the library tells it; nothing where it says
  /// that they are apart. Throws what the library throws.
  virtual std::optional<double> depth(const kernel::Pose& pose_a, const kernel::Pose& pose_b) = 0;
};

/// A depth peer by its name.
struct Named_depth_peer {
  const char* name;
  const char* note;  ///< how it is asked
  /// Requires closed convex meshes whose triangles are counterclockwise as seen from outside.
  std::unique_ptr<Depth_peer> (*make)(const Peer_mesh& a, const Peer_mesh& b);
};

/// Returns the depth peers of this build.
const std::vector<Named_depth_peer>& depth_peers();

}  // namespace tetracone::experiments

#endif
