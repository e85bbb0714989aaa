#ifndef TETRACONE_TETRATREE_DOOR_QUERY_DATA_H
#define TETRACONE_TETRATREE_DOOR_QUERY_DATA_H

#include "tetracone/tetratree/door/distance_solver.h"
#include "tetracone/tetratree/door/motion_solver.h"
#include "tetracone/tetratree/door/relation_solver.h"
#include "tetracone/tetratree/door/solver.h"

#include <memory>

namespace tetracone::detail {

/// The state of a `Query`.
struct Query_data {
  Question question;
  std::unique_ptr<Solver> solver;
  Shared_body a, b;
  Query_options options;
  std::unique_ptr<Distance_solver> distance;  // made when a distance is asked for
  std::unique_ptr<Motion_solver> motion;      // made when a first contact is asked for
  std::unique_ptr<Relation_solver> relation;  // made by `relation_of`
};

/// Returns the solver of relations, overlaps and penetrations, which is made if need be. Throws Error as
/// `Query::solid_relation`.
Relation_solver& relation_of(Query_data& data);

}  // namespace tetracone::detail

#endif
