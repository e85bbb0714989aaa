#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/scene/scene_data.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tetracone::detail {

std::vector<Scene_distance> Scene_data::pairs_within(const std::string& limit)
{
  kernel::require_exact_arithmetic();
  kernel::require_sound_floating_point();
  const kernel::Rational number = kernel::required_number(limit, "scene: limit ");
  std::vector<Number> bodies;
  for (Number body = 0; body < bodies_.states.size(); ++body)
    if (bodies_.states[body].is_placed()) bodies.push_back(body);
  if (bodies.empty() && std::ranges::any_of(bodies_.states, &Placed_body::is_there))
    throw Error("scene: no body has a pose; expected a body that is placed before pairs are asked for");
  const std::size_t nodes = models().nodes_made();
  statistics_ = {};
  if (sgn(number) < 0) return {};

  // Bodies at most so far apart have boxes that meet once either has grown by half of it.
  const double half = std::nextafter(kernel::nearest_double(number), HUGE_VAL) / 2;
  for (const Number body : bodies)
    models().extent(bodies_.states[body].model);  // makes the models here, since one thread must throw
  std::vector<tetratree::World_box> reached(bodies_.states.size());
  bodies_.for_each(bodies.size(), 16, [&](std::size_t i, Scene_worker& worker) {
    const Number body = bodies[i], model = bodies_.states[body].model;
    reached[body] = worker.box(model, models().extent(model), bodies_.poses[body]).reached(half);
  });
  const auto of_pair = [this](const Scene_pair& pair) { return bodies_.models_of(pair.a, pair.b); };
  std::vector<Scene_pair> pairs = pairs_of_boxes(reached, bodies);
  std::ranges::sort(pairs, {}, [&](const Scene_pair& pair) { return std::pair(of_pair(pair), pair); });
  std::vector<Scene_distance> near;
  near_.for_each_models(pairs, of_pair, [&](auto first, auto last) {
    for (auto at = first; at != last; ++at)
      for (const std::size_t body : {at->a, at->b}) models().body(bodies_.states[body].model);  // one thread makes them
    std::vector<std::optional<double>> found(std::size_t(last - first));
    bodies_.for_each(found.size(), 1, [&](std::size_t i, Scene_worker& worker) {
      const Scene_pair& pair = *(first + std::ptrdiff_t(i));
      const auto [model_a, model_b] = bodies_.models_of(pair.a, pair.b);
      const bool is_turned = bodies_.states[pair.a].model != model_a;
      const kernel::Pose &a = bodies_.poses[is_turned ? pair.b : pair.a],
                         &b = bodies_.poses[is_turned ? pair.a : pair.b];
      Query& query = worker.query(models(), model_a, model_b);
      if (query.within(a, b, limit)) found[i] = query.distance(a, b);
    });
    for (const auto& distance : found) {
      if (distance) near.push_back({*first, *distance});
      ++first;
    }
  });
  std::ranges::sort(near, {}, &Scene_distance::pair);
  statistics_.candidates = statistics_.queries = pairs.size();
  statistics_.nodes_made = models().nodes_made() - nodes;
  statistics_.bytes = near_.bytes();
  return near;
}

}  // namespace tetracone::detail
