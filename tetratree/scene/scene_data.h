#ifndef TETRACONE_TETRATREE_SCENE_SCENE_DATA_H
#define TETRACONE_TETRATREE_SCENE_SCENE_DATA_H

#include "tetracone/kernel/number/pose.h"
#include "tetracone/tetratree/scene/body_box.h"
#include "tetracone/tetratree/scene/body_extent.h"
#include "tetracone/tetratree/scene/box_tree.h"
#include "tetracone/tetratree/scene/large_pages.h"
#include "tetracone/tetratree/scene/pair_list.h"
#include "tetracone/tetratree/scene/scene.h"
#include "tetracone/tetratree/scene/scene_models.h"
#include "tetracone/tetratree/scene/turned_box.h"
#include "tetracone/tetratree/scene/world_box.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace tetracone::detail {

/// What a `Scene` keeps.
///
/// A body has a box about it, and in the tree of boxes a wider one, in which it may move for some frames. Two bodies
/// whose wide boxes meet are a near pair. Of these a frame asks those that no certificate keeps: first the boxes, then
/// boxes that are turned with the bodies, then boxes made tight, then the query of their models. How far a body has turned
/// about its place is a sum of bounds, rounded up: while that of both has grown, and what is between their places has
/// changed, by less than the gap that was between them, they are apart. Bodies that move alike do so for long.
class Scene_data {
 public:
  explicit Scene_data(const Scene_options& options);

  Scene_models models;

  std::size_t add_body(std::size_t model);
  void remove_body(std::size_t body);
  void set_model(std::size_t body, std::size_t model);
  void ignore(std::size_t a, std::size_t b);
  void place(std::size_t body, const kernel::Pose& pose);

  const std::vector<Scene_pair>& pairs();
  const std::vector<Undecided_pair>& undecided() const { return undecided_; }
  const Frame_statistics& statistics() const { return statistics_; }
  std::vector<Scene_contact> first_contacts(std::span<const Motion> motions);

  /// The numbers of the bodies that there are. Throws Error where that are not `count`, which are `what`.
  std::vector<std::size_t> present(std::size_t count, const std::string& what) const;
  const kernel::Pose& pose(std::size_t body)
  {
    placed(body);
    return poses_[body];
  }

  /// Calls what(query of their models, pose of a, pose of b).
  template <class What>
  auto ask(std::size_t a, std::size_t b, const What& what)
  {
    const Number model_a = placed(a).model, model_b = placed(b).model;
    return what(workers_[0].query(models, model_a, model_b), poses_[a], poses_[b]);
  }

 private:
  using Number = std::uint32_t;
  using World_box = tetratree::World_box;
  using Near_bodies = tetratree::Near_bodies;

  /// What a frame reads of bodies in the order of their pairs: few bytes.
  struct Placed_body {
    Number model;
    bool is_there = true, is_placed = false, is_in_tree = false;
    bool has_moved = false, is_lost = false;       // since the last frame; by a step of which nothing is known
    bool is_tight = false, is_wide_tight = false;  // whether its box, and the wide one, are by the model's tree
    bool is_out = false;                           // of its wide box, or of what that was made by
    bool is_turned = false;                        // whether its turned box is known
  };

  /// About how a body has moved since the frame before it was placed: its place, and what it has turned.
  struct Step {
    std::array<float, 3> by{};
    float turned = 0;
  };

  /// What a frame asks of a model, for all of its bodies.
  struct Known_model {
    const tetratree::Body_extent* extent = nullptr;
    bool has_tree = false, is_long = false;
    std::uint64_t frame = 0;  // the last one that has asked
  };

  Placed_body& there(std::size_t body);
  Placed_body& placed(std::size_t body);
  void require_model(std::size_t model) const;
  bool is_ignored(std::size_t a, std::size_t b) const;
  void part(Number pair);
  void leave(Number body);

  /// Calls what(i, worker) for i < n, by all threads.
  template <class What>
  void for_each(std::size_t n, std::size_t at_least, const What& what)
  {
    if (!arena_ || n < 2 * at_least) {
      for (std::size_t i = 0; i < n; ++i) what(i, workers_[0]);
      return;
    }
    arena_->execute([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, at_least), [&](const auto& range) {
        Scene_worker& worker = workers_[std::size_t(tbb::this_task_arena::current_thread_index())];
        for (std::size_t i = range.begin(); i < range.end(); ++i) what(i, worker);
      });
    });
  }

  /// Calls what(first, last) for the pairs of two models at a time, which keeps to the memory; where that has no limit, for
  /// all at once. models(pair): those of a pair, in the order of the pairs.
  template <class Pairs, class Models, class What>
  void for_each_models(Pairs& pairs, const Models& models_of, const What& what)
  {
    for (auto first = pairs.begin(); first != pairs.end();) {
      if (options_.memory == 0) return what(first, pairs.end());
      const auto [a, b] = models_of(*first);
      const auto last = std::find_if(first, pairs.end(),
                                     [&, both = std::pair(a, b)](const auto& pair) { return models_of(pair) != both; });
      models.use(a);
      models.use(b);
      what(first, last);
      keep_to_memory(a, b);
      first = last;
    }
  }

  void step(Number body, const kernel::Pose& to);
  void move_bodies();
  void look_at_models();
  Known_model& known(Number model);
  void make_trees(const std::vector<Number>& new_bodies);
  void move(Number body, Scene_worker& worker);
  void find_box(Number body, Scene_worker& worker);
  bool is_out_soon(Number body) const;
  void widen(const std::vector<Number>& out_of_their_boxes);
  void build_boxes();
  void find_near(const std::vector<Number>& bodies);
  void open_pairs();
  void open_pair(Number pair);
  void tighten(Number body);
  void ask_pairs();
  void fetch_boxes(const Near_bodies& pair) const;
  void fetch_pose(Number body) const;
  void ask_pair(Number pair, Scene_worker& worker);
  void ask_models(std::vector<Number>::iterator first, std::vector<Number>::iterator last);
  void ask_turned_boxes(std::vector<Number>& pairs);
  bool has_turned_box(const Near_bodies& pair) const;
  bool has_new_boxes(const Near_bodies& pair) const;
  void find_boxes(const std::vector<Number>& pairs);
  double gap(const Near_bodies& pair) const;
  tetratree::Turned_box turned_box(Number body);
  void keep_to_memory(Number model_a, Number model_b);
  void forget_pairs_of(Number body);
  void allow_fronts(const std::vector<Number>& pairs);
  bool moves_little(const Near_bodies& pair, const tetratree::Asked_pair& asked) const;
  void begin(Near_bodies& pair);
  void answer(Number pair, bool collide, double gap);
  double turned(const Near_bodies& pair) const;
  double square_between(const Near_bodies& pair, const tetratree::Between& before) const;
  bool are_apart(const Near_bodies& pair) const;
  void list_pairs();
  std::size_t bytes() const;
  std::pair<Number, Number> models_of(std::size_t a, std::size_t b) const;
  Scene_pair pair_of(Number pair) const { return {near_.bodies(pair).body[0], near_.bodies(pair).body[1]}; }
  std::pair<Number, Number> models_of(const Scene_pair& pair) const { return models_of(pair.a, pair.b); }

  using Motions = std::vector<const Motion*>;  // of each body, null where it is not there
  std::vector<Scene_pair> meeting_pairs(const Motions& motion_of);
  std::optional<First_contact> first_contact(const Scene_pair& pair, const Motions& motion_of, Scene_worker& worker);

  Scene_options options_;
  std::vector<Scene_worker> workers_;
  std::optional<tbb::task_arena> arena_;  // of more than one thread

  tetratree::Large_vector<Placed_body> bodies_;
  tetratree::Large_vector<kernel::Pose> poses_;            // of each body, as what follows
  tetratree::Large_vector<tetratree::Body_place> places_;  // by their poses
  tetratree::Large_vector<Step> steps_;
  tetratree::Large_vector<tetratree::Body_box> boxes_;
  tetratree::Large_vector<World_box> wide_;                // what the tree has
  tetratree::Large_vector<tetratree::Turned_box> turned_;  // once one is long; known of long ones alone
  std::vector<Known_model> known_models_;
  tetratree::Box_tree tree_;
  bool tree_is_old_ = false;  // there are bodies that it does not know
  std::unordered_set<std::uint64_t> ignored_;
  tetratree::Pair_list near_;
  bool memory_has_fronts_ = true;  // until they have been too much for it once
  std::vector<Number> moved_, open_;
  std::vector<std::uint64_t> seen_;  // of each body, the search that has seen it last
  std::uint64_t search_ = 0;

  std::uint64_t frame_ = 0;
  std::optional<std::chrono::steady_clock::time_point> deadline_;
  std::vector<Scene_pair> colliding_, left_;  // those that have left it
  std::vector<Undecided_pair> undecided_;
  Frame_statistics statistics_;
};

}  // namespace tetracone::detail

#endif
