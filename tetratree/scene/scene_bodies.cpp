#include "tetracone/tetratree/scene/scene_bodies.h"

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/memory/pair_certificate.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace tetracone::detail {
namespace {

/// The room that a wide box leaves its body.
///
/// - `steps_ahead`: the room on every side, in steps like the last one.
/// - `most_room`: upper bound of that room, as a fraction of the body's size.
/// - `places_ahead`: the room ahead of a body that moves faster, in steps of its centre.
/// - `most_room_ahead`: upper bound of what this adds to the room on every side, as a fraction of the body's size.
constexpr double steps_ahead = 8, most_room = 1.0 / 8, places_ahead = 4, most_room_ahead = 1.0 / 2;

/// The room of new long bodies, which have many others near them; other new bodies get `most_room`.
constexpr double first_room_of_long = 1.0 / 16;

/// The number of steps that `is_out_soon` looks ahead.
constexpr double soon = 2;

/// A box that has grown by more than this fraction of its size is found anew, before the wide one is.
constexpr double most_grown = 1.0 / 32;

/// When trees of the models of new bodies are made at once.
///
/// - `looked_at`: upper bound of the new bodies whose near pairs are counted.
/// - `pairs_for_tree`: near pairs of a model that are a reason to make its tree.
constexpr std::size_t looked_at = 1024, pairs_for_tree = 32;

/// When more than one in this many bodies of the scene needs a new wide box, all boxes of the tree are updated at once.
/// When more than one in this many moved bodies does, bodies that will need one soon get it, too.
constexpr std::size_t few_of_all = 8;

/// The parts of a search that threads share.
constexpr std::size_t parts_of_search = 64;

}  // namespace

Scene_bodies::Scene_bodies(const Scene_options& of_scene) : options(of_scene), models(of_scene.question)
{
  if (options.budget.count() < 0) throw Error("scene: a budget below 0; expected nanoseconds, or 0 for no limit");
  const auto most = std::size_t(tbb::this_task_arena::max_concurrency());
  const std::size_t threads = options.threads == 0 ? most : kernel::minimum(options.threads, most);
  if (threads > 1) arena_.emplace(int(threads));
  workers.reserve(threads);
  for (std::size_t k = 0; k < threads; ++k) workers.emplace_back(models, options);
}

Placed_body& Scene_bodies::there(std::size_t body)
{
  if (body >= states.size() || !states[body].is_there())
    throw Error("scene: body " + std::to_string(body) + " is not there; expected the number of one that is");
  return states[body];
}

Placed_body& Scene_bodies::placed(std::size_t body)
{
  Placed_body& known = there(body);
  if (!known.is_placed()) throw Error("scene: body " + std::to_string(body) + " has no pose; expected a placed body");
  return known;
}

void Scene_bodies::require_model(std::size_t model) const
{
  if (model >= models.count())
    throw Error("scene: model " + std::to_string(model) + " of " + std::to_string(models.count()) +
                "; expected a model's number");
}

std::size_t Scene_bodies::add(std::size_t model)
{
  require_model(model);
  if (states.size() >= std::numeric_limits<std::int32_t>::max())
    throw Error("scene: too many bodies; expected less than 2^31");
  states.emplace_back().model = Number(model);
  poses.emplace_back();
  places.emplace_back();
  steps_.emplace_back();
  boxes.emplace_back();
  wide_.emplace_back();
  return states.size() - 1;
}

void Scene_bodies::remove(Number body)
{
  leave_tree(body);
  states[body].presence = Presence::removed;
}

void Scene_bodies::set_model(Number number, Number model)
{
  leave_tree(number);
  Placed_body& changed = states[number];
  changed.model = model;
  changed.is_turned = false;
  if (changed.is_placed()) mark_moved(number);
}

void Scene_bodies::leave_tree(Number number)
{
  Placed_body& body = states[number];
  if (!body.is_in_tree()) return;
  tree_.remove(number);
  body.presence = Presence::placed;
}

void Scene_bodies::place(std::size_t number, const kernel::Pose& pose)
{
  Placed_body& body = there(number);
  kernel::Pose& known = poses[number];
  if (body.is_placed() && known == pose) return;
  // A body in the tree has an extent and a centre.
  const bool is_bounded = !body.is_in_tree() || step(Number(number), pose);
  known = pose;
  if (!body.is_in_tree()) body.presence = Presence::placed;
  mark_moved(Number(number));
  if (!is_bounded) body.moved = Moved::lost;
}

void Scene_bodies::mark_moved(Number body)
{
  if (states[body].moved != Moved::no) return;
  states[body].moved = Moved::yes;
  moved.push_back(body);
}

/// Updates a body's centre and its rotation. False where the rotation has no bound. Requires that its pose is still the
/// old one.
bool Scene_bodies::step(Number number, const kernel::Pose& to)
{
  const Placed_body& body = states[number];
  tetratree::Body_place& place = places[number];
  const auto [at, turned] = tetratree::body_step(models.extent(body.model), poses[number], to);
  Step& step = steps_[number];
  if (body.moved == Moved::no) step = {};
  for (std::size_t k = 0; k < 3; ++k) step.by[k] += float(at[k] - place.at[k]);
  place.at = at;
  // `sum_above` is an upper bound only where doubles round to nearest.
  if (!(turned <= std::numeric_limits<double>::max()) || !kernel::floating_point_is_sound()) return false;
  step.turned += float(turned);
  place.turned = tetratree::sum_above(place.turned, turned);
  return true;
}

std::vector<Scene_bodies::Number> Scene_bodies::update_boxes()
{
  ++frame_;
  std::erase_if(moved, [this](Number body) { return !states[body].is_there(); });
  // All that can throw comes before anything is changed.
  look_at_models();
  std::vector<Number> out_of_their_boxes;
  for (const Number body : moved)
    if (!states[body].is_in_tree()) out_of_their_boxes.push_back(body);
  make_trees(out_of_their_boxes);
  for_each(moved.size(), 64, [this](std::size_t i, Scene_worker& worker) { move(moved[i], worker); });
  out_of_their_boxes.clear();
  for (const Number body : moved)
    if (states[body].is_out) out_of_their_boxes.push_back(body);
  // One search for most of them costs less than two searches for half of them each.
  if (out_of_their_boxes.size() > moved.size() / few_of_all)
    for (const Number body : moved)
      if (!states[body].is_out && is_out_soon(body)) out_of_their_boxes.push_back(body);
  if (!out_of_their_boxes.empty()) widen(out_of_their_boxes);
  return out_of_their_boxes;
}

/// Makes the missing models of bodies that have moved.
void Scene_bodies::look_at_models()
{
  known_models_.resize(models.count());
  for (const Number body : moved)
    if (known(states[body].model).is_long) turned_.resize(states.size());
}

Scene_bodies::Known_model& Scene_bodies::known(Number number)
{
  Known_model& model = known_models_[number];
  if (model.frame == frame_) return model;
  model.extent = &models.extent(number);
  model.best = best_of(number);
  model.is_long = model.extent->is_long();
  model.frame = frame_;
  return model;
}

/// Makes the trees of models with many near pairs of new bodies. Their pairs would need the trees at once, and so their
/// boxes are tight from the start.
void Scene_bodies::make_trees(const std::vector<Number>& bodies)
{
  const bool has_model_without = std::ranges::any_of(
      bodies, [this](Number body) { return known_models_[states[body].model].best != Found_by::tree; });
  if (!has_model_without || bodies.size() < pairs_for_tree || options.memory != 0 ||
      options.query.method != Method::tree)
    return;
  std::vector<World_box> new_boxes(states.size());
  for_each(bodies.size(), 64, [&](std::size_t i, Scene_worker&) {
    const Number body = bodies[i];
    new_boxes[body] = tetratree::world_box(*known_models_[states[body].model].extent, poses[body]);
  });
  tetratree::Box_tree tree;
  tree.build(new_boxes, bodies);
  const std::size_t one_in = bodies.size() / looked_at + 1;
  for (std::size_t i = 0; i < bodies.size(); i += one_in) tree.mark(bodies[i]);
  std::vector<std::size_t> pairs(models.count());
  for (const auto& part : tree.parts(1))
    tree.for_meeting(part, [&](Number a, Number b) {
      for (const Number body : {a, b}) pairs[states[body].model] += one_in;
    });
  for (Number model = 0; model < pairs.size(); ++model)
    if (pairs[model] >= 2 * pairs_for_tree) {
      data_of(models.body(model)).bvh8();
      known_models_[model].best = Found_by::tree;
    }
}

/// Decides whether a body that has moved is out of its wide box. The boxes of long bodies, which have many near them,
/// are found anew; others are found where they are needed.
void Scene_bodies::move(Number number, Scene_worker& worker)
{
  Placed_body& body = states[number];
  const Known_model& model = known_models_[body.model];
  const bool is_bounded = body.is_in_tree() && body.moved != Moved::lost;
  body.is_out = false;
  if (model.is_long) {
    turned_[number] = tetratree::turned_box(*model.extent, poses[number]);
    body.is_turned = turned_[number].is_known;
  } else if (is_bounded && body.box == model.best && body.wide_box == model.best &&
             boxes[number].is_within(wide_[number], places[number]))
    return;
  if (!body.is_in_tree()) {
    // The body is new: its centre is set, and what it has turned does not matter.
    places[number].at = tetratree::body_step(*model.extent, poses[number], poses[number]).at;
    steps_[number] = {};
  }
  if (!is_bounded || body.box != model.best || model.is_long ||
      boxes[number].grown(places[number]) > most_grown * boxes[number].size())
    find_box(number, worker);
  body.is_out =
      !body.is_in_tree() || body.box != body.wide_box || !boxes[number].is_within(wide_[number], places[number]);
}

/// True when a body will be out of its wide box soon, if it goes on as in the last frame.
bool Scene_bodies::is_out_soon(Number body) const
{
  tetratree::Body_place place = places[body];
  for (std::size_t k = 0; k < 3; ++k) place.at[k] += soon * double(steps_[body].by[k]);
  place.turned += soon * double(steps_[body].turned);
  return !boxes[body].is_within(wide_[body], place);
}

/// Returns the way in which the boxes of a model's bodies are found now.
Found_by Scene_bodies::best_of(Number model) const
{
  return models.tree(model) != nullptr ? Found_by::tree : Found_by::extent;
}

void Scene_bodies::find_box(Number number, Scene_worker& worker)
{
  Placed_body& body = states[number];
  body.box = best_of(body.model);
  boxes[number] = {worker.box(body.model, models.extent(body.model), poses[number]), places[number]};
}

/// Gives these bodies new wide boxes.
void Scene_bodies::widen(const std::vector<Number>& bodies)
{
  for (const Number number : bodies) {
    Placed_body& body = states[number];
    const auto& [by, turned] = steps_[number];
    const double size = boxes[number].size(), most = most_room * size,
                 room = steps_ahead * (double(turned) + std::hypot(double(by[0]), double(by[1]), double(by[2])));
    const double at_first = (known_models_[body.model].is_long ? first_room_of_long : most_room) * size,
                 all_round = !body.is_in_tree() ? at_first
                             : room < most      ? room
                                                : most;
    World_box& wide = wide_[number];
    wide = boxes[number].at(places[number]).grown(all_round);
    for (std::size_t k = 0; k < 3; ++k) {
      const double ahead = places_ahead * std::abs(double(by[k])) - all_round, most_ahead = most_room_ahead * size,
                   more = ahead < most_ahead ? ahead : most_ahead;
      if (!(more > 0)) continue;
      if (by[k] > 0)
        wide.high[k] += float(more);
      else
        wide.low[k] -= float(more);
    }
    body.wide_box = body.box;
    body.is_out = false;
    tree_is_old_ |= !body.is_in_tree();
    body.presence = Presence::in_tree;
  }
  if (tree_is_old_ || tree_.is_worn())
    build_tree();
  else if (bodies.size() > states.size() / few_of_all)
    tree_.set_all(wide_);
  else
    for (const Number body : bodies) tree_.set(body, wide_[body]);
}

void Scene_bodies::build_tree()
{
  std::vector<Number> items;
  for (Number body = 0; body < states.size(); ++body)
    if (states[body].is_in_tree()) items.push_back(body);
  tree_.build(wide_, items);
  tree_is_old_ = false;
}

void Scene_bodies::tighten(Number number)
{
  Placed_body& body = states[number];
  if (body.box == Found_by::tree) return;
  data_of(models.body(body.model)).bvh8();
  find_box(number, workers[0]);
}

std::pair<Scene_bodies::Number, Scene_bodies::Number> Scene_bodies::models_of(std::size_t a, std::size_t b) const
{
  const Number of_a = states[a].model, of_b = states[b].model;
  return of_a < of_b ? std::pair(of_a, of_b) : std::pair(of_b, of_a);
}

tetratree::Turned_box Scene_bodies::turned_box(Number body)
{
  return states[body].is_turned ? turned_[body] : tetratree::turned_box(models.extent(states[body].model), poses[body]);
}

void Scene_bodies::fetch_box(Number body) const
{
  __builtin_prefetch(&boxes[body]);
  __builtin_prefetch(&places[body]);
}

void Scene_bodies::fetch_turned_box(Number body) const
{
  const auto* const box = reinterpret_cast<const char*>(&turned_[body]);
  __builtin_prefetch(box);
  __builtin_prefetch(box + 64);
}

void Scene_bodies::fetch_pose(Number body) const
{
  const double* const entries = poses[body].entries().data();
  __builtin_prefetch(entries);
  __builtin_prefetch(entries + 8);
  __builtin_prefetch(entries + 14);
}

std::vector<tetratree::Large_vector<Body_pair>> Scene_bodies::meeting(const std::vector<Number>& searched)
{
  for (const Number body : searched) tree_.mark(body);
  const auto parts = tree_.parts(arena_ && searched.size() >= parts_of_search ? parts_of_search : 1);
  std::vector<tetratree::Large_vector<Body_pair>> found(parts.size());
  std::vector<std::size_t> opened(parts.size());
  for_each(parts.size(), 1, [&](std::size_t i, Scene_worker&) {
    opened[i] = tree_.for_meeting(parts[i], [&](Number a, Number b) { found[i].push_back({a, b}); });
  });
  for (const Number body : searched) tree_.unmark(body);
  tree_.count_searches(searched.size(), std::accumulate(opened.begin(), opened.end(), std::size_t(0)));
  return found;
}

std::size_t Scene_bodies::bytes() const
{
  std::size_t all = models.bytes() + tree_.bytes() +
                    states.capacity() * (sizeof(Placed_body) + sizeof(kernel::Pose) + sizeof(tetratree::Body_place) +
                                         sizeof(Step) + sizeof(tetratree::Body_box) + sizeof(World_box)) +
                    turned_.capacity() * sizeof(tetratree::Turned_box);
  for (const Scene_worker& worker : workers) all += worker.bytes();
  return all;
}

}  // namespace tetracone::detail
