// The near pairs of a scene: which of them a frame asks, and how.

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/scene/number_groups.h"
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

using tetratree::sum_above, tetratree::sum_below;

/// A pair gets no front if its bodies have moved by more than this fraction of the smaller one since it was asked.
constexpr double little = 1.0 / 64;

/// Distance of the prefetch of poses, in pairs or bodies.
constexpr std::size_t asked_ahead = 4;
/// Distance of the prefetch of boxes, in pairs.
constexpr std::ptrdiff_t boxes_ahead = 12;
/// Distance of the prefetch of turned boxes, in rows of up to eight pairs.
constexpr std::size_t rows_ahead = 2;

/// Bytes of fronts.
///
/// - `bytes_of_front`: estimate for a front before it is made.
/// - `most_bytes_of_fronts`: upper bound for all fronts.
constexpr std::size_t bytes_of_front = std::size_t(1) << 17, most_bytes_of_fronts = std::size_t(1) << 28;

}  // namespace

/// Opens the near pairs of bodies that have moved, except those whose certificate still holds.
void Scene_data::open_pairs()
{
  std::erase_if(open_, [this](Number pair) { return !near_.bodies(pair).is_open; });
  for (const Number number : moved_) {
    if (!bodies_[number].is_lost) continue;
    for (const auto& near : near_.of(number)) near_.bodies(near.pair).limit = -1;
    bodies_[number].is_lost = false;
  }
  const auto look_at = [this](Number pair) {
    const Near_bodies& bodies = near_.bodies(pair);
    if (are_apart(bodies))
      ++statistics_.kept;
    else if (!bodies.is_open)
      open_pair(pair);
  };
  if (2 * moved_.size() > bodies_.size()) {
    const bool all_have = moved_.size() == tree_.count();
    const auto all = near_.all_bodies();
    for (Number pair = 0; pair < all.size(); ++pair) {
      const auto [a, b] = all[pair].body;
      if (a != b && (all_have || bodies_[a].has_moved || bodies_[b].has_moved)) look_at(pair);
    }
  } else {
    for (const Number body : moved_)
      for (const auto& near : near_.of(body))
        if (body < near.other || !bodies_[near.other].has_moved) look_at(near.pair);
  }
  for (const Number body : moved_) bodies_[body].has_moved = false;
  moved_.clear();
}

void Scene_data::open_pair(Number number)
{
  near_.bodies(number).is_open = true;
  open_.push_back(number);
}

/// Returns an upper bound of the rotation of both bodies, the sum of their `turned`.
double Scene_data::turned(const Near_bodies& pair) const
{
  return sum_above(places_[pair.body[0]].turned, places_[pair.body[1]].turned);
}

/// Returns the square of the change of the vector between their centres, up to `error_of_between` and a few roundings.
double Scene_data::square_between(const Near_bodies& pair, const tetratree::Between& before) const
{
  const auto &a = places_[pair.body[0]].at, &b = places_[pair.body[1]].at;
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double change = tetratree::change_between(a[k], b[k], double(before[k]));
    square += change * change;
  }
  return square;
}

/// True when the certificate proves that they are apart.
bool Scene_data::are_apart(const Near_bodies& pair) const
{
  const double left = pair.limit - turned(pair);
  return left > tetratree::least_left &&
         square_between(pair, pair.between) < left * left * (1 - tetratree::certificate_rounding);
}

/// Returns a lower bound of their distance, by their boxes.
double Scene_data::gap(const Near_bodies& pair) const
{
  const auto [a, b] = pair.body;
  return boxes_[a].gap(places_[a], boxes_[b], places_[b]);
}

/// Begins the certificate of a pair that is asked: records the vector between its bodies, and their rotation. Until
/// `answer` the limit is at most their rotation, so it proves nothing.
void Scene_data::begin(Near_bodies& pair)
{
  const auto &a = places_[pair.body[0]], &b = places_[pair.body[1]];
  for (std::size_t k = 0; k < 3; ++k) pair.between[k] = float(a.at[k] - b.at[k]);
  pair.limit = sum_below(a.turned, b.turned);
}

/// Records the answer and completes the certificate. `gap` is a lower bound of their distance where they do not
/// collide. Requires `begin`. It reads nothing else of the bodies, which have left the caches since.
void Scene_data::answer(Number number, bool collide, double gap)
{
  Near_bodies& pair = near_.bodies(number);
  pair.collide = collide;
  pair.is_open = false;
  if (tetratree::Asked_pair* const asked = near_.known_asked(number)) {
    asked->turned = pair.limit;
    asked->between = pair.between;
  }
  const tetratree::Between& between = pair.between;
  const double error = tetratree::error_of_between(
      std::array{std::abs(double(between[0])), std::abs(double(between[1])), std::abs(double(between[2]))});
  const double known = gap > tetratree::most_gap ? tetratree::most_gap : gap;
  pair.limit = known > error ? sum_below(pair.limit, known - error) : -1;
}

/// Finds the body's box by the tree of its model, which is made now if need be.
void Scene_data::tighten(Number number)
{
  Placed_body& body = bodies_[number];
  if (body.is_tight) return;
  data_of(models.body(body.model)).bvh8();
  find_box(number, workers_[0]);
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

/// Asks open pairs, by their boxes first, then by their models.
void Scene_data::ask_models(std::vector<Number>::iterator first, std::vector<Number>::iterator last)
{
  std::vector<Number> meeting, with_old_boxes, candidates;
  const auto ask_box = [&](Number pair) {
    const double gap = this->gap(near_.bodies(pair));
    if (gap > 0) answer(pair, false, gap);
    return gap > 0;
  };
  for (auto at = first; at != last; ++at) {
    if (last - at > boxes_ahead) fetch_boxes(near_.bodies(*(at + boxes_ahead)));
    begin(near_.bodies(*at));
    if (has_turned_box(near_.bodies(*at)))
      meeting.push_back(*at);
    else if (!ask_box(*at))
      (has_new_boxes(near_.bodies(*at)) ? meeting : with_old_boxes).push_back(*at);
  }
  find_boxes(with_old_boxes);
  for (const Number pair : with_old_boxes)
    if (!ask_box(pair)) meeting.push_back(pair);
  ask_turned_boxes(meeting);
  for (const Number number : meeting) {
    Near_bodies& pair = near_.bodies(number);
    const auto [a, b] = pair.body;
    const Number model_a = bodies_[a].model, model_b = bodies_[b].model;
    if (options_.memory == 0 && bodies_[a].is_tight && bodies_[b].is_tight) {
      pair.by_brute_force = false;
      candidates.push_back(number);
      continue;
    }
    pair.by_brute_force = models.is_worth_no_tree(model_a, model_b);
    if (!pair.by_brute_force && !(bodies_[a].is_tight && bodies_[b].is_tight)) {
      tighten(a);
      tighten(b);
      if (ask_box(number)) continue;
    }
    models.body(model_a);
    models.body(model_b);
    candidates.push_back(number);
  }
  statistics_.candidates += candidates.size();
  allow_fronts(candidates);
  for_each(candidates.size(), 4, [&](std::size_t i, Scene_worker& worker) {
    if (i + asked_ahead < candidates.size())
      for (const Number body : near_.bodies(candidates[i + asked_ahead]).body) fetch_pose(body);
    ask_pair(candidates[i], worker);
  });
  for (const Number pair : candidates) {
    statistics_.queries += !near_.bodies(pair).is_open;
    near_.count_memory(pair);
  }
}

/// True when boxes found anew would not help: they are new, or the bodies collided, and mostly still do.
bool Scene_data::has_new_boxes(const Near_bodies& pair) const
{
  const auto [a, b] = pair.body;
  return pair.collide || (boxes_[a].is_new(places_[a]) && boxes_[b].is_new(places_[b]));
}

/// Finds the boxes of these pairs' bodies at their present poses.
void Scene_data::find_boxes(const std::vector<Number>& pairs)
{
  std::vector<Number> bodies;
  for (const Number pair : pairs)
    for (const Number body : near_.bodies(pair).body)
      if (!boxes_[body].is_new(places_[body]) && !bodies_[body].is_out) {
        bodies_[body].is_out = true;  // marks it as listed, until the end
        bodies.push_back(body);
      }
  for_each(bodies.size(), 64, [&](std::size_t i, Scene_worker& worker) {
    if (i + asked_ahead < bodies.size()) fetch_pose(bodies[i + asked_ahead]);
    find_box(bodies[i], worker);
  });
  for (const Number body : bodies) bodies_[body].is_out = false;
}

/// Decides which of the pairs may keep fronts: those that move little from frame to frame, while there is room.
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
               is_allowed = (memory.front || would_be_made) && moves_little(near_.bodies(number), asked) &&
                            (!would_be_made || taken + bytes_of_front <= room);
    if (is_allowed && would_be_made) taken += bytes_of_front;
    memory.allow_front(is_allowed);
  }
}

/// True when both bodies have moved little since the trees of the pair were asked.
bool Scene_data::moves_little(const Near_bodies& pair, const tetratree::Asked_pair& asked) const
{
  const auto [a, b] = pair.body;
  return turned(pair) - asked.turned + std::sqrt(square_between(pair, asked.between)) <=
         little * kernel::minimum(boxes_[a].size(), boxes_[b].size());
}

tetratree::Turned_box Scene_data::turned_box(Number body)
{
  return bodies_[body].is_turned ? turned_[body]
                                 : tetratree::turned_box(models.extent(bodies_[body].model), poses_[body]);
}

bool Scene_data::has_turned_box(const Near_bodies& pair) const
{
  return bodies_[pair.body[0]].is_turned || bodies_[pair.body[1]].is_turned;
}

/// Removes from `all` the pairs with a long body that turned boxes, or else boxes, find apart. It asks up to eight
/// pairs of one body at a time. Turned boxes come first: their gaps are mostly much larger.
void Scene_data::ask_turned_boxes(std::vector<Number>& all)
{
  const auto has_long = [this](Number pair) { return has_turned_box(near_.bodies(pair)); };
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
    if (i + rows_ahead < rows.size())
      for (const Number pair : rows[i + rows_ahead].pairs) {
        const auto* const box = reinterpret_cast<const char*>(&turned_[near_.bodies(pair).body[1]]);
        __builtin_prefetch(box);
        __builtin_prefetch(box + 64);
      }
    std::array<tetratree::Turned_box, kernel::lanes> others;
    for (std::size_t k = 0; k < row.pairs.size(); ++k) others[k] = turned_box(near_.bodies(row.pairs[k]).body[1]);
    const auto gaps = tetratree::turned_gaps(turned_box(row.body), std::span(others).first(row.pairs.size()));
    for (std::size_t k = 0; k < row.pairs.size(); ++k)
      if (const double gap = gaps[k] > 0 ? gaps[k] : this->gap(near_.bodies(row.pairs[k])); gap > 0)
        answer(row.pairs[k], false, gap);
  });
  std::erase_if(all, [this](Number pair) { return !near_.bodies(pair).is_open; });
}

void Scene_data::fetch_boxes(const Near_bodies& pair) const
{
  for (const Number body : pair.body) {
    __builtin_prefetch(&boxes_[body]);
    __builtin_prefetch(&places_[body]);
  }
}

void Scene_data::fetch_pose(Number body) const
{
  const double* const entries = poses_[body].entries().data();
  __builtin_prefetch(entries);
  __builtin_prefetch(entries + 8);
  __builtin_prefetch(entries + 14);
}

void Scene_data::ask_pair(Number number, Scene_worker& worker)
{
  if (deadline_ && std::chrono::steady_clock::now() >= *deadline_) return;
  const Near_bodies& pair = near_.bodies(number);
  const auto& body = pair.body;
  const auto [model_a, model_b] = models_of(body[0], body[1]);
  const int first = bodies_[body[0]].model == model_a ? 0 : 1;
  Query& query = worker.query(models, model_a, model_b, pair.by_brute_force ? Method::brute : Method::tree);
  const bool collide(query.collide(poses_[body[first]], poses_[body[1 - first]], near_.known_asked(number)->memory));
  answer(number, collide, collide ? 0 : query.certified_gap());
}

/// Drops fronts, then gives back models, until the memory suffices.
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
    // A tree that is made anew numbers its nodes otherwise.
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
  std::erase_if(open_, [&](Number number) {
    Near_bodies& pair = near_.bodies(number);
    const Scene_pair bodies = pair_of(number);
    if (pair.is_open)
      undecided_.push_back(
          {bodies, boxes_[bodies.a].at(places_[bodies.a]).farthest(boxes_[bodies.b].at(places_[bodies.b]))});
    const bool is_colliding = pair.collide && !pair.is_open;
    if (is_colliding && !pair.is_listed) come.push_back(bodies);
    if (!is_colliding && pair.is_listed) left_.push_back(bodies);
    pair.is_listed = is_colliding;
    return !pair.is_open;
  });
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
  std::size_t all =
      models.bytes() + tree_.bytes() + near_.bytes() +
      bodies_.capacity() * (sizeof(Placed_body) + sizeof(kernel::Pose) + sizeof(tetratree::Body_place) + sizeof(Step) +
                            sizeof(tetratree::Body_box) + sizeof(World_box) + sizeof(std::uint64_t)) +
      turned_.capacity() * sizeof(tetratree::Turned_box) + colliding_.capacity() * sizeof(Scene_pair);
  for (const Scene_worker& worker : workers_) all += worker.bytes();
  return all;
}

}  // namespace tetracone::detail
