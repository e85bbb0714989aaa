#ifndef TETRACONE_EXPERIMENTS_SPEED_CONTESTANT_H
#define TETRACONE_EXPERIMENTS_SPEED_CONTESTANT_H

#include "experiments/peers/prepared_pair.h"
#include "tetracone/covering/polyhedron.h"
#include "tetracone/tetratree/paper/config.h"
#include "verify/subjects/object_subject.h"

#include <functional>
#include <memory>
#include <string>

/// The contestants of the experiments of speed, with one interface: our methods without the harness's wrapping, and the
/// peers in this process.
namespace tetracone::experiments {

/// A method in a race.
struct Contestant {
  std::string name = {};
  bool exact = false;  ///< every answer is right by construction
  bool knows_solids = false;
  bool counts_work = false;   ///< `Prepared_pair::take_counts` counts its work
  bool clocked_cold = false;  ///< its first query, and queries with empty caches, are timed too
  std::size_t one_in = 1;     ///< it is asked one in `one_in` poses, of hits and of misses; above 1 for slow ones

  using Prepare =
      std::function<std::unique_ptr<Prepared_pair>(const covering::Polyhedron& a, const covering::Polyhedron& b)>;
  Prepare prepare = {};            ///< returns null when it does not take such bodies
  Prepare prepare_on_demand = {};  ///< empty if nodes are not built on demand

  /// Returns this contestant's query on the trees of `other`; null if it cannot query those. Shared trees have one
  /// address: another address changes times by some per cent.
  std::function<std::unique_ptr<Prepared_pair>(const Prepared_pair& other)> share = {};

  std::string kernel = {}, method = {};  ///< the study's columns of these names

  /// Returns this contestant, asked one in `n` poses.
  Contestant every(std::size_t n) const
  {
    Contestant slower = *this;
    slower.one_in = n;
    return slower;
  }
};

/// The fast tree of the adaptive kernel, without and with the memory of the last frame, for poses in the order of a
/// motion.
Contestant fast();
Contestant fast_with_last_frame();
/// The fast tree with leaves decided in double: the cost of exactness is the adaptive kernel's time minus this one's.
Contestant fast_in_double();

/// The fast tree of the adaptive kernel with these choices, including its cuts.
Contestant fast_as_chosen(const std::string& name, const tetratree::Bvh8_options& options);

/// The paper's tree with these choices: in double, in double with other choices for B, and over the adaptive kernel.
Contestant paper(const std::string& name, const tetratree::Config& config);
Contestant paper(const std::string& name, const tetratree::Config& of_a, const tetratree::Config& of_b);
Contestant paper_adaptive(const std::string& name, const tetratree::Config& config);

/// Returns a peer by its name (see `peers`), with its meshes triangulated. It takes no bodies if the program was built
/// without it.
Contestant peer(const std::string& name, std::size_t one_in = 1);

/// Returns somebody else's program as a contestant. Its times are those that it tells of itself.
Contestant program(const verify::Object_subject& subject);

}  // namespace tetracone::experiments

#endif
