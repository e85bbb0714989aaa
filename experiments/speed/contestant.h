#ifndef TETRACONE_EXPERIMENTS_SPEED_CONTESTANT_H
#define TETRACONE_EXPERIMENTS_SPEED_CONTESTANT_H

#include "experiments/peers/prepared_pair.h"
#include "tetracone/covering/polyhedron.h"
#include "tetracone/tetratree/fast/bvh8_options.h"
#include "tetracone/tetratree/paper/config.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

/// Who is timed in the experiments of speed, behind one door: ours without the harness's wrapping, and the peers in
/// this process.
namespace tetracone::experiments {

/// A method in a race.
struct Contestant {
  std::string name = {};
  bool exact = false;  ///< every answer is right by construction
  bool knows_solids = false;
  bool counts_work = false;   ///< `Prepared_pair::take_counts` tells something
  bool clocked_cold = false;  ///< its first query, and queries with empty caches, are clocked too
  std::size_t one_in = 1;     ///< is asked one in so many poses, of hits and of misses; more than 1 for the slow

  using Prepare =
      std::function<std::unique_ptr<Prepared_pair>(const covering::Polyhedron& a, const covering::Polyhedron& b)>;
  Prepare prepare = {};            ///< its result is null when such bodies are not taken
  Prepare prepare_on_demand = {};  ///< empty where nodes are not made on demand

  /// This contestant's query on the trees of `other`; null where it cannot ask those. Shared trees lie at one place
  /// in memory: another place moves times by some per cent.
  std::function<std::unique_ptr<Prepared_pair>(const Prepared_pair& other)> share = {};

  std::string kernel = {}, method = {};  ///< the study's columns of these names

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
/// The fast tree with leaves decided in double: what exactness costs is its time below the adaptive kernel's.
Contestant fast_in_double();

/// The fast tree of the adaptive kernel with these choices, and how it was cut.
Contestant fast_as_chosen(const std::string& name, const tetratree::Bvh8_options& options);

/// The paper's tree in double with these choices, of B with others where they are given, or over the adaptive kernel.
Contestant paper(const std::string& name, const tetratree::Config& config);
Contestant paper(const std::string& name, const tetratree::Config& of_a, const tetratree::Config& of_b);
Contestant paper_adaptive(const std::string& name, const tetratree::Config& config);

/// A peer by its name (see `peers`), its meshes triangulated. Takes nothing where the program was built without it.
Contestant peer(const std::string& name, std::size_t one_in = 1);

}  // namespace tetracone::experiments

#endif
