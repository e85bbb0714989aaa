#ifndef TETRACONE_EXPERIMENTS_PEERS_SCENE_PEER_H
#define TETRACONE_EXPERIMENTS_PEERS_SCENE_PEER_H

#include "experiments/peers/peer.h"

#include <cstdint>

namespace tetracone::experiments {

/// Another library's scene of many meshes, prepared once.
class Scene_peer {
 public:
  using Pair = std::array<std::uint32_t, 2>;  ///< two bodies, the lesser number first

  virtual ~Scene_peer() = default;
  /// Returns the pairs that collide under these poses, in no order. Requires one rigid pose per body.
  virtual std::vector<Pair> frame(const std::vector<kernel::Pose>& poses) = 0;
  /// Returns the number of pairs that its broad phase passed in the last frame.
  std::size_t candidates() const { return candidates_; }

 protected:
  std::size_t candidates_ = 0;
};

/// A library with scenes.
struct Scene_library {
  std::string name;
  /// Returns a scene in which body k has the mesh meshes[of[k]]; null when the library does not take such meshes.
  std::unique_ptr<Scene_peer> (*prepare)(const std::vector<Peer_mesh>& meshes, const std::vector<std::size_t>& of);
};

/// Returns the scene libraries that the program was built with.
const std::vector<Scene_library>& scene_libraries();

}  // namespace tetracone::experiments

#endif
