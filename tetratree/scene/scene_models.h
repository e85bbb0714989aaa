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
#include <utility>
#include <vector>

namespace tetracone::detail {

/// The models of a scene: each is made when a body of it is first placed, and its tree when a query asks for it.
class Scene_models {
 public:
  using Number = std::uint32_t;

  explicit Scene_models(Question question) : question_(question) {}

  std::size_t count() const { return models_.size(); }
  Number add(std::function<Body()> make, const std::string& name, bool is_kept);

  /// The body, made now if it has to be. Throws what making it throws, and Error where it has no solid to be asked for.
  const Body& body(Number model);
  /// The same of a body that motions can follow. Throws Error also where a face has no triangles.
  const Body& body_of_triangles(Number model);
  const tetratree::Body_extent& extent(Number model);
  /// Its tree, or nothing where none has been made.
  const tetratree::Bvh8* tree(Number model) const;

  /// Whether a question about bodies of these models is to be asked of all pairs of their faces, since that costs less
  /// than their trees, which are not there yet, and what such questions have cost so far does too. Counts the question.
  bool is_worth_no_tree(Number a, Number b);

  /// Marks a model as needed now.
  void use(Number model) { models_[model].used = ++now_; }
  /// The model that has been used least recently, of those that can be given back and are not these two.
  std::optional<Number> least_recently_used(Number not_this, Number nor_this) const;
  /// Gives back a model: it is made again when it is needed.
  void give_back(Number model);

  const std::string& name(Number model) const { return models_[model].name; }
  std::size_t bytes(Number model) const;
  std::size_t bytes() const;
  /// Of all trees, those given back included.
  std::size_t nodes_made() const;

 private:
  struct Model {
    std::function<Body()> make;
    std::string name;
    bool is_kept;                // by whoever gave it
    bool has_triangles = false;  // where that is known
    std::optional<Body> body;
    std::optional<tetratree::Body_extent> extent;
    std::array<std::size_t, 2> bytes_beside_tree{};  // before there is one, and after
    double faces = 0;                                // as triangles
    double pairs_left = 0;                           // that may be asked before a tree is made
    std::uint64_t used = 0;
  };

  Question question_;
  std::vector<Model> models_;
  std::uint64_t now_ = 0;
  std::size_t nodes_given_back_ = 0;
};

/// What one thread asks models with: a query for each pair of them, a table of reach for each.
class Scene_worker {
 public:
  using Number = Scene_models::Number;

  Scene_worker(const Scene_models& models, const Scene_options& options) : models_(&models), options_(&options) {}

  /// Requires bodies that are made. `method`: tree or brute; where the scene's options name another, it is that.
  Query& query(Scene_models& models, Number a, Number b, Method method = Method::tree);

  /// The tightest that is known: by the tree where there is one.
  tetratree::World_box box(Number model, const tetratree::Body_extent& extent, const kernel::Pose& pose);

  /// Drops what is about this model.
  void forget(Number model);

  std::size_t bytes() const;

  static constexpr std::size_t table_bytes =
      8 * tetratree::Support_table::row * tetratree::Support_table::row * sizeof(float);

 private:
  struct Asked {
    std::unique_ptr<Query> query;
    std::size_t bytes;
    std::uint64_t used;
  };
  /// Queries beyond that many bytes are dropped, and made again when they are needed.
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
