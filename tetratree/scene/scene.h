#ifndef TETRACONE_TETRATREE_SCENE_SCENE_H
#define TETRACONE_TETRATREE_SCENE_SCENE_H

#include "tetracone/tetratree/door/tetracone.h"

#include <array>
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

/// The options of a scene.
struct Scene_options {
  Question question = Question::solid;  ///< what colliding means
  Query_options query = {};             ///< the arithmetic and the method for a pair
  std::size_t threads = 1;  ///< threads that share the pairs of a frame; 0 or more than the machine has: all of it
  std::size_t memory = 0;   ///< upper bound of the bytes of models, queries and pairs; 0: no limit
  std::chrono::nanoseconds budget{0};  ///< time for a frame; pairs not decided then stay undecided; 0: no limit
};

/// Two bodies of a scene by their numbers, a < b.
struct Scene_pair {
  std::size_t a;  ///< the lesser number
  std::size_t b;  ///< the greater number

  /// Compares a, then b.
  friend auto operator<=>(const Scene_pair&, const Scene_pair&) = default;
};

/// A pair that the budget left undecided.
struct Undecided_pair {
  Scene_pair pair;  ///< the bodies
  double farthest;  ///< upper bound of the distance between any point of one and any point of the other
};

/// Two bodies of a scene that meet as they move.
struct Scene_contact {
  Scene_pair pair;      ///< the bodies
  First_contact first;  ///< the first time; its holders are of a, then of b
};

/// Two bodies of a scene that are near.
struct Scene_distance {
  Scene_pair pair;  ///< the bodies
  double distance;  ///< the double nearest to their distance in placed coordinates, 0 where they collide
};

/// The cost of a frame, or of a call of `first_contacts` or `pairs_within`.
struct Frame_statistics {
  std::size_t moved = 0;       ///< number of bodies whose pose or model changed
  std::size_t kept = 0;        ///< near pairs of moved bodies that a certificate kept apart
  std::size_t candidates = 0;  ///< other near pairs whose boxes met
  std::size_t queries = 0;     ///< candidates that a query decided
  std::size_t nodes_made = 0;  ///< nodes of the models' trees that were made
  std::size_t bytes = 0;       ///< bytes of models, queries and pairs afterwards
};

/// Many bodies, and the pairs of them that collide, frame after frame. Bodies may share a model. A scene belongs to one
/// thread; it uses threads of its own.
///
/// With an exact kernel, the answer is the set of pairs that collide, less those that the budget leaves undecided.
/// Without a budget it does not depend on the history of frames, the number of threads or the memory allowed. A pair
/// that was apart is asked again only when its bodies may have used up the gap. A model is made in the first frame with
/// a placed body of it, and its tree once near pairs would cost more without it.
class Scene {
 public:
  /// Throws Error for a budget below 0.
  explicit Scene(const Scene_options& options = {});
  ~Scene();
  /// Moves; the scene that is moved from may only be destroyed or assigned to.
  Scene(Scene&&) noexcept;
  /// Moves; the scene that is moved from may only be destroyed or assigned to.
  Scene& operator=(Scene&&) noexcept;

  /// Adds a model; returns its number, from 0.
  std::size_t add_model(const Body& body);
  /// Adds a model that `make` makes when it is needed, and again when memory has taken it back; returns its number.
  /// Requires that `make` makes equal bodies each time. `pairs` throws what `make` throws. `name` stands for the model
  /// in messages.
  std::size_t add_model(std::function<Body()> make, const std::string& name);

  /// Adds a body of a model, not placed yet; returns its number, from 0. Throws Error for a model's number out of
  /// range.
  std::size_t add_body(std::size_t model);
  /// Takes a body out; its number is not used again. Throws Error for a body that is not there.
  void remove_body(std::size_t body);
  /// Makes the body one of another model. Throws Error for a body that is not there, and for a model's number out of
  /// range.
  void set_model(std::size_t body, std::size_t model);
  /// Leaves this pair out of all answers about pairs. Throws Error for a body that is not there, and for a body with
  /// itself.
  void ignore(std::size_t body_a, std::size_t body_b);

  /// Places a body; it stays there until it is placed anew. Throws Error for a body that is not there.
  void place(std::size_t body, const Pose& pose);
  /// Places a body by a pose of the templates. Requires det M != 0. Throws Error for a body that is not there.
  void place(std::size_t body, const kernel::Pose& pose);

  /// Returns the pairs of placed bodies that collide now, in order. Only pairs of bodies that moved are decided anew,
  /// and pairs that an exception or the budget left open. Throws Error as `Query::collide`, and
  ///
  /// - where there are bodies and none is placed;
  /// - where a model cannot be made;
  /// - where an open model is asked for its solid;
  /// - where the memory does not hold the models of one pair.
  const std::vector<Scene_pair>& pairs();
  /// Places all bodies and returns `pairs`. Poses are in the order of the bodies' numbers, removed bodies left out.
  /// Throws Error for another count, and as `pairs`.
  const std::vector<Scene_pair>& frame(std::span<const Pose> poses);

  /// Returns the pairs of bodies that meet while all of them move, each with its first contact, sorted by (lo, hi,
  /// pair). That is the order of the exact times, except among times between two neighbouring doubles. There is one
  /// motion per body, in the order of their numbers, removed bodies left out. Only pairs whose swept boxes overlap are
  /// tested; the budget does not apply. The bodies stay where they stood. Throws Error as `pairs`, for another count,
  /// and for another kernel than adaptive. Throws it also where a face of such a pair is neither a triangle nor has
  /// triangles.
  std::vector<Scene_contact> first_contacts(std::span<const Motion> motions);
  /// Returns `first_contacts` of motions on lines, from where the bodies stand to these poses. Throws Error as above,
  /// and for a body that is not placed.
  std::vector<Scene_contact> first_contacts(std::span<const Pose> to);

  /// Returns the pairs of placed bodies that are at most `limit` apart, in order, compared as `Query::within` does.
  /// Only pairs whose boxes are as near are tested; the budget does not apply. Throws Error as `pairs` and as
  /// `Query::within`.
  std::vector<Scene_distance> pairs_within(const std::string& limit);

  /// Returns the pairs that the budget left undecided in the last frame, in order.
  const std::vector<Undecided_pair>& undecided() const;
  /// Returns the cost of the last frame, or of a later call of `first_contacts` or `pairs_within`.
  const Frame_statistics& statistics() const;

  /// Returns the relation of two placed bodies now. Throws Error as `pairs`, and for bodies that are not placed.
  Relation relation(std::size_t body_a, std::size_t body_b);
  /// Returns which of the eight relations of solids holds for them. Throws as `relation`, and as
  /// `Query::solid_relation`.
  Solid_contact solid_relation(std::size_t body_a, std::size_t body_b);
  /// Returns how much they overlap. Throws as `solid_relation`.
  Overlap overlap(std::size_t body_a, std::size_t body_b);
  /// Returns how far the first must be moved along a direction for them to part. Throws as `relation`, and as
  /// `Query::exits`.
  Exits exits(std::size_t body_a, std::size_t body_b, const std::array<std::string, 3>& direction);
  /// Returns the least translation of the first for them to part. Throws as `relation`, and as `Query::depth`.
  Depth depth(std::size_t body_a, std::size_t body_b, const Depth_options& options = {});
  /// Returns all pairs of their faces that share a point. Throws as `relation`, and as `Query::contacts`.
  Contacts contacts(std::size_t body_a, std::size_t body_b);
  /// Returns their distance. Throws as `relation`, and as `Query::distance`.
  double distance(std::size_t body_a, std::size_t body_b);
  /// True when their distance is at most `limit`. Throws as `relation`, and as `Query::within`.
  bool within(std::size_t body_a, std::size_t body_b, double limit);
  /// Returns the answer for a decimal, which stands for the nearest double, or a fraction "n/d". Throws as above.
  bool within(std::size_t body_a, std::size_t body_b, const std::string& limit);

 private:
  std::unique_ptr<detail::Scene_data> data_;
};

}  // namespace tetracone

#endif
