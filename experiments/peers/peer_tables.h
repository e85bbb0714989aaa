#ifndef TETRACONE_EXPERIMENTS_PEERS_PEER_TABLES_H
#define TETRACONE_EXPERIMENTS_PEERS_PEER_TABLES_H

#include "experiments/peers/depth_peer.h"
#include "experiments/peers/fcl.h"
#include "experiments/peers/scene_peer.h"

#include <memory>
#include <vector>

namespace tetracone::experiments {

/// The methods of other libraries, by what is asked of them.
struct Peer_tables {
  std::vector<Peer> pairs;
  std::vector<Named_depth_peer> depths;
  std::vector<Scene_library> scenes;
  std::vector<Named_distance_peer> distances;
  std::vector<Named_motion_peer> motions;
};

// Each adds the methods of its library. One library a file, NAME_peer.cpp, built where it is installed; CGAL always is.

void add_fcl(Peer_tables& tables);
void add_bullet(Peer_tables& tables);
void add_ode(Peer_tables& tables);
void add_libccd(Peer_tables& tables);
void add_cgal(Peer_tables& tables);

/// Makes a method of a table from what it is asked about and its settings.
template <class Interface, class Method, auto... settings, class... Of>
std::unique_ptr<Interface> make_peer(const Of&... of)
{
  return std::make_unique<Method>(of..., settings...);
}

}  // namespace tetracone::experiments

#endif
