#ifndef TETRACONE_EXPERIMENTS_PEERS_FCL_MOTION_H
#define TETRACONE_EXPERIMENTS_PEERS_FCL_MOTION_H

#include "experiments/peers/peer.h"

#include <memory>
#include <optional>
#include <span>

namespace tetracone::experiments {

/// Another library's first contact of two moving meshes, prepared once.
class Motion_peer {
 public:
  virtual ~Motion_peer() = default;
  /// Returns its time in [0, 1] for B's motion from one pose to another while A rests; nothing if it finds none.
  virtual std::optional<double> first_contact(const kernel::Pose& from, const kernel::Pose& to) = 0;
};

/// FCL's continuousCollide by conservative advancement, on trees of oriented boxes with swept spheres, with its default
/// settings: steps until bodies are within 1e-4 of the time. Null when the build has no FCL.
std::unique_ptr<Motion_peer> fcl_advancement(const Peer_mesh& a, const Peer_mesh& b);

/// FCL's continuousCollide with its default method: static questions at ten steps.
std::unique_ptr<Motion_peer> fcl_steps(const Peer_mesh& a, const Peer_mesh& b);

/// A motion peer by its name.
struct Named_motion_peer {
  const char* name;
  const char* note;  ///< what it really answers
  std::unique_ptr<Motion_peer> (*make)(const Peer_mesh& a, const Peer_mesh& b);
};

/// Returns the motion peers of this build.
std::span<const Named_motion_peer> motion_peers();

}  // namespace tetracone::experiments

#endif
