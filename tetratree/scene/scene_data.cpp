#include "tetracone/tetratree/scene/scene_data.h"

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/tetratree/scene/number_groups.h"

#include <array>
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

/// A wide box leaves room for so many steps like the last one, but not for more than that share of the body.
constexpr double steps_ahead = 8, most_room = 1.0 / 8;

/// Above that share of all bodies, one in so many, boxes of all are brought up to date at once.
constexpr std::size_t few_of_all = 8;

/// So many bodies before one's near pairs are changed, the memory is told to bring its list; half as many, its pairs.
constexpr std::size_t lists_ahead = 8;

/// Of a search, for threads to share.
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
  last_poses_.emplace_back();
  steps_.push_back(0);
  boxes_.emplace_back();
  wide_.emplace_back();
  ways_.emplace_back();
  seen_.push_back(0);
  near_.set_body_count(bodies_.size());
  return bodies_.size() - 1;
}

/// The two are near one another no more.
void Scene_data::part(Number pair)
{
  if (near_[pair].is_listed) left_.push_back(pair_of(pair));
  near_.remove(pair);
}

/// Takes the body out of all that is known of near ones.
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
  known = pose;
  body.is_placed = true;
  if (body.has_moved) return;
  body.has_moved = true;
  moved_.push_back(Number(number));
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
  // All that can fail comes before anything is changed.
  bool has_long = false;
  for (const Number body : moved_) has_long |= models.extent(bodies_[body].model).is_long();
  if (has_long) turned_.resize(bodies_.size());
  for_each(moved_.size(), 64, [this](std::size_t i, Scene_worker& worker) { move(moved_[i], worker); });
  statistics_.moved = moved_.size();
  std::vector<Number> out_of_their_boxes;
  for (const Number number : moved_) {
    const Placed_body& body = bodies_[number];
    if (!body.is_in_tree || body.is_tight != body.is_wide_tight || !wide_[number].holds(boxes_[number]))
      out_of_their_boxes.push_back(number);
  }
  widen(out_of_their_boxes);
}

void Scene_data::move(Number number, Scene_worker& worker)
{
  Placed_body& body = bodies_[number];
  const tetratree::Body_extent& extent = models.extent(body.model);
  const kernel::Pose& pose = poses_[number];
  kernel::Pose& last = last_poses_[number];
  steps_[number] = body.is_in_tree ? tetratree::motion(extent, last, pose) : std::numeric_limits<double>::infinity();
  last = pose;
  body.is_tight = models.tree(body.model) != nullptr;
  boxes_[number] = worker.box(body.model, extent, pose);
  ways_[number].moved = frame_;
  body.is_turned = extent.is_long();
  if (body.is_turned) {
    turned_[number] = tetratree::turned_box(extent, pose);
    body.is_turned = turned_[number].is_known;
  }
}

/// Gives these bodies new wide boxes, and finds what is near them.
void Scene_data::widen(const std::vector<Number>& bodies)
{
  if (bodies.empty()) return;
  for (const Number number : bodies) {
    Placed_body& body = bodies_[number];
    const World_box& box = boxes_[number];
    const double room = steps_ahead * steps_[number], most = most_room * box.size();
    wide_[number] = box.grown(!body.is_in_tree ? 0 : room < most ? room : most);
    body.is_wide_tight = body.is_tight;
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

/// Brings the near pairs of these bodies up to date.
void Scene_data::find_near(const std::vector<Number>& bodies)
{
  for (const Number body : bodies) tree_.mark(body);
  const auto parts = tree_.parts(arena_ && bodies.size() >= parts_of_search ? parts_of_search : 1);
  std::vector<std::vector<std::array<Number, 2>>> found(parts.size());
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
        seen_[near.other] = 0;  // known
      else
        part(near.pair);
    }
    for (const Number other : others[i])
      if (seen_[other] == search && !is_ignored(body, other)) near_.add(body, other);
  }
}

}  // namespace tetracone::detail
