#ifndef TETRACONE_TETRATREE_SCENE_SCENE_BODIES_H
#define TETRACONE_TETRATREE_SCENE_SCENE_BODIES_H

#include "tetracone/kernel/number/pose.h"
#include "tetracone/tetratree/scene/body_box.h"
#include "tetracone/tetratree/scene/body_extent.h"
#include "tetracone/tetratree/scene/box_tree.h"
#include "tetracone/tetratree/scene/large_pages.h"
#include "tetracone/tetratree/scene/scene.h"
#include "tetracone/tetratree/scene/scene_models.h"
#include "tetracone/tetratree/scene/turned_box.h"
#include "tetracone/tetratree/scene/world_box.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::detail {

/// The state of a body of a scene: removed, added without a pose, placed, or in the tree of boxes.
enum class Presence : std::uint8_t { removed, added, placed, in_tree };

/// What a body has done since the last frame; `lost`: a step that has no bound.
enum class Moved : std::uint8_t { no, yes, lost };

/// By what a box about a body was found: by its model's extent, or more tightly by its model's tree.
enum class Found_by : std::uint8_t { extent, tree };

/// The few bytes of a body that a frame reads in the order of the pairs.
struct Placed_body {
  std::uint32_t model;
  Presence presence = Presence::added;
  Moved moved = Moved::no;
  Found_by box = Found_by::extent, wide_box = Found_by::extent;
  bool is_out = false;     // of its wide box, or its two boxes were found in different ways
  bool is_turned = false;  // whether it has a turned box

  bool is_there() const { return presence != Presence::removed; }
  bool is_placed() const { return presence >= Presence::placed; }
  bool is_in_tree() const { return presence == Presence::in_tree; }
};

/// The numbers of two bodies.
using Body_pair = std::array<std::uint32_t, 2>;

/// The bodies of a scene, each with its boxes. A frame reads and writes their arrays.
///
/// A body has a box. In the tree of boxes it has a wider one, in which it may move for some frames.
class Scene_bodies {
 public:
  using Number = std::uint32_t;
  using World_box = tetratree::World_box;

  explicit Scene_bodies(const Scene_options& options);

  Scene_options options;
  Scene_models models;
  std::vector<Scene_worker> workers;

  tetratree::Large_vector<Placed_body> states;
  tetratree::Large_vector<kernel::Pose> poses;            // of each body, as the next two
  tetratree::Large_vector<tetratree::Body_place> places;  // derived from the poses
  tetratree::Large_vector<tetratree::Body_box> boxes;
  std::vector<Number> moved;  // the bodies that have moved since the last frame

  std::size_t add(std::size_t model);
  void remove(Number body);
  void place(std::size_t body, const kernel::Pose& pose);
  /// Makes the body one of another model.
  void set_model(Number body, Number model);

  /// Returns the body of this number. Throws Error where there is none.
  Placed_body& there(std::size_t body);
  /// Same. Throws Error also for a body that has no pose.
  Placed_body& placed(std::size_t body);
  void require_model(std::size_t model) const;

  std::size_t count_in_tree() const { return tree_.count(); }
  /// Returns the models of two bodies, the lesser number first.
  std::pair<Number, Number> models_of(std::size_t a, std::size_t b) const;

  /// Updates the boxes of the bodies that have moved. Returns the bodies that have new wide boxes.
  std::vector<Number> update_boxes();
  /// Returns, in parts, the pairs of bodies whose wide boxes meet, with at least one body in `searched`.
  std::vector<tetratree::Large_vector<Body_pair>> meeting(const std::vector<Number>& searched);

  /// Finds a body's box at its present pose.
  void find_box(Number body, Scene_worker& worker);
  /// Finds the body's box by the tree of its model, which is made now if need be.
  void tighten(Number body);
  /// Returns the body's box, turned with it.
  tetratree::Turned_box turned_box(Number body);

  void fetch_box(Number body) const;
  void fetch_turned_box(Number body) const;
  void fetch_pose(Number body) const;

  std::size_t bytes() const;

  /// Calls what(i, worker) for i < n: on all threads with grain `at_least`, or on this thread if n < 2 at_least.
  template <class What>
  void for_each(std::size_t n, std::size_t at_least, const What& what)
  {
    if (!arena_ || n < 2 * at_least) {
      for (std::size_t i = 0; i < n; ++i) what(i, workers[0]);
      return;
    }
    arena_->execute([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, at_least), [&](const auto& range) {
        Scene_worker& worker = workers[std::size_t(tbb::this_task_arena::current_thread_index())];
        for (std::size_t i = range.begin(); i < range.end(); ++i) what(i, worker);
      });
    });
  }

 private:
  /// The motion of a body's centre since the last frame, and its rotation, rounded to float.
  struct Step {
    std::array<float, 3> by{};
    float turned = 0;
  };

  /// The properties of a model that a frame reads for all of its bodies.
  struct Known_model {
    const tetratree::Body_extent* extent = nullptr;
    Found_by best = Found_by::extent;  // the way in which boxes are found now
    bool is_long = false;
    std::uint64_t frame = 0;  // the last frame that read them
  };

  void leave_tree(Number body);
  void mark_moved(Number body);
  bool step(Number body, const kernel::Pose& to);
  Found_by best_of(Number model) const;
  void look_at_models();
  Known_model& known(Number model);
  void make_trees(const std::vector<Number>& new_bodies);
  void move(Number body, Scene_worker& worker);
  bool is_out_soon(Number body) const;
  void widen(const std::vector<Number>& out_of_their_boxes);
  void build_tree();

  std::optional<tbb::task_arena> arena_;                   // for more than one thread
  tetratree::Large_vector<Step> steps_;                    // of each body, as the next two
  tetratree::Large_vector<World_box> wide_;                // the boxes in the tree
  tetratree::Large_vector<tetratree::Turned_box> turned_;  // empty until a body is long; set for long bodies only
  std::vector<Known_model> known_models_;
  tetratree::Box_tree tree_;
  bool tree_is_old_ = false;  // it lacks bodies
  std::uint64_t frame_ = 0;
};

}  // namespace tetracone::detail

#endif
