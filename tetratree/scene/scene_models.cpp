#include "tetracone/tetratree/scene/scene_models.h"

#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/door/motion_solver.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace tetracone::detail {
namespace {

constexpr std::size_t bytes_of_point = sizeof(kernel::Point<kernel::Adaptive>);

/// The pairs of faces that are tested in the time that making the trees of two bodies takes for each of their faces.
constexpr double pairs_a_face_of_trees = 65;

struct Corners {
  std::size_t corners = 0, loops = 0;
};
Corners corners_of(const Polyhedron& polyhedron)
{
  Corners all;
  for (covering::Index f = 0; f < polyhedron.face_count(); ++f)
    for (std::size_t k = 0; k < polyhedron.loop_count(f); ++k, ++all.loops) all.corners += polyhedron.loop(f, k).size();
  return all;
}

/// Returns the bytes of the polyhedron alone, and with the covering that the tree has, computed from their counts.
std::array<std::size_t, 2> bytes_beside_tree(const Body_data& body)
{
  const std::size_t faces = body.polyhedron.face_count(), vertices = body.polyhedron.vertices.size();
  const auto [corners, loops] = corners_of(body.polyhedron);
  const std::size_t given = vertices * sizeof(kernel::Vertex) + corners * sizeof(covering::Index) +
                            (loops + faces) * sizeof(std::size_t) + body.triangles.size() * sizeof(Face_triangle);
  // An edge has two corners; a triangle of the covering has three.
  const std::size_t covered = vertices * (sizeof(kernel::Vertex) + bytes_of_point) +
                              3 * corners * sizeof(covering::Index) +
                              faces * (sizeof(std::size_t) + sizeof(std::optional<std::array<covering::Index, 3>>)) +
                              corners / 3 * sizeof(covering::Covering_triangle);
  return {given, given + covered};
}

/// Returns an upper bound of the bytes of a query's images of the body's vertices, and of its table of reaches.
std::size_t query_bytes(const Body& body)
{
  return body.polyhedron().vertices.size() * (bytes_of_point + 2 * sizeof(std::uint64_t)) + Scene_worker::table_bytes;
}

}  // namespace

Scene_models::Number Scene_models::add(std::function<Body()> make, const std::string& name, bool is_kept)
{
  models_.push_back({std::move(make), name, is_kept, false, std::nullopt, std::nullopt});
  return Number(models_.size() - 1);
}

const Body& Scene_models::body(Number number)
{
  Model& model = models_[number];
  if (!model.body) {
    Body made = model.make();
    if (question_ == Question::solid) require_solid(data_of(made), model.name, "Question::solid");
    model.bytes_beside_tree = bytes_beside_tree(data_of(made));
    model.faces = double(corners_of(made.polyhedron()).corners) / 3;
    model.pairs_left = pairs_a_face_of_trees * model.faces;
    model.body.emplace(std::move(made));
  }
  return *model.body;
}

const Body& Scene_models::body_of_triangles(Number number)
{
  const Body& of_model = body(number);
  Model& model = models_[number];
  if (!model.has_triangles) triangulated_tree(data_of(of_model), model.name);
  model.has_triangles = true;
  return of_model;
}

const tetratree::Body_extent& Scene_models::extent(Number number)
{
  Model& model = models_[number];
  if (!model.extent) model.extent.emplace(body(number).polyhedron().vertices);
  return *model.extent;
}

const tetratree::Bvh8* Scene_models::tree(Number number) const
{
  const Model& model = models_[number];
  return model.body ? data_of(*model.body).made_bvh8() : nullptr;
}

bool Scene_models::is_worth_no_tree(Number a, Number b)
{
  Model &of_a = models_[a], &of_b = models_[b];
  const double pairs = of_a.faces * of_b.faces, half = pairs / 2;
  if (tree(a) || tree(b) || of_a.pairs_left < half || of_b.pairs_left < half) return false;
  of_a.pairs_left -= half;
  of_b.pairs_left -= half;
  return true;
}

std::optional<Scene_models::Number> Scene_models::least_recently_used(Number not_this, Number nor_this) const
{
  std::optional<Number> least;
  for (Number m = 0; m < models_.size(); ++m)
    if (m != not_this && m != nor_this && models_[m].body && !models_[m].is_kept &&
        (!least || models_[m].used < models_[*least].used))
      least = m;
  return least;
}

void Scene_models::give_back(Number number)
{
  if (const tetratree::Bvh8* const tree = this->tree(number)) nodes_given_back_ += tree->node_count();
  models_[number].body.reset();
}

std::size_t Scene_models::bytes(Number number) const
{
  const Model& model = models_[number];
  if (!model.body) return 0;
  const tetratree::Bvh8* const tree = this->tree(number);
  return model.bytes_beside_tree[tree ? 1 : 0] + (tree ? tree->bytes() : 0);
}

std::size_t Scene_models::bytes() const
{
  std::size_t all = models_.capacity() * sizeof(Model);
  for (Number m = 0; m < models_.size(); ++m) all += bytes(m);
  return all;
}

std::size_t Scene_models::nodes_made() const
{
  std::size_t all = nodes_given_back_;
  for (Number m = 0; m < models_.size(); ++m)
    if (const tetratree::Bvh8* const tree = this->tree(m)) all += tree->node_count();
  return all;
}

Query& Scene_worker::query(Scene_models& models, Number a, Number b, Method method)
{
  Query_options options = options_->query;
  if (options.method == Method::tree) options.method = method;
  auto found = queries_.find({a, b, options.method});
  if (found == queries_.end()) {
    const Body &body_a = models.body(a), &body_b = models.body(b);
    const std::size_t bytes = query_bytes(body_a) + query_bytes(body_b);
    while (!queries_.empty() && query_bytes_ + bytes > most_query_bytes) {
      const auto oldest = std::ranges::min_element(queries_, {}, [](const auto& asked) { return asked.second.used; });
      query_bytes_ -= oldest->second.bytes;
      queries_.erase(oldest);
    }
    found = queries_
                .emplace(std::tuple(a, b, options.method),
                         Asked{std::make_unique<Query>(body_a, body_b, options_->question, options), bytes, 0})
                .first;
    query_bytes_ += bytes;
  }
  found->second.used = ++now_;
  return *found->second.query;
}

tetratree::World_box Scene_worker::box(Number model, const tetratree::Body_extent& extent, const kernel::Pose& pose)
{
  const tetratree::Bvh8* const tree = models_->tree(model);
  if (!tree || tree->empty()) return tetratree::world_box(extent, pose);
  if (model >= tables_.size()) tables_.resize(model + 1);
  if (!tables_[model]) tables_[model].emplace(*tree);
  const tetratree::World_box tight = tetratree::world_box(*tables_[model], tree->scale(), pose);
  return tight.is_bounded() ? tight : tetratree::world_box(extent, pose);
}

void Scene_worker::forget(Number model)
{
  if (model < tables_.size()) tables_[model].reset();
  for (auto asked = queries_.begin(); asked != queries_.end();) {
    const bool has_it = std::get<0>(asked->first) == model || std::get<1>(asked->first) == model;
    if (has_it) query_bytes_ -= asked->second.bytes;
    asked = has_it ? queries_.erase(asked) : std::next(asked);
  }
}

std::size_t Scene_worker::bytes() const
{
  std::size_t all = query_bytes_ + tables_.capacity() * sizeof(tables_[0]);
  for (const auto& table : tables_) all += table ? table_bytes : 0;
  return all;
}

}  // namespace tetracone::detail
