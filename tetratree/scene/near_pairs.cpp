#include "tetracone/tetratree/scene/near_pairs.h"

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/tetratree/memory/pair_certificate.h"
#include "tetracone/tetratree/scene/number_groups.h"

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
/// Distance of the prefetch of a body's list of near pairs, in bodies; its pairs are prefetched at half of it.
constexpr std::size_t lists_ahead = 8;

/// Bytes of fronts.
///
/// - `bytes_of_front`: estimate for a front before it is made.
/// - `most_bytes_of_fronts`: upper bound for all fronts.
constexpr std::size_t bytes_of_front = std::size_t(1) << 17, most_bytes_of_fronts = std::size_t(1) << 28;

std::uint64_t key_of(std::size_t a, std::size_t b)
{
  return std::uint64_t(kernel::minimum(a, b)) << 32 | kernel::maximum(a, b);
}

}  // namespace

void Near_pairs::ignore(Number a, Number b)
{
  ignored_.insert(key_of(a, b));
  for (const auto& near : near_.of(a))
    if (near.other == b) {
      remove(near.pair);
      break;
    }
}

bool Near_pairs::is_ignored(std::size_t a, std::size_t b) const
{
  return !ignored_.empty() && ignored_.contains(key_of(a, b));
}

void Near_pairs::set_body_count(std::size_t count)
{
  seen_.resize(count);
  near_.set_body_count(count);
}

/// Removes a pair that is no longer near.
void Near_pairs::remove(Number pair)
{
  if (near_.bodies(pair).is_listed) left_.push_back(pair_of(pair));
  near_.remove(pair);
}

void Near_pairs::remove_pairs_of(Number body)
{
  while (!near_.of(body).empty()) remove(near_.of(body).back().pair);
}

void Near_pairs::find(const std::vector<Number>& bodies)
{
  const auto found = bodies_.meeting(bodies);
  constexpr Number none = std::numeric_limits<Number>::max();
  std::vector<Number> group(bodies_.states.size(), none);
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
        remove(near.pair);
    }
    for (const Number other : others[i])
      if (seen_[other] == search && !is_ignored(body, other)) near_.add(body, other);
  }
}

void Near_pairs::ask(const Deadline& deadline, Frame_statistics& statistics)
{
  open_pairs(statistics);
  if (bodies_.options.memory != 0)
    std::ranges::sort(open_, {}, [this](Number pair) { return std::pair(models_of(pair), pair_of(pair)); });
  try {
    for_each_models(
        open_, [this](Number pair) { return models_of(pair); },
        [&](auto first, auto last) { ask_models(first, last, deadline, statistics); });
  } catch (...) {
    list_pairs();  // the next call would not look at pairs that are answered by now
    throw;
  }
  list_pairs();
}

/// Opens the near pairs of bodies that have moved, except those whose certificate still holds.
void Near_pairs::open_pairs(Frame_statistics& statistics)
{
  auto& states = bodies_.states;
  const std::vector<Number>& moved = bodies_.moved;
  std::erase_if(open_, [this](Number pair) { return !near_.bodies(pair).is_open(); });
  for (const Number number : moved)
    if (states[number].moved == Moved::lost)
      for (const auto& near : near_.of(number)) near_.bodies(near.pair).limit = -1;
  const auto look_at = [&](Number pair) {
    Near_bodies& bodies = near_.bodies(pair);
    if (are_apart(bodies)) {
      ++statistics.kept;
    } else if (!bodies.is_open()) {
      bodies.stage = tetratree::Pair_stage::open;
      open_.push_back(pair);
    }
  };
  if (2 * moved.size() > states.size()) {
    const bool all_have = moved.size() == bodies_.count_in_tree();
    const auto all = near_.all_bodies();
    for (Number pair = 0; pair < all.size(); ++pair) {
      const auto [a, b] = all[pair].body;
      if (a != b && (all_have || states[a].moved != Moved::no || states[b].moved != Moved::no)) look_at(pair);
    }
  } else {
    for (const Number body : moved)
      for (const auto& near : near_.of(body))
        if (body < near.other || states[near.other].moved == Moved::no) look_at(near.pair);
  }
  for (const Number body : moved) states[body].moved = Moved::no;
  bodies_.moved.clear();
}

/// Returns an upper bound of the rotation of both bodies, the sum of their `turned`.
double Near_pairs::turned(const Near_bodies& pair) const
{
  return sum_above(bodies_.places[pair.body[0]].turned, bodies_.places[pair.body[1]].turned);
}

/// Returns the square of the change of the vector between their centres, up to `error_of_between` and a few roundings.
double Near_pairs::square_between(const Near_bodies& pair, const tetratree::Between& before) const
{
  const auto &a = bodies_.places[pair.body[0]].at, &b = bodies_.places[pair.body[1]].at;
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double change = tetratree::change_between(a[k], b[k], double(before[k]));
    square += change * change;
  }
  return square;
}

/// True when the certificate proves that they are apart.
bool Near_pairs::are_apart(const Near_bodies& pair) const
{
  const double left = pair.limit - turned(pair);
  return left > tetratree::least_left &&
         square_between(pair, pair.between) < left * left * (1 - tetratree::certificate_rounding);
}

/// Returns a lower bound of their distance, by their boxes.
double Near_pairs::gap(const Near_bodies& pair) const
{
  const auto [a, b] = pair.body;
  return bodies_.boxes[a].gap(bodies_.places[a], bodies_.boxes[b], bodies_.places[b]);
}

/// Begins the certificate of a pair that is asked: records the vector between its bodies, and their rotation. Until
/// `answer` the limit is at most their rotation, so it proves nothing.
void Near_pairs::begin(Near_bodies& pair)
{
  const auto &a = bodies_.places[pair.body[0]], &b = bodies_.places[pair.body[1]];
  for (std::size_t k = 0; k < 3; ++k) pair.between[k] = float(a.at[k] - b.at[k]);
  pair.limit = sum_below(a.turned, b.turned);
}

/// Records the answer and completes the certificate. `gap` is a lower bound of their distance where they do not
/// collide. Requires `begin`. It reads nothing else of the bodies, which have left the caches since.
void Near_pairs::answer(Number number, bool collide, double gap)
{
  Near_bodies& pair = near_.bodies(number);
  pair.collide = collide;
  pair.stage = tetratree::Pair_stage::answered;
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

std::pair<Near_pairs::Number, Near_pairs::Number> Near_pairs::models_of(Number pair) const
{
  const auto [a, b] = near_.bodies(pair).body;
  return bodies_.models_of(a, b);
}

/// Asks open pairs: by their boxes, then by their models' queries.
void Near_pairs::ask_models(std::vector<Number>::iterator first, std::vector<Number>::iterator last,
                            const Deadline& deadline, Frame_statistics& statistics)
{
  std::vector<Number> meeting, with_old_boxes, candidates;
  for (auto at = first; at != last; ++at) {
    if (last - at > boxes_ahead)
      for (const Number body : near_.bodies(*(at + boxes_ahead)).body) bodies_.fetch_box(body);
    Near_bodies& pair = near_.bodies(*at);
    begin(pair);
    if (has_turned_box(pair))
      meeting.push_back(*at);
    else if (!are_apart_by_boxes(*at))
      (has_new_boxes(pair) ? meeting : with_old_boxes).push_back(*at);
  }
  find_boxes(with_old_boxes);
  for (const Number pair : with_old_boxes)
    if (!are_apart_by_boxes(pair)) meeting.push_back(pair);
  ask_turned_boxes(meeting);
  for (const Number pair : meeting)
    if (!are_apart_by_tight_boxes(pair)) candidates.push_back(pair);
  statistics.candidates += candidates.size();
  allow_fronts(candidates);
  bodies_.for_each(candidates.size(), 4, [&](std::size_t i, Scene_worker& worker) {
    if (i + asked_ahead < candidates.size())
      for (const Number body : near_.bodies(candidates[i + asked_ahead]).body) bodies_.fetch_pose(body);
    if (!deadline || std::chrono::steady_clock::now() < *deadline) ask_query(candidates[i], worker);
  });
  for (const Number pair : candidates) {
    statistics.queries += !near_.bodies(pair).is_open();
    near_.count_memory(pair);
  }
}

/// Answers the pair where its boxes prove that the bodies are apart.
bool Near_pairs::are_apart_by_boxes(Number pair)
{
  const double gap = this->gap(near_.bodies(pair));
  if (gap > 0) answer(pair, false, gap);
  return gap > 0;
}

/// Answers the pair where the boxes by the models' trees prove that the bodies are apart. Decides whether the query is
/// to test all pairs of faces, and makes the models that it needs.
bool Near_pairs::are_apart_by_tight_boxes(Number number)
{
  Near_bodies& pair = near_.bodies(number);
  pair.stage = tetratree::Pair_stage::open;
  const auto [a, b] = pair.body;
  const bool are_tight = bodies_.states[a].box == Found_by::tree && bodies_.states[b].box == Found_by::tree;
  if (bodies_.options.memory == 0 && are_tight) return false;
  Scene_models& models = bodies_.models;
  const Number model_a = bodies_.states[a].model, model_b = bodies_.states[b].model;
  if (models.is_worth_no_tree(model_a, model_b)) {
    pair.stage = tetratree::Pair_stage::open_for_brute_force;
  } else if (!are_tight) {
    bodies_.tighten(a);
    bodies_.tighten(b);
    if (are_apart_by_boxes(number)) return true;
  }
  models.body(model_a);
  models.body(model_b);
  return false;
}

/// True when boxes found anew would not help: they are new, or the bodies collided, and mostly still do.
bool Near_pairs::has_new_boxes(const Near_bodies& pair) const
{
  const auto [a, b] = pair.body;
  return pair.collide || (bodies_.boxes[a].is_new(bodies_.places[a]) && bodies_.boxes[b].is_new(bodies_.places[b]));
}

/// Finds the boxes of these pairs' bodies at their present poses.
void Near_pairs::find_boxes(const std::vector<Number>& pairs)
{
  std::vector<Number> bodies;
  for (const Number pair : pairs)
    for (const Number body : near_.bodies(pair).body)
      if (!bodies_.boxes[body].is_new(bodies_.places[body]) && !bodies_.states[body].is_out) {
        bodies_.states[body].is_out = true;  // marks it as listed, for this loop
        bodies.push_back(body);
      }
  for (const Number body : bodies) bodies_.states[body].is_out = false;
  bodies_.for_each(bodies.size(), 64, [&](std::size_t i, Scene_worker& worker) {
    if (i + asked_ahead < bodies.size()) bodies_.fetch_pose(bodies[i + asked_ahead]);
    bodies_.find_box(bodies[i], worker);
  });
}

/// Decides which of the pairs may keep fronts: those that move little from frame to frame, while there is room.
void Near_pairs::allow_fronts(const std::vector<Number>& pairs)
{
  const std::size_t memory_limit = bodies_.options.memory;
  std::size_t taken = near_.memory_bytes(), room = most_bytes_of_fronts;
  if (memory_limit != 0)
    room =
        memory_has_fronts_ ? kernel::minimum(room, memory_limit - kernel::minimum(memory_limit, bytes() - taken)) : 0;
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
bool Near_pairs::moves_little(const Near_bodies& pair, const tetratree::Asked_pair& asked) const
{
  const auto [a, b] = pair.body;
  return turned(pair) - asked.turned + std::sqrt(square_between(pair, asked.between)) <=
         little * kernel::minimum(bodies_.boxes[a].size(), bodies_.boxes[b].size());
}

bool Near_pairs::has_turned_box(const Near_bodies& pair) const
{
  return bodies_.states[pair.body[0]].is_turned || bodies_.states[pair.body[1]].is_turned;
}

/// Removes from `all` the pairs with a long body that turned boxes, or else boxes, find apart. It asks up to eight
/// pairs of one body at a time. Turned boxes come first: their gaps are mostly much larger.
void Near_pairs::ask_turned_boxes(std::vector<Number>& all)
{
  const auto has_long = [this](Number pair) { return has_turned_box(near_.bodies(pair)); };
  if (std::ranges::none_of(all, has_long)) return;
  const std::size_t count = bodies_.states.size();
  const tetratree::Number_groups pairs(count, [&](const auto& put) {
    for (const Number pair : all)
      if (has_long(pair)) put(near_.bodies(pair).body[0], pair);
  });
  struct Row {
    Number body;
    std::span<const Number> pairs;
  };
  std::vector<Row> rows;
  for (Number body = 0; body < count; ++body)
    for (auto left = pairs[body]; !left.empty();) {
      rows.push_back({body, left.first(kernel::minimum(left.size(), kernel::lanes))});
      left = left.subspan(rows.back().pairs.size());
    }
  bodies_.for_each(rows.size(), 64, [&](std::size_t i, Scene_worker&) {
    const Row& row = rows[i];
    if (i + rows_ahead < rows.size())
      for (const Number pair : rows[i + rows_ahead].pairs) bodies_.fetch_turned_box(near_.bodies(pair).body[1]);
    std::array<tetratree::Turned_box, kernel::lanes> others;
    for (std::size_t k = 0; k < row.pairs.size(); ++k)
      others[k] = bodies_.turned_box(near_.bodies(row.pairs[k]).body[1]);
    const auto gaps = tetratree::turned_gaps(bodies_.turned_box(row.body), std::span(others).first(row.pairs.size()));
    for (std::size_t k = 0; k < row.pairs.size(); ++k)
      if (const double gap = gaps[k] > 0 ? gaps[k] : this->gap(near_.bodies(row.pairs[k])); gap > 0)
        answer(row.pairs[k], false, gap);
  });
  std::erase_if(all, [this](Number pair) { return !near_.bodies(pair).is_open(); });
}

/// Answers the pair by the query of its models.
void Near_pairs::ask_query(Number number, Scene_worker& worker)
{
  const Near_bodies& pair = near_.bodies(number);
  const auto& body = pair.body;
  const auto [model_a, model_b] = models_of(number);
  const int first = bodies_.states[body[0]].model == model_a ? 0 : 1;
  const Method method = pair.stage == tetratree::Pair_stage::open_for_brute_force ? Method::brute : Method::tree;
  Query& query = worker.query(bodies_.models, model_a, model_b, method);
  const bool collide(
      query.collide(bodies_.poses[body[first]], bodies_.poses[body[1 - first]], near_.known_asked(number)->memory));
  answer(number, collide, collide ? 0 : query.certified_gap());
}

/// Drops fronts, then gives back models, until the memory suffices.
void Near_pairs::keep_to_memory(Number model_a, Number model_b)
{
  const std::size_t memory_limit = bodies_.options.memory;
  Scene_models& models = bodies_.models;
  if (bytes() > memory_limit && near_.memory_bytes() > 0) {
    memory_has_fronts_ = false;
    for (Number body = 0; body < bodies_.states.size(); ++body) forget_pairs_of(body);
  }
  while (bytes() > memory_limit) {
    const auto least = models.least_recently_used(model_a, model_b);
    if (!least)
      throw Error("scene: a memory of " + std::to_string(memory_limit) + " bytes does not hold '" +
                  models.name(model_a) + "', '" + models.name(model_b) +
                  "' and what is asked of them; expected at least " + std::to_string(bytes()));
    for (Scene_worker& worker : bodies_.workers) worker.forget(*least);
    // A tree that is made anew numbers its nodes otherwise.
    for (Number body = 0; body < bodies_.states.size(); ++body)
      if (bodies_.states[body].model == *least) forget_pairs_of(body);
    models.give_back(*least);
  }
}

void Near_pairs::forget_pairs_of(Number body)
{
  for (const auto& near : near_.of(body)) near_.forget(near.pair);
}

void Near_pairs::list_pairs()
{
  std::vector<Scene_pair> come;
  undecided_.clear();
  std::erase_if(open_, [&](Number number) {
    Near_bodies& pair = near_.bodies(number);
    const Scene_pair bodies = pair_of(number);
    if (pair.is_open())
      undecided_.push_back({bodies, bodies_.boxes[bodies.a]
                                        .at(bodies_.places[bodies.a])
                                        .farthest(bodies_.boxes[bodies.b].at(bodies_.places[bodies.b]))});
    const bool is_colliding = pair.collide && !pair.is_open();
    if (is_colliding && !pair.is_listed) come.push_back(bodies);
    if (!is_colliding && pair.is_listed) left_.push_back(bodies);
    pair.is_listed = is_colliding;
    return !pair.is_open();
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

std::size_t Near_pairs::bytes() const
{
  return bodies_.bytes() + near_.bytes() + seen_.capacity() * sizeof(seen_[0]) +
         colliding_.capacity() * sizeof(Scene_pair);
}

}  // namespace tetracone::detail
