#ifndef TETRACONE_EXPERIMENTS_PEERS_FCL_CONTACTS_H
#define TETRACONE_EXPERIMENTS_PEERS_FCL_CONTACTS_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/pose.h"

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace tetracone::experiments {

/// FCL's contacts of two triangle meshes: BVHModel<OBBRSS> of doubles, without a limit of contacts.
class Fcl_contacts {
 public:
  using Pair = std::pair<covering::Index, covering::Index>;  ///< a triangle of A and one of B

  virtual ~Fcl_contacts() = default;
  /// Lists the contacts under these rigid poses, and returns their number.
  virtual std::size_t list(const kernel::Pose& pose_a, const kernel::Pose& pose_b) = 0;
  /// Returns the pairs listed last, sorted, each once.
  virtual std::vector<Pair> pairs() const = 0;
};

/// Prepares FCL; `with_points` makes it compute points, normals and depths too. Requires triangle meshes. Null when the
/// program was built without FCL.
std::unique_ptr<Fcl_contacts> prepare_fcl_contacts(const covering::Polyhedron& a, const covering::Polyhedron& b,
                                                   bool with_points);

}  // namespace tetracone::experiments

#endif
