#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/tetratree/door/motion_solver.h"
#include "tetracone/tetratree/scene/scene_data.h"
#include "tetracone/tetratree/scene/swept_box.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace tetracone::detail {

std::vector<Scene_contact> Scene_data::first_contacts(std::span<const Motion> motions)
{
  kernel::require_exact_arithmetic();
  kernel::require_sound_floating_point();
  require_motion_kernel(bodies_.options.query);
  const std::vector<std::size_t> bodies = present(motions.size(), "motions");
  Motions motion_of(bodies_.states.size());
  for (std::size_t k = 0; k < bodies.size(); ++k) motion_of[bodies[k]] = &motions[k];
  const std::size_t nodes = models().nodes_made();
  statistics_ = {};

  const auto of_pair = [this](const Scene_pair& pair) { return bodies_.models_of(pair.a, pair.b); };
  std::vector<Scene_pair> pairs = meeting_pairs(motion_of);
  std::ranges::sort(pairs, {}, [&](const Scene_pair& pair) { return std::pair(of_pair(pair), pair); });
  std::vector<Scene_contact> contacts;
  near_.for_each_models(pairs, of_pair, [&](auto first, auto last) {
    for (auto at = first; at != last; ++at)
      for (const std::size_t body : {at->a, at->b}) models().body_of_triangles(bodies_.states[body].model);
    std::vector<std::optional<First_contact>> found(std::size_t(last - first));
    bodies_.for_each(found.size(), 1, [&](std::size_t i, Scene_worker& worker) {
      found[i] = first_contact(*(first + std::ptrdiff_t(i)), motion_of, worker);
    });
    for (const auto& contact : found) {
      if (contact) contacts.push_back({*first, *contact});
      ++first;
    }
  });
  std::ranges::sort(contacts, {}, [](const Scene_contact& contact) {
    return std::tuple(contact.first.lo, contact.first.hi, contact.pair);
  });
  statistics_.candidates = statistics_.queries = pairs.size();
  statistics_.nodes_made = models().nodes_made() - nodes;
  statistics_.bytes = near_.bytes();
  return contacts;
}

/// Returns the pairs whose swept boxes meet, except the ignored ones.
std::vector<Scene_pair> Scene_data::meeting_pairs(const Motions& motion_of)
{
  std::vector<Number> moving;
  for (Number body = 0; body < motion_of.size(); ++body)
    if (motion_of[body]) moving.push_back(body);
  for (const Number body : moving)
    models().extent(bodies_.states[body].model);  // makes the models here, since one thread must throw
  std::vector<tetratree::World_box> swept(motion_of.size());
  bodies_.for_each(moving.size(), 16, [&](std::size_t i, Scene_worker& worker) {
    const Number model = bodies_.states[moving[i]].model;
    swept[moving[i]] = tetratree::swept_box(
        motion_of[moving[i]]->exact(),
        [&, &extent = models().extent(model)](const kernel::Pose& pose) { return worker.box(model, extent, pose); });
  });
  return pairs_of_boxes(swept, moving);
}

/// Returns the pairs of these bodies whose boxes meet, except the ignored ones.
std::vector<Scene_pair> Scene_data::pairs_of_boxes(const std::vector<tetratree::World_box>& boxes,
                                                   const std::vector<Number>& bodies) const
{
  tetratree::Box_tree tree;
  tree.build(boxes, bodies);
  for (const Number body : bodies) tree.mark(body);
  std::vector<Scene_pair> pairs;
  for (const auto& part : tree.parts(1))
    tree.for_meeting(part, [&](Number a, Number b) {
      if (!near_.is_ignored(a, b)) pairs.push_back({kernel::minimum(a, b), kernel::maximum(a, b)});
    });
  return pairs;
}

std::optional<First_contact> Scene_data::first_contact(const Scene_pair& pair, const Motions& motion_of,
                                                       Scene_worker& worker)
{
  const auto [model_a, model_b] = bodies_.models_of(pair.a, pair.b);
  const bool is_turned = bodies_.states[pair.a].model != model_a;
  const Motion &a = *motion_of[pair.a], &b = *motion_of[pair.b];
  Query& query = worker.query(models(), model_a, model_b);
  auto first = is_turned ? query.first_contact(b, a) : query.first_contact(a, b);
  if (is_turned && first && first->holder) std::swap((*first->holder)[0], (*first->holder)[1]);
  return first;
}

}  // namespace tetracone::detail
