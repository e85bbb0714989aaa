#ifndef TETRACONE_TETRATREE_SCENE_SCENE_DATA_H
#define TETRACONE_TETRATREE_SCENE_SCENE_DATA_H

#include "tetracone/tetratree/scene/near_pairs.h"
#include "tetracone/tetratree/scene/scene.h"
#include "tetracone/tetratree/scene/scene_bodies.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tetracone::detail {

/// The state of a `Scene`: its bodies, and the pairs of them that are near one another.
///
/// A frame moves the bodies, finds the near pairs of bodies that have left their wide boxes, and asks the near pairs
/// (`Near_pairs`).
class Scene_data {
 public:
  explicit Scene_data(const Scene_options& options) : bodies_(options), near_(bodies_) {}

  Scene_models& models() { return bodies_.models; }

  std::size_t add_body(std::size_t model);
  void remove_body(std::size_t body);
  void set_model(std::size_t body, std::size_t model);
  void ignore(std::size_t a, std::size_t b);
  void place(std::size_t body, const kernel::Pose& pose) { bodies_.place(body, pose); }

  const std::vector<Scene_pair>& pairs();
  const std::vector<Undecided_pair>& undecided() const { return near_.undecided(); }
  const Frame_statistics& statistics() const { return statistics_; }
  std::vector<Scene_contact> first_contacts(std::span<const Motion> motions);
  std::vector<Scene_distance> pairs_within(const std::string& limit);

  /// Returns the numbers of the bodies that exist, ascending. Throws Error, about `what`, unless there are `count`.
  std::vector<std::size_t> present(std::size_t count, const std::string& what) const;
  const kernel::Pose& pose(std::size_t body)
  {
    bodies_.placed(body);
    return bodies_.poses[body];
  }

  /// Returns what(query of their models, pose of a, pose of b).
  template <class What>
  auto ask(std::size_t a, std::size_t b, const What& what)
  {
    const Number model_a = bodies_.placed(a).model, model_b = bodies_.placed(b).model;
    return what(bodies_.workers[0].query(bodies_.models, model_a, model_b), bodies_.poses[a], bodies_.poses[b]);
  }

 private:
  using Number = std::uint32_t;
  using Motions = std::vector<const Motion*>;  // one for each body; null where the body does not exist

  std::vector<Scene_pair> meeting_pairs(const Motions& motion_of);
  std::vector<Scene_pair> pairs_of_boxes(const std::vector<tetratree::World_box>& boxes,
                                         const std::vector<Number>& bodies) const;
  std::optional<First_contact> first_contact(const Scene_pair& pair, const Motions& motion_of, Scene_worker& worker);

  Scene_bodies bodies_;
  Near_pairs near_;
  Frame_statistics statistics_;
};

}  // namespace tetracone::detail

#endif
