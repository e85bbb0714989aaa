#ifndef TETRACONE_EXPERIMENTS_PEERS_PEER_H
#define TETRACONE_EXPERIMENTS_PEERS_PEER_H

#include "experiments/peers/prepared_pair.h"
#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/pose.h"
#include "verify/subjects/object_subject.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Other libraries with one interface: two triangle meshes are prepared once and asked under many rigid poses.
namespace tetracone::experiments {

/// A polyhedron in the form that peers take: triangles, and only the vertices that they use.
struct Peer_mesh {
  std::vector<kernel::Vertex> vertices;
  std::vector<std::array<covering::Index, 3>> triangles;
};

/// Returns the triangles of `verify::triangles_of` with only the vertices that they use; nothing where there are none.
std::optional<Peer_mesh> peer_mesh(const covering::Polyhedron& polyhedron);

/// True when the pose's doubles are a rotation and a translation: rows orthonormal to 1e-9, and no reflection.
bool is_rigid(const kernel::Pose& pose);

/// A library with one of its methods.
struct Peer {
  std::string name;
  std::string note;     ///< the question that it really answers, its number type and its tolerance
  verify::Knows knows;  ///< `solids`: it is not asked about surfaces

  /// Returns null when the peer does not take such meshes.
  std::unique_ptr<Prepared_pair> (*prepare)(const Peer_mesh& a, const Peer_mesh& b);

  /// The numbers that it rounds to float before it computes.
  verify::In_floats in_floats = verify::In_floats::nothing;
};

/// Returns the peers that the program was built with; CGAL's always exist.
const std::vector<Peer>& peers();

// One adapter a file, NAME_peer.cpp, built where the library is installed.

/// FCL on trees of oriented boxes and sphere-swept rectangles, and of axis-aligned boxes.
std::unique_ptr<Prepared_pair> prepare_fcl_obbrss(const Peer_mesh& a, const Peer_mesh& b);
std::unique_ptr<Prepared_pair> prepare_fcl_aabb(const Peer_mesh& a, const Peer_mesh& b);

/// Bullet's GImpact meshes without a margin.
std::unique_ptr<Prepared_pair> prepare_bullet(const Peer_mesh& a, const Peer_mesh& b);

/// ODE's trimesh against trimesh.
std::unique_ptr<Prepared_pair> prepare_ode(const Peer_mesh& a, const Peer_mesh& b);

/// libccd's GJK and MPR on the vertices. Null unless both meshes are closed and convex.
std::unique_ptr<Prepared_pair> prepare_libccd_gjk(const Peer_mesh& a, const Peer_mesh& b);
std::unique_ptr<Prepared_pair> prepare_libccd_mpr(const Peer_mesh& a, const Peer_mesh& b);

/// CGAL's Rigid_triangle_mesh_collision_detection. Null unless both meshes are manifold.
std::unique_ptr<Prepared_pair> prepare_cgal_epick(const Peer_mesh& a, const Peer_mesh& b);
std::unique_ptr<Prepared_pair> prepare_cgal_epeck(const Peer_mesh& a, const Peer_mesh& b);

}  // namespace tetracone::experiments

#endif
