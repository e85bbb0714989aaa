#ifndef TETRACONE_TETRATREE_DOOR_SOLVER_H
#define TETRACONE_TETRATREE_DOOR_SOLVER_H

#include "tetracone/kernel/number/pose.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace tetracone::tetratree {
struct Found_contacts;
}

namespace tetracone::detail {

/// Answers the queries of `Query` by one method over one kernel.
class Solver {
 public:
  virtual ~Solver() = default;
  /// Returns the relation of the placed bodies. `memory` belongs to these placed bodies, or is null; a solver may leave
  /// it unused.
  virtual Relation relation(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question,
                            tetratree::Pair_memory* memory) = 0;
  virtual std::vector<Feature_pair> features(const kernel::Pose& pose_a, const kernel::Pose& pose_b) = 0;
  virtual tetratree::Found_contacts contacts(const kernel::Pose& pose_a, const kernel::Pose& pose_b) = 0;
  /// Returns a lower bound of the distance after the last relation, if that was `apart`; 0 if none was computed.
  virtual double certified_gap() const { return 0; }
  virtual Query_statistics statistics() const = 0;
  virtual void clear_statistics() = 0;
  virtual std::size_t bytes() const = 0;
  virtual std::size_t node_count() const = 0;
};

using Shared_body = std::shared_ptr<const Body_data>;

/// Makes the solver of these options. Throws Error for an unknown kernel.
std::unique_ptr<Solver> make_solver(const Shared_body& a, const Shared_body& b, const Query_options& options);

/// Makes the solver by the paper's tree over K, with the method's choices. Each kernel has a compiled unit of its own,
/// here and below.
template <class K>
std::unique_ptr<Solver> tetra_tree_solver(const Shared_body& a, const Shared_body& b, const Query_options& options);

/// Makes the solver by the fast tree, with leaves decided by K.
template <class K>
std::unique_ptr<Solver> bvh8_solver(const Shared_body& a, const Shared_body& b, const Query_options& options);

}  // namespace tetracone::detail

#endif
