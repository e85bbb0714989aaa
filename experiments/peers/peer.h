#ifndef TETRACONE_EXPERIMENTS_PEERS_PEER_H
#define TETRACONE_EXPERIMENTS_PEERS_PEER_H

#include "experiments/peers/prepared_pair.h"
#include "tetracone/covering/polyhedron.h"
#include "verify/subjects/object_subject.h"

#include <array>
#include <memory>
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

}  // namespace tetracone::experiments

#endif
