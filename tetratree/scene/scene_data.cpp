#include "tetracone/tetratree/scene/scene_data.h"

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/scene/number_groups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace tetracone::detail {
namespace {

std::uint64_t key_of(std::size_t a, std::size_t b)
{
  return std::uint64_t(kernel::minimum(a, b)) << 32 | kernel::maximum(a, b);
}

/// The room that a wide box leaves its body.
///
/// - `steps_ahead`: the room on every side, in steps like the last one.
/// - `most_room`: upper bound of that room, as a fraction of the body's size.
/// - `places_ahead`: the room ahead of a body that moves faster, in steps of its centre.
/// - `most_room_ahead`: upper bound of what this adds to the room on every side, as a fraction of the body's size.
constexpr double steps_ahead = 8, most_room = 1.0 / 8, places_ahead = 4, most_room_ahead = 1.0 / 2;

/// The room of new long bodies, which have many others near them; other new bodies get `most_room`.
constexpr double first_room_of_long = 1.0 / 16;

/// The number of steps within which `is_out_soon` looks.
constexpr double soon = 2;

/// A box that has grown by more than this fraction of its size is found anew, before the wide one is.
constexpr double most_grown = 1.0 / 32;

/// When trees of the models of new bodies are made at once.
///
/// - `looked_at`: upper bound of the new bodies whose near pairs are counted.
/// - `pairs_for_tree`: near pairs of a model that are a reason to make its tree.
constexpr std::size_t looked_at = 1024, pairs_for_tree = 32;

/// When more than one in this many bodies has changed, the boxes of all are updated at once.
constexpr std::size_t few_of_all = 8;

/// Distance of the prefetch of a body's list of near pairs, in bodies; its pairs are prefetched at half of it.
constexpr std::size_t lists_ahead = 8;

/// The parts of a search that threads share.
constexpr std::size_t parts_of_search = 64;

}  // namespace

Scene_data::Scene_data(const Scene_options& options) : models(options.question), options_(options)
{
  if (options.budget.count() < 0) throw Error("scene: a budget below 0; expected nanoseconds, or 0 for no limit");
  const auto most = std::size_t(tbb::this_task_arena::max_concurrency());
  const std::size_t threads = options.threads == 0 ? most : kernel::minimum(options.threads, most);
  if (threads > 1) arena_.emplace(int(threads));
  workers_.reserve(threads);
  for (std::size_t k = 0; k < threads; ++k) workers_.emplace_back(models, options_);
}

Scene_data::Placed_body& Scene_data::there(std::size_t body)
{
  if (body >= bodies_.size() || !bodies_[body].is_there)
    throw Error("scene: body " + std::to_string(body) + " is not there; expected the number of one that is");
  return bodies_[body];
}

Scene_data::Placed_body& Scene_data::placed(std::size_t body)
{
  Placed_body& known = there(body);
  if (!known.is_placed) throw Error("scene: body " + std::to_string(body) + " has no pose; expected a placed body");
  return known;
}

void Scene_data::require_model(std::size_t model) const
{
  if (model >= models.count())
    throw Error("scene: model " + std::to_string(model) + " of " + std::to_string(models.count()) +
                "; expected a model's number");
}

std::size_t Scene_data::add_body(std::size_t model)
{
  require_model(model);
  if (bodies_.size() >= std::numeric_limits<std::int32_t>::max())
    throw Error("scene: too many bodies; expected less than 2^31");
  bodies_.emplace_back().model = Number(model);
  poses_.emplace_back();
  places_.emplace_back();
  steps_.emplace_back();
  boxes_.emplace_back();
  wide_.emplace_back();
  seen_.push_back(0);
  near_.set_body_count(bodies_.size());
  return bodies_.size() - 1;
}

/// Removes a pair that is no longer near.
void Scene_data::part(Number pair)
{
  if (near_.bodies(pair).is_listed) left_.push_back(pair_of(pair));
  near_.remove(pair);
}

/// Removes the body's near pairs, and takes it out of the tree.
void Scene_data::leave(Number number)
{
  Placed_body& body = bodies_[number];
  while (!near_.of(number).empty()) part(near_.of(number).back().pair);
  if (body.is_in_tree) tree_.remove(number);
  body.is_in_tree = false;
}

void Scene_data::remove_body(std::size_t body)
{
  Placed_body& gone = there(body);
  leave(Number(body));
  gone.is_there = gone.is_placed = false;
}

void Scene_data::set_model(std::size_t body, std::size_t model)
{
  Placed_body& changed = there(body);
  require_model(model);
  if (changed.model == model) return;
  leave(Number(body));
  changed.model = Number(model);
  changed.is_turned = false;
  if (changed.is_placed && !changed.has_moved) {
    changed.has_moved = true;
    moved_.push_back(Number(body));
  }
}

void Scene_data::ignore(std::size_t a, std::size_t b)
{
  there(a);
  there(b);
  if (a == b) throw Error("scene: body " + std::to_string(a) + " with itself; expected two bodies to ignore");
  ignored_.insert(key_of(a, b));
  for (const auto& near : near_.of(Number(a)))
    if (near.other == b) {
      part(near.pair);
      break;
    }
}

bool Scene_data::is_ignored(std::size_t a, std::size_t b) const
{
  return !ignored_.empty() && ignored_.contains(key_of(a, b));
}

void Scene_data::place(std::size_t number, const kernel::Pose& pose)
{
  Placed_body& body = there(number);
  kernel::Pose& known = poses_[number];
  if (body.is_placed && known == pose) return;
  // A body in the tree has an extent and a centre.
  if (body.is_in_tree) step(Number(number), pose);
  known = pose;
  body.is_placed = true;
  if (body.has_moved) return;
  body.has_moved = true;
  moved_.push_back(Number(number));
}

/// Updates a body's centre and its rotation. Requires that its pose is still the old one.
void Scene_data::step(Number number, const kernel::Pose& to)
{
  Placed_body& body = bodies_[number];
  tetratree::Body_place& place = places_[number];
  const auto [at, turned] = tetratree::body_step(models.extent(body.model), poses_[number], to);
  Step& step = steps_[number];
  if (!body.has_moved) step = {};
  for (std::size_t k = 0; k < 3; ++k) step.by[k] += float(at[k] - place.at[k]);
  place.at = at;
  // `sum_above` is an upper bound only where doubles round to nearest.
  if (turned <= std::numeric_limits<double>::max() && kernel::floating_point_is_sound()) {
    step.turned += float(turned);
    place.turned = tetratree::sum_above(place.turned, turned);
  } else {
    body.is_lost = true;
  }
}

std::vector<std::size_t> Scene_data::present(std::size_t count, const std::string& what) const
{
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < bodies_.size(); ++k)
    if (bodies_[k].is_there) numbers.push_back(k);
  if (numbers.size() != count)
    throw Error("scene: " + std::to_string(count) + " " + what + " of " + std::to_string(numbers.size()) +
                " bodies; expected one a body");
  return numbers;
}

const std::vector<Scene_pair>& Scene_data::pairs()
{
  // An empty answer would be wrong for bodies without poses.
  if (std::ranges::any_of(bodies_, &Placed_body::is_there) && std::ranges::none_of(bodies_, &Placed_body::is_placed))
    throw Error("scene: no body has a pose; expected a body that is placed before pairs are asked for");
  kernel::require_exact_arithmetic();
  kernel::require_sound_floating_point();
  deadline_.reset();
  if (options_.budget.count() > 0) deadline_ = std::chrono::steady_clock::now() + options_.budget;
  const std::size_t nodes = models.nodes_made();
  statistics_ = {};
  ++frame_;
  move_bodies();
  open_pairs();
  ask_pairs();
  list_pairs();
  statistics_.nodes_made = models.nodes_made() - nodes;
  statistics_.bytes = bytes();
  return colliding_;
}

void Scene_data::move_bodies()
{
  std::erase_if(moved_, [this](Number body) { return !bodies_[body].is_there; });
  // All that can throw comes before anything is changed.
  look_at_models();
  std::vector<Number> out_of_their_boxes;
  for (const Number body : moved_)
    if (!bodies_[body].is_in_tree) out_of_their_boxes.push_back(body);
  make_trees(out_of_their_boxes);
  for_each(moved_.size(), 64, [this](std::size_t i, Scene_worker& worker) { move(moved_[i], worker); });
  statistics_.moved = moved_.size();
  out_of_their_boxes.clear();
  for (const Number body : moved_)
    if (bodies_[body].is_out) out_of_their_boxes.push_back(body);
  // One search for most of them costs less than two searches for half of them each.
  if (out_of_their_boxes.size() > moved_.size() / few_of_all)
    for (const Number body : moved_)
      if (!bodies_[body].is_out && is_out_soon(body)) out_of_their_boxes.push_back(body);
  widen(out_of_their_boxes);
}

/// Makes the missing models of bodies that have moved.
void Scene_data::look_at_models()
{
  known_models_.resize(models.count());
  for (const Number body : moved_)
    if (known(bodies_[body].model).is_long) turned_.resize(bodies_.size());
}

Scene_data::Known_model& Scene_data::known(Number number)
{
  Known_model& model = known_models_[number];
  if (model.frame == frame_) return model;
  model.extent = &models.extent(number);
  model.has_tree = models.tree(number) != nullptr;
  model.is_long = model.extent->is_long();
  model.frame = frame_;
  return model;
}

/// Makes the trees of models with many near pairs of new bodies. Their pairs would need the trees at once, and so their
/// boxes are tight from the start.
void Scene_data::make_trees(const std::vector<Number>& bodies)
{
  const bool has_model_without =
      std::ranges::any_of(bodies, [this](Number body) { return !known_models_[bodies_[body].model].has_tree; });
  if (!has_model_without || bodies.size() < pairs_for_tree || options_.memory != 0 ||
      options_.query.method != Method::tree)
    return;
  std::vector<World_box> boxes(bodies_.size());
  for_each(bodies.size(), 64, [&](std::size_t i, Scene_worker&) {
    const Number body = bodies[i];
    boxes[body] = tetratree::world_box(*known_models_[bodies_[body].model].extent, poses_[body]);
  });
  tetratree::Box_tree tree;
  tree.build(boxes, bodies);
  const std::size_t one_in = bodies.size() / looked_at + 1;
  for (std::size_t i = 0; i < bodies.size(); i += one_in) tree.mark(bodies[i]);
  std::vector<std::size_t> pairs(models.count());
  for (const auto& part : tree.parts(1))
    tree.for_meeting(part, [&](Number a, Number b) {
      for (const Number body : {a, b}) pairs[bodies_[body].model] += one_in;
    });
  for (Number model = 0; model < pairs.size(); ++model)
    if (pairs[model] >= 2 * pairs_for_tree) {
      data_of(models.body(model)).bvh8();
      known_models_[model].has_tree = true;
    }
}

/// Decides whether a body that has moved is out of its wide box. The boxes of long bodies, which have many near them,
/// are found anew; others are found where they are needed.
void Scene_data::move(Number number, Scene_worker& worker)
{
  Placed_body& body = bodies_[number];
  const Known_model& model = known_models_[body.model];
  const bool has_tree = model.has_tree;
  body.is_out = false;
  if (model.is_long) {
    turned_[number] = tetratree::turned_box(*model.extent, poses_[number]);
    body.is_turned = turned_[number].is_known;
  } else if (body.is_in_tree && !body.is_lost && body.is_tight == has_tree && body.is_wide_tight == has_tree &&
             boxes_[number].is_within(wide_[number], places_[number]))
    return;
  if (!body.is_in_tree) {
    // The body is new: its centre is set, and what it has turned does not matter.
    places_[number].at = tetratree::body_step(*known_models_[body.model].extent, poses_[number], poses_[number]).at;
    steps_[number] = {};
  }
  const bool has_changed = !body.is_in_tree || body.is_lost || body.is_tight != has_tree || model.is_long;
  if (has_changed || boxes_[number].grown(places_[number]) > most_grown * boxes_[number].size())
    find_box(number, worker);
  body.is_out = !body.is_in_tree || body.is_tight != body.is_wide_tight ||
                !boxes_[number].is_within(wide_[number], places_[number]);
}

/// True when a body will be out of its wide box soon, if it goes on as in the last frame.
bool Scene_data::is_out_soon(Number body) const
{
  tetratree::Body_place place = places_[body];
  for (std::size_t k = 0; k < 3; ++k) place.at[k] += soon * double(steps_[body].by[k]);
  place.turned += soon * double(steps_[body].turned);
  return !boxes_[body].is_within(wide_[body], place);
}

/// Finds a body's box at its present pose.
void Scene_data::find_box(Number number, Scene_worker& worker)
{
  Placed_body& body = bodies_[number];
  body.is_tight = models.tree(body.model) != nullptr;
  boxes_[number] = {worker.box(body.model, models.extent(body.model), poses_[number]), places_[number]};
}

/// Gives these bodies new wide boxes, and updates their near pairs.
void Scene_data::widen(const std::vector<Number>& bodies)
{
  if (bodies.empty()) return;
  for (const Number number : bodies) {
    Placed_body& body = bodies_[number];
    const auto& [by, turned] = steps_[number];
    const double size = boxes_[number].size(), most = most_room * size,
                 room = steps_ahead * (double(turned) + std::hypot(double(by[0]), double(by[1]), double(by[2])));
    const double at_first = (known_models_[body.model].is_long ? first_room_of_long : most_room) * size,
                 all_round = !body.is_in_tree ? at_first
                             : room < most    ? room
                                              : most;
    World_box& wide = wide_[number];
    wide = boxes_[number].at(places_[number]).grown(all_round);
    for (std::size_t k = 0; k < 3; ++k) {
      const double ahead = places_ahead * std::abs(double(by[k])) - all_round, most_ahead = most_room_ahead * size,
                   more = ahead < most_ahead ? ahead : most_ahead;
      if (!(more > 0)) continue;
      if (by[k] > 0)
        wide.high[k] += float(more);
      else
        wide.low[k] -= float(more);
    }
    body.is_wide_tight = body.is_tight;
    body.is_out = false;
    if (!body.is_in_tree) tree_is_old_ = body.is_in_tree = true;
  }
  if (tree_is_old_ || tree_.is_worn())
    build_boxes();
  else if (bodies.size() > bodies_.size() / few_of_all)
    tree_.set_all(wide_);
  else
    for (const Number body : bodies) tree_.set(body, wide_[body]);
  find_near(bodies);
}

void Scene_data::build_boxes()
{
  std::vector<Number> items;
  for (Number body = 0; body < bodies_.size(); ++body)
    if (bodies_[body].is_in_tree) items.push_back(body);
  tree_.build(wide_, items);
  tree_is_old_ = false;
}

/// Updates the near pairs of these bodies.
void Scene_data::find_near(const std::vector<Number>& bodies)
{
  for (const Number body : bodies) tree_.mark(body);
  const auto parts = tree_.parts(arena_ && bodies.size() >= parts_of_search ? parts_of_search : 1);
  std::vector<tetratree::Large_vector<std::array<Number, 2>>> found(parts.size());
  std::vector<std::size_t> opened(parts.size());
  for_each(parts.size(), 1, [&](std::size_t i, Scene_worker&) {
    opened[i] = tree_.for_meeting(parts[i], [&](Number a, Number b) { found[i].push_back({a, b}); });
  });
  for (const Number body : bodies) tree_.unmark(body);
  tree_.count_searches(bodies.size(), std::accumulate(opened.begin(), opened.end(), std::size_t(0)));

  constexpr Number none = std::numeric_limits<Number>::max();
  std::vector<Number> group(bodies_.size(), none);
  for (std::size_t i = 0; i < bodies.size(); ++i) group[bodies[i]] = Number(i);
  const tetratree::Number_groups others(bodies.size(), [&](const auto& put) {
    for (const auto& pairs : found)
      for (const auto [a, b] : pairs) {
        if (group[a] != none) put(group[a], b);
        if (group[b] != none) put(group[b], a);
      }
  });
  std::size_t pairs = 0;
  for (const auto& of_part : found) pairs += of_part.size();
  near_.make_room(pairs);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Number body = bodies[i];
    if (i + lists_ahead < bodies.size()) near_.fetch_list(bodies[i + lists_ahead]);
    if (i + lists_ahead / 2 < bodies.size()) near_.fetch_pairs(bodies[i + lists_ahead / 2]);
    const std::uint64_t search = ++search_;
    near_.make_room(body, others[i].size());
    for (const Number other : others[i]) seen_[other] = search;
    const auto known = near_.of(body);
    for (std::size_t k = known.size(); k-- > 0;) {
      const auto near = known[k];
      if (seen_[near.other] == search)
        seen_[near.other] = 0;  // a near pair already
      else
        part(near.pair);
    }
    for (const Number other : others[i])
      if (seen_[other] == search && !is_ignored(body, other)) near_.add(body, other);
  }
}

}  // namespace tetracone::detail
