#include "experiments/viewer/view_data.h"

#include "tetracone/covering/io/input_error.h"
#include "tetracone/tetratree/scene/scene.h"
#include "verify/cases/scene_file.h"

#include <nlohmann/json.hpp>

namespace tetracone::experiments {
namespace {

using Json = nlohmann::ordered_json;

Json model_data(const covering::Polyhedron& polyhedron)
{
  Json vertices = Json::array(), triangles = Json::array();
  for (const auto& v : polyhedron.vertices)
    for (const double x : v) vertices.push_back(x);
  for (const auto& t : drawn_triangles(polyhedron, covering::Covering(polyhedron)))
    for (const covering::Index v : t.corner) triangles.push_back(v);
  return {{"vertices", vertices}, {"triangles", triangles}};
}

}  // namespace

std::string scene_data(const std::filesystem::path& name, kernel::Question question, const Model_options& options)
{
  verify::Scene_file file(name);
  const auto refuse = [&](const std::string& wrong, const std::string& expected) {
    throw covering::Input_error(name.native(), 0, wrong, expected);
  };
  if (file.frame_count() == 0) refuse("holds no frame", "expected one to show");
  if (file.frame_count() * file.bodies().size() > most_poses)
    refuse(std::to_string(file.frame_count()) + " frames of " + std::to_string(file.bodies().size()) + " bodies",
           "expected at most " + std::to_string(most_poses) + " poses to show");
  std::vector<bool> is_used(file.models().size(), false);
  for (const std::size_t model : file.bodies()) is_used[model] = true;

  Scene scene({.question = question});
  Json models = Json::array();
  std::size_t triangles = 0;
  for (std::size_t m = 0; m < file.models().size(); ++m) {
    std::optional<Body> body;
    if (is_used[m])
      body = load_model(file.models()[m].file.native(), options, question == kernel::Question::solid).body;
    models.push_back(model_data(body ? body->polyhedron() : covering::Polyhedron()));
    triangles += models.back()["triangles"].size() / 3;
    if (triangles > most_triangles)
      refuse("models of more than " + std::to_string(most_triangles) + " triangles", "expected fewer to show");
    scene.add_model([body] { return body.value(); }, file.models()[m].name);
  }
  for (const std::size_t model : file.bodies()) scene.add_body(model);
  for (const auto& [a, b] : file.ignored()) scene.ignore(a, b);

  Json frames = Json::array(), pairs = Json::array();
  for (std::size_t k = 0; k < file.frame_count(); ++k) {
    Json poses = Json::array(), colliding = Json::array();
    const auto placed = file.frame(k);
    for (std::size_t body = 0; body < placed.size(); ++body) {
      poses.push_back(placed[body].entries());
      scene.place(body, placed[body]);
    }
    for (const Scene_pair& pair : scene.pairs()) colliding.push_back({pair.a, pair.b});
    frames.push_back(std::move(poses));
    pairs.push_back(std::move(colliding));
  }
  return Json{{"name", name.filename().string()},
              {"models", models},
              {"bodies", file.bodies()},
              {"frames", frames},
              {"pairs", pairs}}
      .dump(-1, ' ', true, Json::error_handler_t::replace);  // a file's name may be no UTF-8
}

}  // namespace tetracone::experiments
