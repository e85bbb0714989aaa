#ifndef TETRACONE_EXPERIMENTS_SPEED_CONTESTANT_H
#define TETRACONE_EXPERIMENTS_SPEED_CONTESTANT_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/question.h"
#include "tetracone/tetratree/paper/config.h"
#include "tetracone/tetratree/query_statistics.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

/// Who is timed in the experiments of speed, behind one door: ours without the harness's wrapping, and the peers in
/// this process.
namespace tetracone::experiments {

/// Two bodies made ready by a contestant.
class Ready {
 public:
  virtual ~Ready() = default;

  virtual bool collide(const kernel::Pose& pose_a, const kernel::Pose& pose_b, kernel::Question question) = 0;

  /// Work since the last call, nodes made so far, and how many copies of a triangle the leaves hold in the mean; none
  /// for a peer.
  virtual tetratree::Query_statistics take_counts() { return {}; }
  virtual std::size_t node_count() const { return 0; }

  /// Bytes of trees and tables without the models; 0 where it is not known.
  virtual std::size_t tree_bytes() const { return 0; }

  /// Bytes that are not of the heap.
  virtual std::size_t mapped_bytes() const { return 0; }
  virtual double copies() const { return 1; }
};

struct Contestant {
  std::string name;
  bool exact = false;  ///< every answer is right by construction
  bool knows_solids = false;
  bool counts_work = false;  ///< `Ready::take_counts` tells something
  std::size_t one_in = 1;    ///< asks every so many-th pose: slow ones see fewer

  using Prepare = std::function<std::unique_ptr<Ready>(const covering::Polyhedron& a, const covering::Polyhedron& b)>;
  Prepare prepare;            ///< its result is null when such bodies are not taken
  Prepare prepare_on_demand;  ///< empty where nodes are not made on demand

  /// Of one that differs from another in the query alone: its own query on what that one has made ready, or null.
  /// Whoever asks the same trees has the same places in memory, which move times by some per cent.
  std::function<std::unique_ptr<Ready>(const Ready& other)> share;

  Contestant every(std::size_t n) const
  {
    Contestant slower = *this;
    slower.one_in = n;
    return slower;
  }
};

/// The fast tree of the adaptive kernel; and with what the last frame told remembered: poses in the order of a motion.
Contestant fast();
Contestant fast_with_last_frame();

/// The paper's tree in double with these choices, or over the adaptive kernel.
Contestant paper(const std::string& name, const tetratree::Config& config);
Contestant paper_adaptive(const std::string& name, const tetratree::Config& config);

/// A peer by its name (see `peers`), its meshes triangulated. Takes nothing where the program was built without it.
Contestant peer(const std::string& name, std::size_t one_in = 1);

}  // namespace tetracone::experiments

#endif
