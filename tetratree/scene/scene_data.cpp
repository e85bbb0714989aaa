#include "tetracone/tetratree/scene/scene_data.h"

#include "tetracone/kernel/number/floating_point.h"

#include <algorithm>
#include <string>

namespace tetracone::detail {

std::size_t Scene_data::add_body(std::size_t model)
{
  const std::size_t body = bodies_.add(model);
  near_.set_body_count(body + 1);
  return body;
}

void Scene_data::remove_body(std::size_t body)
{
  bodies_.there(body);
  near_.remove_pairs_of(Number(body));
  bodies_.remove(Number(body));
}

void Scene_data::set_model(std::size_t body, std::size_t model)
{
  const Placed_body& changed = bodies_.there(body);
  bodies_.require_model(model);
  if (changed.model == model) return;
  near_.remove_pairs_of(Number(body));
  bodies_.set_model(Number(body), Number(model));
}

void Scene_data::ignore(std::size_t a, std::size_t b)
{
  bodies_.there(a);
  bodies_.there(b);
  if (a == b) throw Error("scene: body " + std::to_string(a) + " with itself; expected two bodies to ignore");
  near_.ignore(Number(a), Number(b));
}

std::vector<std::size_t> Scene_data::present(std::size_t count, const std::string& what) const
{
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < bodies_.states.size(); ++k)
    if (bodies_.states[k].is_there()) numbers.push_back(k);
  if (numbers.size() != count)
    throw Error("scene: " + std::to_string(count) + " " + what + " of " + std::to_string(numbers.size()) +
                " bodies; expected one a body");
  return numbers;
}

const std::vector<Scene_pair>& Scene_data::pairs()
{
  // An empty answer would be wrong for bodies without poses.
  if (std::ranges::any_of(bodies_.states, &Placed_body::is_there) &&
      std::ranges::none_of(bodies_.states, &Placed_body::is_placed))
    throw Error("scene: no body has a pose; expected a body that is placed before pairs are asked for");
  kernel::require_exact_arithmetic();
  kernel::require_sound_floating_point();
  Near_pairs::Deadline deadline;
  const auto budget = bodies_.options.budget;
  const auto now = std::chrono::steady_clock::now();
  // A budget beyond the clock's end is none.
  if (budget.count() > 0 && budget < std::chrono::steady_clock::time_point::max() - now) deadline = now + budget;
  const std::size_t nodes = models().nodes_made();
  statistics_ = {};
  const std::vector<Number> widened = bodies_.update_boxes();
  statistics_.moved = bodies_.moved.size();
  if (!widened.empty()) near_.find(widened);
  near_.ask(deadline, statistics_);
  statistics_.nodes_made = models().nodes_made() - nodes;
  statistics_.bytes = near_.bytes();
  return near_.colliding();
}

}  // namespace tetracone::detail
