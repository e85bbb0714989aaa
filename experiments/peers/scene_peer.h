#ifndef TETRACONE_EXPERIMENTS_PEERS_SCENE_PEER_H
#define TETRACONE_EXPERIMENTS_PEERS_SCENE_PEER_H

#include "experiments/peers/peer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tetracone::experiments {

/// Another library's scene of many meshes, made ready once.
class Scene_peer {
 public:
  using Pair = std::array<std::uint32_t, 2>;  // the lesser number first

  virtual ~Scene_peer() = default;
  /// The pairs that it says collide under these poses, a pose a body, in no order.
  virtual std::vector<Pair> frame(const std::vector<kernel::Pose>& poses) = 0;
  /// The pairs of bodies that its broad phase has let through in the last frame.
  std::size_t candidates() const { return candidates_; }

 protected:
  std::size_t candidates_ = 0;
};

/// A library's scene: of body k the mesh meshes[of[k]].
struct Scene_library {
  std::string name;
  std::unique_ptr<Scene_peer> (*prepare)(const std::vector<Peer_mesh>& meshes, const std::vector<std::size_t>& of);
};

/// Those that the program was built with.
std::vector<Scene_library> scene_libraries();

/// FCL's DynamicAABBTreeCollisionManager over its trees of oriented boxes with swept spheres.
std::unique_ptr<Scene_peer> prepare_fcl_scene(const std::vector<Peer_mesh>& meshes, const std::vector<std::size_t>& of);

/// Bullet's btDbvtBroadphase over GImpact meshes without a margin, in float.
std::unique_ptr<Scene_peer> prepare_bullet_scene(const std::vector<Peer_mesh>& meshes,
                                                 const std::vector<std::size_t>& of);

/// ODE's hash space over its trimeshes.
std::unique_ptr<Scene_peer> prepare_ode_scene(const std::vector<Peer_mesh>& meshes, const std::vector<std::size_t>& of);

}  // namespace tetracone::experiments

#endif
