#ifndef TETRACONE_EXPERIMENTS_PEERS_FCL_CONTACTS_H
#define TETRACONE_EXPERIMENTS_PEERS_FCL_CONTACTS_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/pose.h"

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace tetracone::experiments {

/// FCL's contacts of two triangle meshes: BVHModel<OBBRSS> of doubles, no limit of contacts.
class Fcl_contacts {
 public:
  using Pair = std::pair<covering::Index, covering::Index>;  ///< a triangle of A and one of B

  virtual ~Fcl_contacts() = default;
  /// Lists them under these rigid poses, and returns how many there are.
  virtual std::size_t list(const kernel::Pose& pose_a, const kernel::Pose& pose_b) = 0;
  /// Those listed last, sorted, each once.
  virtual std::vector<Pair> pairs() const = 0;
};

/// `with_points`: it finds points, normals and depths too. Requires triangle meshes. Null when the program was built
/// without FCL.
std::unique_ptr<Fcl_contacts> prepare_fcl_contacts(const covering::Polyhedron& a, const covering::Polyhedron& b,
                                                   bool with_points);

}  // namespace tetracone::experiments

#endif
