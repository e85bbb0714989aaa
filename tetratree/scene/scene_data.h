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

/// The state of a `Scene`, and the work of a frame.
///
/// A body has a box. In the tree of boxes it has a wider one, in which it may move for some frames. Two bodies whose
/// wide boxes meet are a near pair. A frame asks the near pairs that no certificate keeps, by stages: the boxes, boxes
/// that are turned with the bodies, boxes found anew, the query of their models.
///
/// A certificate holds while its use is less than the gap that was between the bodies. Its use is the rotation of both
/// about their centres since, plus the change of the vector between their centres. The rotation `turned` is a sum of
/// upper bounds, rounded up. Bodies that move alike therefore stay apart for many frames.
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

  /// Returns the numbers of the bodies that exist, ascending. Throws Error, about `what`, unless there are `count`.
  std::vector<std::size_t> present(std::size_t count, const std::string& what) const;
  const kernel::Pose& pose(std::size_t body)
  {
    placed(body);
    return poses_[body];
  }

  /// Returns what(query of their models, pose of a, pose of b).
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

  /// The few bytes of a body that a frame reads in the order of the pairs.
  struct Placed_body {
    Number model;
    bool is_there = true, is_placed = false, is_in_tree = false;
    bool has_moved = false, is_lost = false;       // since the last frame; by a step that has no bound
    bool is_tight = false, is_wide_tight = false;  // whether its box, and the wide one, were found by the model's tree
    bool is_out = false;                           // of its wide box, or its two boxes were found in different ways
    bool is_turned = false;                        // whether it has a turned box
  };

  /// The motion of a body since the last frame, rounded to float: of its centre, and its rotation.
  struct Step {
    std::array<float, 3> by{};
    float turned = 0;
  };

  /// The properties of a model that a frame reads for all of its bodies.
  struct Known_model {
    const tetratree::Body_extent* extent = nullptr;
    bool has_tree = false, is_long = false;
    std::uint64_t frame = 0;  // the last frame that read them
  };

  Placed_body& there(std::size_t body);
  Placed_body& placed(std::size_t body);
  void require_model(std::size_t model) const;
  bool is_ignored(std::size_t a, std::size_t b) const;
  void part(Number pair);
  void leave(Number body);

  /// Calls what(i, worker) for i < n: on all threads with grain `at_least`, or on this thread if n < 2 at_least.
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

  /// Calls what(first, last) for the pairs of two models at a time, and keeps to the memory after each. Calls it once
  /// for all pairs where the memory has no limit. `models_of(pair)` returns the models of a pair. Requires pairs sorted
  /// by them.
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

  using Motions = std::vector<const Motion*>;  // one for each body; null where the body does not exist
  std::vector<Scene_pair> meeting_pairs(const Motions& motion_of);
  std::optional<First_contact> first_contact(const Scene_pair& pair, const Motions& motion_of, Scene_worker& worker);

  Scene_options options_;
  std::vector<Scene_worker> workers_;
  std::optional<tbb::task_arena> arena_;  // for more than one thread

  tetratree::Large_vector<Placed_body> bodies_;
  tetratree::Large_vector<kernel::Pose> poses_;            // of each body, as the next five
  tetratree::Large_vector<tetratree::Body_place> places_;  // derived from the poses
  tetratree::Large_vector<Step> steps_;
  tetratree::Large_vector<tetratree::Body_box> boxes_;
  tetratree::Large_vector<World_box> wide_;                // the boxes in the tree
  tetratree::Large_vector<tetratree::Turned_box> turned_;  // empty until a body is long; set for long bodies only
  std::vector<Known_model> known_models_;
  tetratree::Box_tree tree_;
  bool tree_is_old_ = false;  // it lacks bodies
  std::unordered_set<std::uint64_t> ignored_;
  tetratree::Pair_list near_;
  bool memory_has_fronts_ = true;  // false once fronts have exceeded the memory
  std::vector<Number> moved_, open_;
  std::vector<std::uint64_t> seen_;  // the last search that found each body
  std::uint64_t search_ = 0;

  std::uint64_t frame_ = 0;
  std::optional<std::chrono::steady_clock::time_point> deadline_;
  std::vector<Scene_pair> colliding_, left_;  // pairs that collided in the last answer and do no more
  std::vector<Undecided_pair> undecided_;
  Frame_statistics statistics_;
};

}  // namespace tetracone::detail

#endif
