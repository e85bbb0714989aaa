#ifndef TETRACONE_TETRATREE_SCENE_SCENE_H
#define TETRACONE_TETRATREE_SCENE_SCENE_H

#include "tetracone/tetratree/door/tetracone.h"

#include <chrono>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tetracone {

namespace detail {
class Scene_data;
}

/// How a scene is asked.
struct Scene_options {
  Question question = Question::solid;  ///< what colliding means
  Query_options query = {};             ///< the arithmetic and the method for a pair
  std::size_t threads = 1;  ///< that share the pairs of a frame, at most as many as the machine has; 0: so many
  std::size_t memory = 0;   ///< bytes that models, queries and pairs may take; 0: no limit
  std::chrono::nanoseconds budget{0};  ///< for a frame: what is not decided then stays undecided; 0: no limit
};

/// Two bodies of a scene by their numbers, a < b.
struct Scene_pair {
  std::size_t a, b;

  friend auto operator<=>(const Scene_pair&, const Scene_pair&) = default;
};

/// A pair that the budget left undecided: the bodies are at most this far from one another.
struct Undecided_pair {
  Scene_pair pair;
  double farthest;
};

/// Two bodies of a scene that meet as they move, and when first: the holders are of a and of b.
struct Scene_contact {
  Scene_pair pair;
  First_contact first;
};

/// What a frame has cost, or asking for first contacts.
struct Frame_statistics {
  std::size_t moved = 0;       ///< bodies that were placed anew
  std::size_t kept = 0;        ///< pairs near one another whose answer a certificate kept
  std::size_t candidates = 0;  ///< pairs whose boxes met, of those that no certificate kept
  std::size_t queries = 0;     ///< candidates that were asked as bodies
  std::size_t nodes_made = 0;  ///< of the models' trees
  std::size_t bytes = 0;       ///< of models, queries and pairs, after it
};

/// Many bodies, of which some share a model, and the pairs of them that collide, frame after frame. One scene per
/// thread; it uses threads of its own.
///
/// The answer is exactly the set of pairs that collide, whatever the history of frames, the number of threads or the
/// memory allowed. A pair that was apart is not asked again before the motion since can have used up the gap; bodies
/// near one another that move by small steps are asked again only where they may have met; a model is made when a body
/// of it is first placed, and its tree when another body first comes near.
class Scene {
 public:
  /// Throws Error for a budget below 0.
  explicit Scene(const Scene_options& options = {});
  ~Scene();
  /// What is moved from may only be destroyed or assigned to.
  Scene(Scene&&) noexcept;
  /// As the constructor.
  Scene& operator=(Scene&&) noexcept;

  /// A model; returns its number, from 0.
  std::size_t add_model(const Body& body);
  /// A model that `make` makes, when it is needed, and again when memory has taken it back: it must make the same each
  /// time. What it throws, `pairs` throws. `name` stands for the model in messages.
  std::size_t add_model(std::function<Body()> make, const std::string& name);

  /// A body of a model, not placed yet; returns its number, from 0. Throws Error for a model's number out of range.
  std::size_t add_body(std::size_t model);
  /// Takes a body out; its number is not used again. This and what follows throw Error for a body that is not there.
  void remove_body(std::size_t body);
  /// Makes it a body of another model.
  void set_model(std::size_t body, std::size_t model);
  /// These two are not asked for.
  void ignore(std::size_t body_a, std::size_t body_b);

  /// Places a body, from now on.
  void place(std::size_t body, const Pose& pose);
  /// By a pose of the templates. Requires det M != 0.
  void place(std::size_t body, const kernel::Pose& pose);

  /// The pairs of placed bodies that collide now, in order; decided anew as far as bodies have moved. Throws Error where
  /// there are bodies and none is placed, where a model cannot be made or is open and asked for its solid, where the memory does not hold the models of one pair,
  /// and as `Query::collide`; asked again, it goes on where it was.
  const std::vector<Scene_pair>& pairs();
  /// Places all bodies, in the order of their numbers, removed ones left out, and asks. Throws Error for another count.
  const std::vector<Scene_pair>& frame(std::span<const Pose> poses);

  /// The pairs of bodies that meet while all of them move so, each with its first contact, as `Query::first_contact` has
  /// it: in order of (lo, hi, pair). That is the order of the exact times, but for those between the same two doubles.
  /// A motion a body, in the order of their numbers, removed ones left out; pairs are asked whose boxes about all of
  /// their motions meet, by all threads, and no budget bounds it. The bodies stand where they stood, or nowhere, and
  /// frames go on as if it had not been asked. Throws Error for another count, for another kernel than adaptive, and as
  /// `pairs`; also where a face of a body that another comes near is neither a triangle nor has triangles.
  std::vector<Scene_contact> first_contacts(std::span<const Motion> motions);
  /// The same on lines, from where the bodies stand to these poses. Throws Error also for a body that is not placed.
  std::vector<Scene_contact> first_contacts(std::span<const Pose> to);

  /// The pairs that the budget has left undecided in the last frame, in order.
  const std::vector<Undecided_pair>& undecided() const;
  /// What the last frame has cost, or first contacts that were asked for since.
  const Frame_statistics& statistics() const;

  /// How two placed bodies stand now. Throws Error as `pairs`, and for bodies that are not placed.
  Relation relation(std::size_t body_a, std::size_t body_b);
  /// All pairs of their faces that share a point. Throws as `relation`, and as `Query::contacts`.
  Contacts contacts(std::size_t body_a, std::size_t body_b);
  /// Their distance. Throws as `relation`, and as `Query::distance`.
  double distance(std::size_t body_a, std::size_t body_b);
  /// Whether that is at most `limit`. Throws as `relation`, and as `Query::within`.
  bool within(std::size_t body_a, std::size_t body_b, double limit);

 private:
  std::unique_ptr<detail::Scene_data> data_;
};

}  // namespace tetracone

#endif
