#ifndef TETRACONE_TETRATREE_SCENE_SCENE_MODELS_H
#define TETRACONE_TETRATREE_SCENE_SCENE_MODELS_H

#include "tetracone/tetratree/fast/support_table.h"
#include "tetracone/tetratree/scene/body_extent.h"
#include "tetracone/tetratree/scene/scene.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace tetracone::detail {

/// The models of a scene. A model is made when a frame or a question first needs it. Its tree is made when a query or a
/// tight box needs it.
class Scene_models {
 public:
  using Number = std::uint32_t;

  explicit Scene_models(Question question) : question_(question) {}

  std::size_t count() const { return models_.size(); }
  /// Adds a model; returns its number. `is_kept`: the caller keeps the body, so giving it back frees nothing.
  Number add(std::function<Body()> make, const std::string& name, bool is_kept);

  /// Returns the body, made now if need be. The reference is valid until `add` or `give_back`. Throws what making it
  /// throws, and Error where the question is `solid` and the body is open.
  const Body& body(Number model);
  /// Same, for a body that motions can follow. Throws Error also where a face has no triangles.
  const Body& body_of_triangles(Number model);
  /// Returns the body's extent, made now if need be, with the body. `give_back` keeps it. The reference is valid until
  /// `add`. Throws as `body`.
  const tetratree::Body_extent& extent(Number model);
  /// Returns the model's tree; null if none has been made.
  const tetratree::Bvh8* tree(Number model) const;

  /// True when a query about bodies of these models is to test all pairs of their faces. That is so while neither has a
  /// tree and all such queries so far, this one included, cost less than making the trees. Counts the query where it
  /// returns true. Requires models that have been made once.
  bool is_worth_no_tree(Number a, Number b);

  /// Marks a model as needed now.
  void use(Number model) { models_[model].used = ++now_; }
  /// Returns the least recently used model that can be given back and is neither of these two.
  std::optional<Number> least_recently_used(Number not_this, Number nor_this) const;
  /// Gives back a model; it is made again when it is needed.
  void give_back(Number model);

  const std::string& name(Number model) const { return models_[model].name; }
  /// Return the bytes of a model's body and tree, as far as they are made, and those of all models.
  std::size_t bytes(Number model) const;
  std::size_t bytes() const;
  /// Returns the number of nodes of all trees, including trees that were given back.
  std::size_t nodes_made() const;

 private:
  struct Model {
    std::function<Body()> make;
    std::string name;
    bool is_kept;                // see `add`
    bool has_triangles = false;  // true once it has been checked
    std::optional<Body> body;
    std::optional<tetratree::Body_extent> extent;
    std::array<std::size_t, 2> bytes_beside_tree{};  // before the tree is made, and after
    double faces = 0;                                // counted as triangles
    double pairs_left = 0;                           // pairs of faces that may be tested before a tree is made
    std::uint64_t used = 0;
  };

  Question question_;
  std::vector<Model> models_;
  std::uint64_t now_ = 0;
  std::size_t nodes_given_back_ = 0;
};

/// The queries and tables of reaches of one thread: a query for each pair of models, a table for each model.
class Scene_worker {
 public:
  using Number = Scene_models::Number;

  /// Both must outlive this object.
  Scene_worker(const Scene_models& models, const Scene_options& options) : models_(&models), options_(&options) {}

  /// Returns the query of two models. Several threads may call it only for bodies that are made. `method` is tree or
  /// brute; if the scene's options name another method, that one is used. The reference is valid until the next call of
  /// `query` or `forget`.
  Query& query(Scene_models& models, Number a, Number b, Method method = Method::tree);

  /// Returns the tightest box that is available: by the tree where there is one, else by the extent.
  tetratree::World_box box(Number model, const tetratree::Body_extent& extent, const kernel::Pose& pose);

  /// Drops the queries and the table of this model.
  void forget(Number model);

  /// Returns an upper bound of the bytes of the queries and the tables, except the bodies'.
  std::size_t bytes() const;

  /// Bytes of a table of reaches.
  static constexpr std::size_t table_bytes =
      8 * tetratree::Support_table::row * tetratree::Support_table::row * sizeof(float);

 private:
  struct Asked {
    std::unique_ptr<Query> query;
    std::size_t bytes;
    std::uint64_t used;
  };
  /// Upper bound of the bytes of queries. Older queries are dropped, and made again when they are needed.
  static constexpr std::size_t most_query_bytes = std::size_t(1) << 28;

  const Scene_models* models_;
  const Scene_options* options_;
  std::map<std::tuple<Number, Number, Method>, Asked> queries_;
  std::vector<std::optional<tetratree::Support_table>> tables_;  // of each model
  std::size_t query_bytes_ = 0;
  std::uint64_t now_ = 0;
};

}  // namespace tetracone::detail

#endif
