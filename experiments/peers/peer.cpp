#include "experiments/peers/peer.h"

#include "experiments/peers/peer_tables.h"
#include "verify/subjects/float_input.h"

#include <cmath>
#include <utility>

namespace tetracone::experiments {

std::optional<Peer_mesh> peer_mesh(const covering::Polyhedron& polyhedron)
{
  auto triangles = verify::triangles_of(polyhedron);
  if (!triangles) return std::nullopt;
  Peer_mesh mesh;
  mesh.triangles = std::move(*triangles);
  constexpr covering::Index unused = ~covering::Index{0};
  std::vector<covering::Index> number(polyhedron.vertices.size(), unused);
  for (auto& triangle : mesh.triangles)
    for (covering::Index& corner : triangle) {
      if (number[corner] == unused) {
        number[corner] = static_cast<covering::Index>(mesh.vertices.size());
        mesh.vertices.push_back(polyhedron.vertices[corner]);
      }
      corner = number[corner];
    }
  return mesh;
}

bool is_rigid(const kernel::Pose& pose)
{
  constexpr double tolerance = 1e-9;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      double product = 0;
      for (int k = 0; k < 3; ++k) product += pose[4 * i + k] * pose[4 * j + k];
      if (!(std::abs(product - (i == j)) <= tolerance)) return false;
    }
  return pose.determinant_sign() == CGAL::POSITIVE;
}

namespace {

const Peer_tables& tables()
{
  static const Peer_tables all = [] {
    Peer_tables tables;
#ifdef TETRACONE_WITH_FCL
    add_fcl(tables);
#endif
#ifdef TETRACONE_WITH_BULLET
    add_bullet(tables);
#endif
#ifdef TETRACONE_WITH_ODE
    add_ode(tables);
#endif
#ifdef TETRACONE_WITH_CCD
    add_libccd(tables);
#endif
    add_cgal(tables);
    return tables;
  }();
  return all;
}

}  // namespace

const std::vector<Peer>& peers() { return tables().pairs; }
const std::vector<Named_depth_peer>& depth_peers() { return tables().depths; }
const std::vector<Scene_library>& scene_libraries() { return tables().scenes; }
const std::vector<Named_distance_peer>& distance_peers() { return tables().distances; }
const std::vector<Named_motion_peer>& motion_peers() { return tables().motions; }

}  // namespace tetracone::experiments
