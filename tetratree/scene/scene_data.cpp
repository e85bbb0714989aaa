#include "tetracone/tetratree/scene/scene_data.h"

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/tetratree/door/body_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <utility>

namespace tetracone::detail {
namespace {

std::uint64_t key_of(std::size_t a, std::size_t b)
{
  return std::uint64_t(kernel::minimum(a, b)) << 32 | kernel::maximum(a, b);
}

/// A sum of what is not negative, rounded up or down.
double sum_above(double x, double y) { return y == 0 ? x : std::nextafter(x + y, std::numeric_limits<double>::max()); }
double sum_below(double x, double y) { return y == 0 ? x : std::nextafter(x + y, 0.0); }

/// A wide box leaves room for so many steps like the last one, but not for more than half of the body.
constexpr double steps_ahead = 4;

/// Bodies that have moved by more than this share of the smaller one since they were asked get no front.
constexpr double little = 1.0 / 64;

/// What a front may take before it is made, and all of them.
constexpr std::size_t bytes_of_front = std::size_t(1) << 17, most_bytes_of_fronts = std::size_t(1) << 28;

double size_of(const tetratree::World_box& box)
{
  double size = 0;
  for (int k = 0; k < 3; ++k) size = kernel::maximum(size, double(box.high[k]) - double(box.low[k]));
  return size;
}

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
  wide_.emplace_back();
  turned_.emplace_back();
  way_.push_back(0);
  seen_.push_back(0);
  near_.set_body_count(bodies_.size());
  return bodies_.size() - 1;
}

/// The two are near one another no more.
void Scene_data::part(Number pair)
{
  const Near_pair& gone = near_[pair];
  if (gone.is_listed) left_.push_back({gone.body[0], gone.body[1]});
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
  for (const auto& [pair, other] : near_.of(Number(a)))
    if (other == b) {
      part(pair);
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
  if (body.is_placed && body.pose == pose) return;
  body.pose = pose;
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
  for (const Number body : moved_) models.extent(bodies_[body].model);
  for_each(moved_.size(), 64, [this](std::size_t i, Scene_worker& worker) { move(moved_[i], worker); });
  statistics_.moved = moved_.size();
  std::vector<Number> out_of_their_boxes;
  for (const Number body : moved_)
    if (!bodies_[body].is_in_tree || !wide_[body].holds(bodies_[body].box)) out_of_their_boxes.push_back(body);
  widen(std::move(out_of_their_boxes));
}

void Scene_data::move(Number number, Scene_worker& worker)
{
  Placed_body& body = bodies_[number];
  const tetratree::Body_extent& extent = models.extent(body.model);
  body.step =
      body.is_in_tree ? tetratree::motion(extent, body.last_pose, body.pose) : std::numeric_limits<double>::infinity();
  body.last_pose = body.pose;
  body.is_tight = models.tree(body.model) != nullptr;
  body.box = worker.box(body.model, extent, body.pose);
  turned_[number] = extent.is_long() ? tetratree::turned_box(extent, body.pose) : tetratree::Turned_box();
}

/// Gives these bodies new wide boxes, and finds what is near them.
void Scene_data::widen(std::vector<Number> bodies)
{
  for (const Number number : bodies) {
    Placed_body& body = bodies_[number];
    const double room = steps_ahead * body.step;
    wide_[number] = body.is_in_tree && room < size_of(body.box) / 2 ? body.box.grown(room) : body.box.grown(0);
    if (body.is_in_tree)
      tree_.set(number, wide_[number]);
    else
      tree_is_old_ = body.is_in_tree = true;
  }
  if (tree_is_old_ || tree_.is_worn() || 4 * bodies.size() > 3 * bodies_.size()) build_boxes();
  find_near(bodies);
}

void Scene_data::build_boxes()
{
  std::vector<Number> items;
  for (Number body = 0; body < bodies_.size(); ++body)
    if (bodies_[body].is_in_tree) items.push_back(body);
  tree_.build(wide_, std::move(items));
  tree_is_old_ = false;
}

/// Brings the near pairs of these bodies up to date.
void Scene_data::find_near(const std::vector<Number>& bodies)
{
  std::vector<std::vector<Number>> found(bodies.size());
  std::vector<std::size_t> opened(bodies.size());
  for_each(bodies.size(), 32, [&](std::size_t i, Scene_worker&) {
    opened[i] = tree_.for_meeting(wide_[bodies[i]], [&](Number other) {
      if (other != bodies[i]) found[i].push_back(other);
    });
  });
  std::size_t all_opened = 0;
  for (const std::size_t n : opened) all_opened += n;
  tree_.count_searches(bodies.size(), all_opened);

  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Number body = bodies[i];
    const std::uint64_t search = ++search_;
    for (const Number other : found[i]) seen_[other] = search;
    const auto known = near_.of(body);
    for (std::size_t k = known.size(); k-- > 0;) {
      const auto [pair, other] = known[k];
      if (seen_[other] == search) {
        seen_[other] = 0;  // known
        continue;
      }
      part(pair);
    }
    for (const Number other : found[i])
      if (seen_[other] == search && !is_ignored(body, other)) near_.add(body, other);
  }
}

/// Opens the near pairs of bodies that have moved, but for those that are still apart.
void Scene_data::open_pairs()
{
  std::erase_if(open_, [this](Number pair) { return !near_[pair].is_open; });
  for (const Number number : moved_) {
    const Placed_body& body = bodies_[number];
    if (body.step <= std::numeric_limits<double>::max())
      way_[number] = sum_above(way_[number], body.step);
    else
      for (const auto& [pair, other] : near_.of(number)) near_[pair].limit = -1;
  }
  for (const Number body : moved_) {
    bodies_[body].has_moved = false;
    for (const auto& [number, other] : near_.of(body)) {
      if (bodies_[other].has_moved) continue;  // its turn comes
      const Near_pair& pair = near_[number];
      if (pair.is_open) continue;
      if (pair.asked != Near_pair::never && way(pair) < pair.limit)
        ++statistics_.kept;
      else
        open_pair(number);
    }
  }
  moved_.clear();
}

void Scene_data::open_pair(Number number)
{
  near_[number].is_open = true;
  open_.push_back(number);
}

/// A bound on the motions of both bodies, from above.
double Scene_data::way(const Near_pair& pair) const { return sum_above(way_[pair.body[0]], way_[pair.body[1]]); }

/// Where they do not collide, they are at least `gap` apart.
void Scene_data::answer(Near_pair& pair, bool collide, double gap)
{
  pair.collide = collide;
  pair.is_open = false;
  pair.asked = frame_;
  pair.way = way(pair);
  pair.limit = gap > 0 ? sum_below(sum_below(way_[pair.body[0]], way_[pair.body[1]]), gap) : -1;
}

/// By the tree, which is made now if it has to be.
void Scene_data::tighten(Placed_body& body)
{
  if (body.is_tight) return;
  data_of(models.body(body.model)).bvh8();
  body.box = workers_[0].box(body.model, models.extent(body.model), body.pose);
  body.is_tight = true;
}

std::pair<Scene_data::Number, Scene_data::Number> Scene_data::models_of(std::size_t a, std::size_t b) const
{
  const Number of_a = bodies_[a].model, of_b = bodies_[b].model;
  return of_a < of_b ? std::pair(of_a, of_b) : std::pair(of_b, of_a);
}

void Scene_data::ask_pairs()
{
  if (options_.memory != 0)
    std::sort(open_.begin(), open_.end(), [this](Number p, Number q) {
      const auto of_p = models_of(near_[p]), of_q = models_of(near_[q]);
      return of_p != of_q
                 ? of_p < of_q
                 : std::pair(near_[p].body[0], near_[p].body[1]) < std::pair(near_[q].body[0], near_[q].body[1]);
    });
  for_each_models(
      open_, [this](Number pair) { return models_of(near_[pair]); },
      [this](auto first, auto last) { ask_models(first, last); });
}

/// Asks open pairs: their boxes, then their models.
void Scene_data::ask_models(std::vector<Number>::iterator first, std::vector<Number>::iterator last)
{
  std::vector<Number> meeting, candidates;
  for (auto at = first; at != last; ++at) {
    Near_pair& pair = near_[*at];
    const double gap = bodies_[pair.body[0]].box.gap(bodies_[pair.body[1]].box);
    if (gap > 0)
      answer(pair, false, gap);
    else
      meeting.push_back(*at);
  }
  ask_turned_boxes(meeting);
  for (const Number number : meeting) {
    Near_pair& pair = near_[number];
    Placed_body &a = bodies_[pair.body[0]], &b = bodies_[pair.body[1]];
    pair.by_brute_force = models.is_worth_no_tree(a.model, b.model);
    if (!pair.by_brute_force && !(a.is_tight && b.is_tight)) {
      tighten(a);
      tighten(b);
      const double gap = a.box.gap(b.box);
      if (gap > 0) {
        answer(pair, false, gap);
        continue;
      }
    }
    models.body(a.model);
    models.body(b.model);
    candidates.push_back(number);
  }
  statistics_.candidates += candidates.size();
  allow_fronts(candidates);
  for_each(candidates.size(), 4, [&](std::size_t i, Scene_worker& worker) { ask_pair(candidates[i], worker); });
  for (const Number pair : candidates) {
    statistics_.queries += !near_[pair].is_open;
    near_.count_memory(pair);
  }
}

/// Says of pairs that are to be asked whether they may keep fronts: those that move little from frame to frame, while
/// there is room.
void Scene_data::allow_fronts(const std::vector<Number>& pairs)
{
  std::size_t taken = near_.memory_bytes(), room = most_bytes_of_fronts;
  if (options_.memory != 0)
    room = memory_has_fronts_
               ? kernel::minimum(room, options_.memory - kernel::minimum(options_.memory, bytes() - taken))
               : 0;
  for (const Number number : pairs) {
    Near_pair& pair = near_[number];
    const bool would_be_made = !pair.memory.front && pair.memory.is_front_worth(),
               is_allowed = (pair.memory.front || would_be_made) && moves_little(pair) &&
                            (!would_be_made || taken + bytes_of_front <= room);
    if (is_allowed && would_be_made) taken += bytes_of_front;
    pair.memory.allow_front(is_allowed);
  }
}

/// Of bodies that have been asked before: since then.
bool Scene_data::moves_little(const Near_pair& pair) const
{
  const double size = kernel::minimum(size_of(bodies_[pair.body[0]].box), size_of(bodies_[pair.body[1]].box));
  return way(pair) - pair.way <= little * size;
}

tetratree::Turned_box Scene_data::turned_box(Number body)
{
  return turned_[body].is_known ? turned_[body]
                                : tetratree::turned_box(models.extent(bodies_[body].model), bodies_[body].pose);
}

/// Leaves the pairs, of a long body at least, whose turned boxes are not found apart: up to eight pairs in a row of one
/// body at a time.
void Scene_data::ask_turned_boxes(std::vector<Number>& all)
{
  struct Row {
    std::size_t first, count;
    Number body;
  };
  std::vector<Row> rows;
  std::vector<Number> pairs;
  for (const Number pair : all)
    if (turned_[near_[pair].body[0]].is_known || turned_[near_[pair].body[1]].is_known) pairs.push_back(pair);
  for (std::size_t k = 0; k < pairs.size();) {
    const auto has = [&](std::size_t at, Number body) {
      const auto& bodies = near_[pairs[at]].body;
      return bodies[0] == body || bodies[1] == body;
    };
    Number body = near_[pairs[k]].body[0];
    if (k + 1 < pairs.size() && !has(k + 1, body)) body = near_[pairs[k]].body[1];
    Row row{k, 1, body};
    while (row.count < kernel::lanes && k + row.count < pairs.size() && has(k + row.count, body)) ++row.count;
    rows.push_back(row);
    k += row.count;
  }
  for_each(rows.size(), 64, [&](std::size_t i, Scene_worker&) {
    const Row& row = rows[i];
    std::array<tetratree::Turned_box, kernel::lanes> others;
    for (std::size_t k = 0; k < row.count; ++k) others[k] = turned_box(near_.other(pairs[row.first + k], row.body));
    const auto gaps = tetratree::turned_gaps(turned_box(row.body), std::span(others).first(row.count));
    for (std::size_t k = 0; k < row.count; ++k)
      if (gaps[k] > 0) answer(near_[pairs[row.first + k]], false, gaps[k]);
  });
  std::erase_if(all, [this](Number pair) { return !near_[pair].is_open; });
}

void Scene_data::ask_pair(Number number, Scene_worker& worker)
{
  if (deadline_ && std::chrono::steady_clock::now() >= *deadline_) return;
  Near_pair& pair = near_[number];
  const auto [model_a, model_b] = models_of(pair);
  const int first = bodies_[pair.body[0]].model == model_a ? 0 : 1;
  Query& query = worker.query(models, model_a, model_b, pair.by_brute_force ? Method::brute : Method::tree);
  const bool collide(query.collide(bodies_[pair.body[first]].pose, bodies_[pair.body[1 - first]].pose, pair.memory));
  answer(pair, collide, collide ? 0 : query.certified_gap());
}

/// Drops fronts, and gives back models, until the memory holds what is left.
void Scene_data::keep_to_memory(Number model_a, Number model_b)
{
  if (bytes() > options_.memory && near_.memory_bytes() > 0) {
    memory_has_fronts_ = false;
    for (Number body = 0; body < bodies_.size(); ++body) forget_pairs_of(body);
  }
  while (bytes() > options_.memory) {
    const auto least = models.least_recently_used(model_a, model_b);
    if (!least)
      throw Error("scene: a memory of " + std::to_string(options_.memory) + " bytes does not hold '" +
                  models.name(model_a) + "', '" + models.name(model_b) +
                  "' and what is asked of them; expected at least " + std::to_string(bytes()));
    for (Scene_worker& worker : workers_) worker.forget(*least);
    // A tree that is made anew has other numbers.
    for (Number body = 0; body < bodies_.size(); ++body)
      if (bodies_[body].model == *least) forget_pairs_of(body);
    models.give_back(*least);
  }
}

void Scene_data::forget_pairs_of(Number body)
{
  for (const auto& [pair, other] : near_.of(body)) near_.forget(pair);
}

void Scene_data::list_pairs()
{
  std::vector<Scene_pair> come;
  undecided_.clear();
  for (const Number number : open_) {
    Near_pair& pair = near_[number];
    const Scene_pair bodies = {pair.body[0], pair.body[1]};
    if (pair.is_open) undecided_.push_back({bodies, bodies_[bodies.a].box.farthest(bodies_[bodies.b].box)});
    const bool is_colliding = pair.collide && !pair.is_open;
    if (is_colliding && !pair.is_listed) come.push_back(bodies);
    if (!is_colliding && pair.is_listed) left_.push_back(bodies);
    pair.is_listed = is_colliding;
  }
  std::erase_if(open_, [this](Number pair) { return !near_[pair].is_open; });
  std::ranges::sort(undecided_, {}, &Undecided_pair::pair);
  if (come.empty() && left_.empty()) return;
  std::ranges::sort(come);
  std::ranges::sort(left_);
  std::vector<Scene_pair> stayed, all;
  std::ranges::set_difference(colliding_, left_, std::back_inserter(stayed));
  std::ranges::merge(stayed, come, std::back_inserter(all));
  colliding_ = std::move(all);
  left_.clear();
}

std::size_t Scene_data::bytes() const
{
  std::size_t all = models.bytes() + tree_.bytes() + near_.bytes() +
                    bodies_.capacity() * (sizeof(Placed_body) + sizeof(World_box) + sizeof(tetratree::Turned_box) +
                                          sizeof(double) + sizeof(Number)) +
                    colliding_.capacity() * sizeof(Scene_pair);
  for (const Scene_worker& worker : workers_) all += worker.bytes();
  return all;
}

}  // namespace tetracone::detail
