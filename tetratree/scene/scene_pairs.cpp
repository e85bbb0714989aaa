// The near pairs of a scene: which a frame asks, and how.

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/scene/number_groups.h"
#include "tetracone/tetratree/scene/scene_data.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <utility>

namespace tetracone::detail {
namespace {

/// At least, and at most, a sum of what is not negative: it is rounded once, and the product again. Of denormals, sums
/// are exact.
double sum_above(double x, double y) { return (x + y) * (1 + 0x1p-51); }
double sum_below(double x, double y) { return (x + y) * (1 - 0x1p-51); }

/// Bodies that have moved by more than this share of the smaller one since they were asked get no front.
constexpr double little = 1.0 / 64;

/// So many pairs before one is asked, the memory is told to bring its poses.
constexpr std::size_t asked_ahead = 2;

/// What a front may take before it is made, and all of them.
constexpr std::size_t bytes_of_front = std::size_t(1) << 17, most_bytes_of_fronts = std::size_t(1) << 28;

}  // namespace

/// Opens the near pairs of bodies that have moved, but for those that are still apart.
void Scene_data::open_pairs()
{
  std::erase_if(open_, [this](Number pair) { return !near_[pair].is_open; });
  for (const Number number : moved_) {
    bodies_[number].has_moved = false;
    if (steps_[number] <= std::numeric_limits<double>::max())
      ways_[number].sum = sum_above(ways_[number].sum, steps_[number]);
    else
      for (const auto& near : near_.of(number)) near_.bodies(near.pair).limit = -1;
  }
  const auto has_moved = [this](Number body) { return ways_[body].moved == frame_; };
  const auto look_at = [this](Number pair) {
    if (way(pair) < near_.bodies(pair).limit)
      ++statistics_.kept;
    else if (!near_[pair].is_open)
      open_pair(pair);
  };
  if (2 * moved_.size() > bodies_.size()) {
    const auto all = near_.all_bodies();
    for (Number pair = 0; pair < all.size(); ++pair) {
      const auto [a, b] = all[pair].body;
      if (a != b && (has_moved(a) || has_moved(b))) look_at(pair);
    }
  } else {
    for (const Number body : moved_)
      for (const auto& near : near_.of(body))
        if (body < near.other || !has_moved(near.other)) look_at(near.pair);
  }
  moved_.clear();
}

void Scene_data::open_pair(Number number)
{
  near_[number].is_open = true;
  open_.push_back(number);
}

/// A bound on the motions of both bodies, from above.
double Scene_data::way(Number pair) const
{
  const auto [a, b] = near_.bodies(pair).body;
  return sum_above(ways_[a].sum, ways_[b].sum);
}

/// Where they do not collide, they are at least `gap` apart.
void Scene_data::answer(Number number, bool collide, double gap)
{
  Near_pair& pair = near_[number];
  pair.collide = collide;
  pair.is_open = false;
  if (tetratree::Asked_pair* const asked = near_.known_asked(number)) asked->way = way(number);
  auto& [body, limit] = near_.bodies(number);
  limit = gap > 0 ? sum_below(sum_below(ways_[body[0]].sum, ways_[body[1]].sum), gap) : -1;
}

/// By the tree, which is made now if it has to be.
void Scene_data::tighten(Number number)
{
  Placed_body& body = bodies_[number];
  if (body.is_tight) return;
  data_of(models.body(body.model)).bvh8();
  boxes_[number] = workers_[0].box(body.model, models.extent(body.model), poses_[number]);
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
      return std::pair(models_of(pair_of(p)), pair_of(p)) < std::pair(models_of(pair_of(q)), pair_of(q));
    });
  for_each_models(
      open_, [this](Number pair) { return models_of(pair_of(pair)); },
      [this](auto first, auto last) { ask_models(first, last); });
}

/// Asks open pairs: their boxes, then their models.
void Scene_data::ask_models(std::vector<Number>::iterator first, std::vector<Number>::iterator last)
{
  std::vector<Number> meeting, candidates;
  for (auto at = first; at != last; ++at) {
    const auto [a, b] = near_.bodies(*at).body;
    const double gap = boxes_[a].gap(boxes_[b]);
    if (gap > 0)
      answer(*at, false, gap);
    else
      meeting.push_back(*at);
  }
  ask_turned_boxes(meeting);
  for (const Number number : meeting) {
    Near_pair& pair = near_[number];
    const auto [a, b] = near_.bodies(number).body;
    const Number model_a = bodies_[a].model, model_b = bodies_[b].model;
    pair.by_brute_force = models.is_worth_no_tree(model_a, model_b);
    if (!pair.by_brute_force && !(bodies_[a].is_tight && bodies_[b].is_tight)) {
      tighten(a);
      tighten(b);
      const double gap = boxes_[a].gap(boxes_[b]);
      if (gap > 0) {
        answer(number, false, gap);
        continue;
      }
    }
    models.body(model_a);
    models.body(model_b);
    candidates.push_back(number);
  }
  statistics_.candidates += candidates.size();
  allow_fronts(candidates);
  for_each(candidates.size(), 4, [&](std::size_t i, Scene_worker& worker) {
    if (i + asked_ahead < candidates.size()) fetch_poses(candidates[i + asked_ahead]);
    ask_pair(candidates[i], worker);
  });
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
    tetratree::Asked_pair& asked = near_.asked(number);
    tetratree::Pair_memory& memory = asked.memory;
    const bool would_be_made = !memory.front && memory.is_front_worth(),
               is_allowed = (memory.front || would_be_made) && moves_little(number, asked.way) &&
                            (!would_be_made || taken + bytes_of_front <= room);
    if (is_allowed && would_be_made) taken += bytes_of_front;
    memory.allow_front(is_allowed);
  }
}

/// Since the bodies' way was `since`.
bool Scene_data::moves_little(Number pair, double since) const
{
  const auto [a, b] = near_.bodies(pair).body;
  return way(pair) - since <= little * kernel::minimum(boxes_[a].size(), boxes_[b].size());
}

tetratree::Turned_box Scene_data::turned_box(Number body)
{
  return bodies_[body].is_turned ? turned_[body]
                                 : tetratree::turned_box(models.extent(bodies_[body].model), poses_[body]);
}

/// Leaves the pairs, of a long body at least, whose turned boxes are not found apart: up to eight pairs of one body at a
/// time.
void Scene_data::ask_turned_boxes(std::vector<Number>& all)
{
  const auto has_long = [this](Number pair) {
    const auto [a, b] = near_.bodies(pair).body;
    return bodies_[a].is_turned || bodies_[b].is_turned;
  };
  if (std::ranges::none_of(all, has_long)) return;
  const tetratree::Number_groups pairs(bodies_.size(), [&](const auto& put) {
    for (const Number pair : all)
      if (has_long(pair)) put(near_.bodies(pair).body[0], pair);
  });
  struct Row {
    Number body;
    std::span<const Number> pairs;
  };
  std::vector<Row> rows;
  for (Number body = 0; body < bodies_.size(); ++body)
    for (auto left = pairs[body]; !left.empty();) {
      rows.push_back({body, left.first(kernel::minimum(left.size(), kernel::lanes))});
      left = left.subspan(rows.back().pairs.size());
    }
  for_each(rows.size(), 64, [&](std::size_t i, Scene_worker&) {
    const Row& row = rows[i];
    std::array<tetratree::Turned_box, kernel::lanes> others;
    for (std::size_t k = 0; k < row.pairs.size(); ++k) others[k] = turned_box(near_.bodies(row.pairs[k]).body[1]);
    const auto gaps = tetratree::turned_gaps(turned_box(row.body), std::span(others).first(row.pairs.size()));
    for (std::size_t k = 0; k < row.pairs.size(); ++k)
      if (gaps[k] > 0) answer(row.pairs[k], false, gaps[k]);
  });
  std::erase_if(all, [this](Number pair) { return !near_[pair].is_open; });
}

void Scene_data::fetch_poses(Number pair) const
{
  for (const Number body : near_.bodies(pair).body) {
    const double* const entries = poses_[body].entries().data();
    __builtin_prefetch(entries);
    __builtin_prefetch(entries + 8);
    __builtin_prefetch(entries + 14);
  }
}

void Scene_data::ask_pair(Number number, Scene_worker& worker)
{
  if (deadline_ && std::chrono::steady_clock::now() >= *deadline_) return;
  Near_pair& pair = near_[number];
  const auto& body = near_.bodies(number).body;
  const auto [model_a, model_b] = models_of(body[0], body[1]);
  const int first = bodies_[body[0]].model == model_a ? 0 : 1;
  Query& query = worker.query(models, model_a, model_b, pair.by_brute_force ? Method::brute : Method::tree);
  const bool collide(query.collide(poses_[body[first]], poses_[body[1 - first]], near_.known_asked(number)->memory));
  answer(number, collide, collide ? 0 : query.certified_gap());
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
  for (const auto& near : near_.of(body)) near_.forget(near.pair);
}

void Scene_data::list_pairs()
{
  std::vector<Scene_pair> come;
  undecided_.clear();
  for (const Number number : open_) {
    Near_pair& pair = near_[number];
    const Scene_pair bodies = pair_of(number);
    if (pair.is_open) undecided_.push_back({bodies, boxes_[bodies.a].farthest(boxes_[bodies.b])});
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
                    bodies_.capacity() * (sizeof(Placed_body) + 2 * sizeof(kernel::Pose) + sizeof(double) +
                                          2 * sizeof(World_box) + sizeof(Way) + sizeof(std::uint64_t)) +
                    turned_.capacity() * sizeof(tetratree::Turned_box) + colliding_.capacity() * sizeof(Scene_pair);
  for (const Scene_worker& worker : workers_) all += worker.bytes();
  return all;
}

}  // namespace tetracone::detail
