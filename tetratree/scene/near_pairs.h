#ifndef TETRACONE_TETRATREE_SCENE_NEAR_PAIRS_H
#define TETRACONE_TETRATREE_SCENE_NEAR_PAIRS_H

#include "tetracone/tetratree/scene/pair_list.h"
#include "tetracone/tetratree/scene/scene.h"
#include "tetracone/tetratree/scene/scene_bodies.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

namespace tetracone::detail {

/// The near pairs of a scene, those whose wide boxes meet, and which of them collide.
///
/// A frame asks a near pair in this order, until one of them answers (near_pairs.cpp):
/// 1. the certificate of the last answer (`are_apart` below, with the constants of memory/pair_certificate.h);
/// 2. for a pair with a long body, boxes turned with the bodies (turned_box.h): their gaps are mostly larger;
/// 3. the boxes along the world's axes, as the bodies carry them (body_box.h);
/// 4. for a pair without a long body, these boxes found anew, unless the bodies collided in the last answer;
/// 5. the boxes found by the models' trees, which are made now if testing all pairs of faces would cost more;
/// 6. the query of the two models (`Query::collide`).
class Near_pairs {
 public:
  using Number = std::uint32_t;
  using Deadline = std::optional<std::chrono::steady_clock::time_point>;

  explicit Near_pairs(Scene_bodies& bodies) : bodies_(bodies) {}

  /// Leaves a pair out of all answers.
  void ignore(Number a, Number b);
  bool is_ignored(std::size_t a, std::size_t b) const;
  void set_body_count(std::size_t count);
  /// Removes the pairs of a body.
  void remove_pairs_of(Number body);

  /// Updates the pairs of bodies that have new wide boxes.
  void find(const std::vector<Number>& bodies);
  /// Asks the pairs of bodies that have moved, and those left open. After the deadline it still asks boxes, but begins
  /// no query. Counts what it does.
  void ask(const Deadline& deadline, Frame_statistics& statistics);

  /// Returns the pairs that collided in the last answer.
  const std::vector<Scene_pair>& colliding() const { return colliding_; }
  /// Returns the pairs that the deadline left open.
  const std::vector<Undecided_pair>& undecided() const { return undecided_; }

  /// Returns the bytes of the pairs and of the bodies.
  std::size_t bytes() const;

  /// Calls what(first, last) for the pairs of two models at a time, and then frees memory down to the limit. Calls it
  /// once for all pairs where the memory has no limit. `models_of(pair)` returns the models of a pair. Requires pairs
  /// sorted by their models.
  template <class Pairs, class Models, class What>
  void for_each_models(Pairs& pairs, const Models& models_of, const What& what)
  {
    for (auto first = pairs.begin(); first != pairs.end();) {
      if (bodies_.options.memory == 0) return what(first, pairs.end());
      const auto [a, b] = models_of(*first);
      const auto last = std::find_if(first, pairs.end(),
                                     [&, both = std::pair(a, b)](const auto& pair) { return models_of(pair) != both; });
      bodies_.models.use(a);
      bodies_.models.use(b);
      what(first, last);
      keep_to_memory(a, b);
      first = last;
    }
  }

 private:
  using Near_bodies = tetratree::Near_bodies;

  void remove(Number pair);
  void open_pairs(Frame_statistics& statistics);
  void ask_models(std::vector<Number>::iterator first, std::vector<Number>::iterator last, const Deadline& deadline,
                  Frame_statistics& statistics);
  bool are_apart_by_boxes(Number pair);
  void ask_turned_boxes(std::vector<Number>& pairs);
  bool are_apart_by_tight_boxes(Number pair);
  void ask_query(Number pair, Scene_worker& worker);
  bool has_turned_box(const Near_bodies& pair) const;
  bool has_new_boxes(const Near_bodies& pair) const;
  void find_boxes(const std::vector<Number>& pairs);
  void keep_to_memory(Number model_a, Number model_b);
  void forget_pairs_of(Number body);
  void allow_fronts(const std::vector<Number>& pairs);
  bool moves_little(const Near_bodies& pair, const tetratree::Asked_pair& asked) const;
  void begin(Near_bodies& pair);
  void answer(Number pair, bool collide, double gap);
  double gap(const Near_bodies& pair) const;
  double turned(const Near_bodies& pair) const;
  double square_between(const Near_bodies& pair, const tetratree::Between& before) const;
  bool are_apart(const Near_bodies& pair) const;
  void list_pairs();
  Scene_pair pair_of(Number pair) const { return {near_.bodies(pair).body[0], near_.bodies(pair).body[1]}; }
  std::pair<Number, Number> models_of(Number pair) const;

  Scene_bodies& bodies_;
  tetratree::Pair_list near_;
  std::vector<Number> open_;  // pairs to be asked
  std::unordered_set<std::uint64_t> ignored_;
  bool memory_has_fronts_ = true;             // false once fronts have exceeded the memory
  std::vector<std::uint64_t> seen_;           // the last search that found each body
  std::uint64_t search_ = 0;                  // number of searches so far
  std::vector<Scene_pair> colliding_, left_;  // pairs that collided in the last answer and do no more
  std::vector<Undecided_pair> undecided_;
};

}  // namespace tetracone::detail

#endif
