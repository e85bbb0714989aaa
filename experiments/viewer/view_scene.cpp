#include "experiments/viewer/view_scene.h"

#include "tetracone/covering/edge_uses.h"
#include "tetracone/covering/io/input_error.h"
#include "tetracone/kernel/motion/body_motion.h"

#include <CLI/CLI.hpp>

#include <initializer_list>
#include <numeric>
#include <utility>

namespace tetracone::experiments {
namespace {

using covering::Index;
using covering::Polyhedron;
using kernel::Pose;
using kernel::Question;
using verify::Predicate;

constexpr int motion_steps = 60;  // of the time to the first contact

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

/// The polyhedron of all triangles of the points, or the one face that they are.
Polyhedron simplex(std::initializer_list<kernel::Vertex> points)
{
  Polyhedron polyhedron;
  polyhedron.vertices = points;
  if (points.size() == 4) {
    for (const auto& [i, j, k] : {std::array<Index, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
      polyhedron.add_polygon({i, j, k});
  } else {
    std::vector<Index> loop(points.size());
    std::iota(loop.begin(), loop.end(), Index(0));
    polyhedron.add_polygon(loop);
  }
  return polyhedron;
}

std::pair<Polyhedron, Polyhedron> bodies_of(Predicate predicate, const verify::Predicate_case& c)
{
  const auto& v = c.v;
  switch (predicate) {
    case Predicate::orientation: return {simplex({v[1], v[2], v[3]}), simplex({c.p})};
    case Predicate::segment_triangle: return {simplex({v[1], v[2], v[3]}), simplex({c.p, c.q})};
    case Predicate::classification: return {simplex({v[0], v[1], v[2], v[3]}), simplex({c.p, c.q, c.r})};
    case Predicate::triangle_triangle: return {simplex({v[1], v[2], v[3]}), simplex({c.p, c.q, c.r})};
    case Predicate::tetra_cone:
    case Predicate::tetrahedron:
    case Predicate::solid: break;
  }
  return {simplex({v[0], v[1], v[2], v[3]}), simplex({c.p})};
}

View_scene scene_of_case(const std::string& file, std::optional<Question> question)
{
  View_scene scene;
  scene.name = file_name(file);
  scene.from = verify::read_case(file);
  const verify::Case_file& c = *scene.from;
  if (c.level == verify::Case_kind::predicate) {
    if (question) throw CLI::ValidationError("--question", "expected with bodies; " + file + " asks a predicate");
    const auto [a, b] = bodies_of(*c.predicate, *c.points);
    scene.bodies = {whole_model("A", a), whole_model("B", b)};
    scene.poses = {{c.points->pose_a}, {c.points->pose_b}};
    return scene;
  }
  scene.question = question.value_or(c.question);
  for (const auto& body : {c.object->a, c.object->b})
    if (scene.question == Question::solid && !covering::is_closed(*body))
      throw covering::Input_error(file, 0, "a body is an open surface and has no solid", "expected --question surface");
  scene.bodies = {whole_model("A", *c.object->a), whole_model("B", *c.object->b)};
  scene.poses = {{c.object->pose_a}, {c.object->pose_b}};
  return scene;
}

}  // namespace

View_scene read_view_scene(const Scene_names& names, std::optional<Question> question)
{
  if (verify::is_case_name(names.a)) {
    names.refuse_all_but_case();
    return scene_of_case(names.a, question);
  }

  View_scene scene;
  scene.question = question.value_or(Question::solid);
  scene.poses = read_pose_pairs(names);
  const bool pair = !names.b.empty(), solid = pair && scene.question == Question::solid;
  if (!pair && !names.poses_b.empty()) throw CLI::ValidationError("--pose-b", "expected with a second model, B");
  scene.name = file_name(names.a) + (pair ? " and " + file_name(names.b) : "");
  scene.bodies.push_back(load_model(names.a, names.models, solid));
  if (pair) scene.bodies.push_back(load_model(names.b, names.models, solid));
  return scene;
}

View_scene read_view_motion(const Motion_names& names, Question question)
{
  const Motion_pairs motions = read_motion_pairs(names);
  if (motions.a.size() != 1)
    throw CLI::ValidationError(std::to_string(motions.a.size()) + " motions", "expected one to show");

  View_scene scene;
  scene.question = question;
  scene.name = file_name(names.a) + " and " + file_name(names.b);
  for (const std::string& file : {names.a, names.b})
    scene.bodies.push_back(load_model(file, names.models, question == Question::solid));

  Query query(scene.bodies[0].body, scene.bodies[1].body, question);
  View_motion motion{{}, query.first_contact(motions.a[0], motions.b[0])};
  const double end = motion.first ? motion.first->lo : 1;
  for (int k = 0; k <= motion_steps; ++k) {
    const double time = k == motion_steps ? end : end * k / motion_steps;
    if (!motion.times.empty() && time <= motion.times.back()) continue;
    const Pose a = motions.a[0].exact().at(time), b = motions.b[0].exact().at(time);
    if (a.determinant_sign() == CGAL::ZERO || b.determinant_sign() == CGAL::ZERO) continue;
    motion.times.push_back(time);
    scene.poses.a.push_back(a);
    scene.poses.b.push_back(b);
  }
  scene.motion = std::move(motion);
  return scene;
}

}  // namespace tetracone::experiments
