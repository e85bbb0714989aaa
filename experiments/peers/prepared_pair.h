#ifndef TETRACONE_EXPERIMENTS_PEERS_PREPARED_PAIR_H
#define TETRACONE_EXPERIMENTS_PEERS_PREPARED_PAIR_H

#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/question.h"
#include "tetracone/tetratree/fast/bvh8_options.h"
#include "tetracone/tetratree/query_statistics.h"

#include <cstddef>

namespace tetracone::experiments {

/// Two bodies made ready once by a contestant or a peer, asked under many poses.
class Prepared_pair {
 public:
  virtual ~Prepared_pair() = default;

  /// A peer requires rigid poses, and rounds fractions to the nearest double.
  virtual bool collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, kernel::Question question) = 0;

  /// Work since the last call, and nodes made so far; none for a peer.
  virtual tetratree::Query_statistics take_counts() { return {}; }
  virtual std::size_t node_count() const { return 0; }

  /// How the nodes of fast trees made so far came about; nothing where that is not known.
  virtual tetratree::Cut_counts cuts() const { return {}; }

  /// How many copies of a triangle the leaves hold in the mean.
  virtual double copies() const { return 1; }

  /// Bytes of trees and tables without the models; 0 where it is not known.
  virtual std::size_t tree_bytes() const { return 0; }

  /// Bytes that are not of the heap.
  virtual std::size_t mapped_bytes() const { return 0; }
};

}  // namespace tetracone::experiments

#endif
