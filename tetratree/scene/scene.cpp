#include "tetracone/tetratree/scene/scene.h"

#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/scene/scene_data.h"

#include <string>
#include <utility>

namespace tetracone {

Scene::Scene(const Scene_options& options) : data_(std::make_unique<detail::Scene_data>(options)) {}
Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

std::size_t Scene::add_model(const Body& body)
{
  const std::string name = "model " + std::to_string(data_->models().count());
  return data_->models().add([body] { return body; }, name, true);
}
std::size_t Scene::add_model(std::function<Body()> make, const std::string& name)
{
  return data_->models().add(std::move(make), name, false);
}

std::size_t Scene::add_body(std::size_t model) { return data_->add_body(model); }
void Scene::remove_body(std::size_t body) { data_->remove_body(body); }
void Scene::set_model(std::size_t body, std::size_t model) { data_->set_model(body, model); }
void Scene::ignore(std::size_t body_a, std::size_t body_b) { data_->ignore(body_a, body_b); }

void Scene::place(std::size_t body, const Pose& pose) { data_->place(body, pose.exact()); }
void Scene::place(std::size_t body, const kernel::Pose& pose) { data_->place(body, pose); }

const std::vector<Scene_pair>& Scene::pairs() { return data_->pairs(); }

const std::vector<Scene_pair>& Scene::frame(std::span<const Pose> poses)
{
  const std::vector<std::size_t> bodies = data_->present(poses.size(), "poses");
  for (std::size_t k = 0; k < bodies.size(); ++k) place(bodies[k], poses[k]);
  return pairs();
}

std::vector<Scene_contact> Scene::first_contacts(std::span<const Motion> motions)
{
  return data_->first_contacts(motions);
}

std::vector<Scene_contact> Scene::first_contacts(std::span<const Pose> to)
{
  const std::vector<std::size_t> bodies = data_->present(to.size(), "poses");
  std::vector<Motion> motions;
  motions.reserve(to.size());
  for (std::size_t k = 0; k < to.size(); ++k)
    motions.emplace_back(kernel::Body_motion::linear(data_->pose(bodies[k]), to[k].exact()));
  return data_->first_contacts(motions);
}

std::vector<Scene_distance> Scene::pairs_within(const std::string& limit) { return data_->pairs_within(limit); }

const std::vector<Undecided_pair>& Scene::undecided() const { return data_->undecided(); }
const Frame_statistics& Scene::statistics() const { return data_->statistics(); }

Relation Scene::relation(std::size_t a, std::size_t b)
{
  return data_->ask(a, b, [](Query& query, const auto&... poses) { return query.collide(poses...).relation(); });
}
Solid_contact Scene::solid_relation(std::size_t a, std::size_t b)
{
  return data_->ask(a, b, [](Query& query, const auto&... poses) { return query.solid_relation(poses...); });
}
Overlap Scene::overlap(std::size_t a, std::size_t b)
{
  return data_->ask(a, b, [](Query& query, const auto&... poses) { return query.overlap(poses...); });
}
Exits Scene::exits(std::size_t a, std::size_t b, const std::array<std::string, 3>& direction)
{
  return data_->ask(a, b,
                    [&direction](Query& query, const auto&... poses) { return query.exits(poses..., direction); });
}
Depth Scene::depth(std::size_t a, std::size_t b, const Depth_options& options)
{
  return data_->ask(a, b, [&options](Query& query, const auto&... poses) { return query.depth(poses..., options); });
}
Contacts Scene::contacts(std::size_t a, std::size_t b)
{
  return data_->ask(a, b, [](Query& query, const auto&... poses) { return query.contacts(poses...); });
}
double Scene::distance(std::size_t a, std::size_t b)
{
  return data_->ask(a, b, [](Query& query, const auto&... poses) { return query.distance(poses...); });
}
bool Scene::within(std::size_t a, std::size_t b, double limit) { return within(a, b, kernel::shortest(limit)); }
bool Scene::within(std::size_t a, std::size_t b, const std::string& limit)
{
  return data_->ask(a, b, [&limit](Query& query, const auto&... poses) { return query.within(poses..., limit); });
}

}  // namespace tetracone
