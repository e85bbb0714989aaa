#ifndef TETRACONE_EXPERIMENTS_PEERS_PREPARED_PAIR_H
#define TETRACONE_EXPERIMENTS_PEERS_PREPARED_PAIR_H

#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/question.h"
#include "tetracone/tetratree/fast/bvh8_options.h"
#include "tetracone/tetratree/query_statistics.h"

#include <cstddef>
#include <optional>
#include <stdexcept>

namespace tetracone::experiments {

/// A pair that gives no answer to a pose: it declines or fails.
struct No_answer : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Two bodies, prepared once by a contestant or a peer and asked under many poses.
class Prepared_pair {
 public:
  virtual ~Prepared_pair() = default;

  /// Returns the answer. A peer requires rigid poses, and rounds fractions to the nearest double. A program throws
  /// `No_answer` where it gives none.
  virtual bool collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, kernel::Question question) = 0;

  /// Returns the nanoseconds of the last answer by the pair's own clock, NaN where it told none; nothing for a pair
  /// that the caller times.
  virtual std::optional<double> own_ns() const { return std::nullopt; }

  /// Returns the work since the last call; none is known of a peer, which returns zeros.
  virtual tetratree::Query_statistics take_counts() { return {}; }

  /// Returns the number of nodes built so far; 0 for a peer.
  virtual std::size_t node_count() const { return 0; }

  /// Returns how the existing nodes of fast trees were cut; zeros if it is not known.
  virtual tetratree::Cut_counts cuts() const { return {}; }

  /// Returns the mean number of copies of a triangle in the leaves.
  virtual double copies() const { return 1; }

  /// Returns the bytes of trees and tables without the models; 0 if it is not known.
  virtual std::size_t tree_bytes() const { return 0; }

  /// Returns the bytes that are not on the heap.
  virtual std::size_t mapped_bytes() const { return 0; }
};

}  // namespace tetracone::experiments

#endif
