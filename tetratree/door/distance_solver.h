#ifndef TETRACONE_TETRATREE_DOOR_DISTANCE_SOLVER_H
#define TETRACONE_TETRATREE_DOOR_DISTANCE_SOLVER_H

#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <array>
#include <memory>
#include <vector>

namespace tetracone::detail {

/// Computes distances of two bodies by the fast tree over a kernel. Over double, `nearest` and `zone` throw Error.
class Distance_solver {
 public:
  virtual ~Distance_solver() = default;
  virtual double distance(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question) = 0;
  virtual Nearest nearest(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question) = 0;
  virtual bool within(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question,
                      const kernel::Rational& limit) = 0;
  virtual std::vector<covering::Index> zone(const kernel::Pose& pose_a, const kernel::Pose& pose_b, Question question,
                                            const kernel::Rational& limit) = 0;
  virtual Query_statistics statistics() const = 0;
  virtual void clear_statistics() = 0;
  virtual std::size_t bytes() const = 0;
};

/// Makes the solver of a kernel; null for one without distances.
std::unique_ptr<Distance_solver> distance_solver(const std::shared_ptr<const Body_data>& a,
                                                 const std::shared_ptr<const Body_data>& b, Kernel kernel);

/// Returns the smallest part of a placed face (vertex, edge or face) that holds its point x.
Holder holder_in(const Polyhedron& polyhedron, const kernel::Pose& pose, covering::Index f,
                 const std::array<kernel::Rational, 3>& x);

}  // namespace tetracone::detail

#endif
