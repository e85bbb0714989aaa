// The near pairs of a scene: which a frame asks, and how.

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/scene/scene_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <utility>

namespace tetracone::detail {
namespace {

/// A sum of what is not negative, rounded up or down.
double sum_above(double x, double y) { return y == 0 ? x : std::nextafter(x + y, std::numeric_limits<double>::max()); }
double sum_below(double x, double y) { return y == 0 ? x : std::nextafter(x + y, 0.0); }

/// Bodies that have moved by more than this share of the smaller one since they were asked get no front.
constexpr double little = 1.0 / 64;

/// What a front may take before it is made, and all of them.
constexpr std::size_t bytes_of_front = std::size_t(1) << 17, most_bytes_of_fronts = std::size_t(1) << 28;

}  // namespace

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
  const double size = kernel::minimum(bodies_[pair.body[0]].box.size(), bodies_[pair.body[1]].box.size());
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
