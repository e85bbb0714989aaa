#ifndef TETRACONE_TETRATREE_DOOR_RELATION_SOLVER_H
#define TETRACONE_TETRATREE_DOOR_RELATION_SOLVER_H

#include "tetracone/kernel/contact/cone_sums.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/question.h"
#include "tetracone/tetratree/door/overlap.h"
#include "tetracone/tetratree/query_statistics.h"

#include <array>
#include <memory>
#include <vector>

namespace tetracone::detail {

struct Body_data;

/// The fractions of an overlap.
struct Overlap_data {
  kernel::Exact_solid solid;
  kernel::Rational_point contact_vector;

  bool has_volume() const { return solid.volume.top != 0; }
};

/// Answers which relation solids have, how much they overlap and how far they must be moved apart, by the fast tree and
/// the adaptive kernel. Each function returns what the function of `Query` with its name returns; `relation` is
/// `solid_relation`, and `relation_alone` is `solid_relation_alone`. Requires closed bodies, and det M != 0.
class Relation_solver {
 public:
  virtual ~Relation_solver() = default;
  virtual kernel::Solid_relation relation_alone(const kernel::Pose& pose_a, const kernel::Pose& pose_b) = 0;
  virtual kernel::Solid_contact relation(const kernel::Pose& pose_a, const kernel::Pose& pose_b) = 0;
  virtual Overlap overlap(const kernel::Pose& pose_a, const kernel::Pose& pose_b) = 0;
  virtual Overlap_bounds overlap_bounds(const kernel::Pose& pose_a, const kernel::Pose& pose_b) = 0;
  /// Returns convex parts of faces that together make up the surface of the overlap, each place once. Corners are
  /// anticlockwise as seen from outside the overlap; of four, two may be equal.
  virtual std::vector<std::vector<kernel::Rational_point>> overlap_border(const kernel::Pose& pose_a,
                                                                          const kernel::Pose& pose_b) = 0;
  /// Requires a direction other than 0.
  virtual Exits exits(const kernel::Pose& pose_a, const kernel::Pose& pose_b,
                      const std::array<kernel::Rational, 3>& direction) = 0;
  virtual Depth depth(const kernel::Pose& pose_a, const kernel::Pose& pose_b, const Depth_options& options) = 0;
  virtual tetratree::Query_statistics statistics() const = 0;
  virtual void clear_statistics() = 0;
};

/// True when solids with this relation have interiors that share a point.
inline bool interiors_meet(kernel::Solid_relation relation)
{
  return relation != kernel::Solid_relation::disjoint && relation != kernel::Solid_relation::meet;
}

/// Makes the solver of two bodies.
std::unique_ptr<Relation_solver> relation_solver(const std::shared_ptr<const Body_data>& a,
                                                 const std::shared_ptr<const Body_data>& b);

}  // namespace tetracone::detail

#endif
