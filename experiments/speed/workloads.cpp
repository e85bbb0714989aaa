#include "experiments/speed/workloads.h"

#include "experiments/speed/benchmark_workload.h"
#include "verify/cases/object_placing.h"
#include "verify/cases/shape_generators.h"
#include "verify/subjects/subject.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>

namespace tetracone::experiments {

using namespace verify;
namespace {

using covering::Polyhedron;
using kernel::Pose;
using kernel::Question;
using kernel::Rational;
using object_family::power_of_two;

/// The four objects of the time study, each made once on demand.
class Objects {
 public:
  explicit Objects(std::filesystem::path models) : models_(std::move(models)) {}

  const Polyhedron& operator[](const std::string& name)
  {
    if (!made_.contains(name)) made_.emplace(name, make(name));
    return made_.at(name);
  }

 private:
  Polyhedron make(const std::string& name) const
  {
    if (name == "complex-1") return complex_one();
    if (name == "complex-2") return complex_two();
    return required(name == "cat-size" ? small_mesh(models_) : large_mesh(models_), models_);
  }

  std::filesystem::path models_;
  std::map<std::string, Polyhedron> made_;
};

Workload on_trajectory(Objects& objects, const std::string& trajectory, const std::string& a, const std::string& b,
                       double ratio, int frames, std::uint64_t seed)
{
  Workload w{"trajectory", trajectory, a, b, objects[a], objects[b], 1 / ratio, {Pose()}, {}, {Question::surface}};
  const auto pair = verify::prepare(*verify::Subject::parse("double"), w.a, w.b);
  const auto collides = [&pair](const Pose& pose_b) { return pair->collide(Pose(), pose_b, Question::surface); };
  w.poses_b = trajectory == "circular" ? circular_trajectory(w.a, w.b, ratio, frames, seed, collides)
                                       : contour_trajectory(w.a, w.b, ratio, frames, seed, collides);
  return w;
}

/// Puts both bodies into a random common frame, B moved by a shift. If `exact`, the contact is kept exactly. Otherwise
/// both poses are rounded to doubles.
void add_poses(Workload& w, Random& random, const Shift& shift, bool exact)
{
  const Common_frame frame(random);
  w.poses_a.push_back(frame.placed({0, 0, 0}, exact));
  w.poses_b.push_back(frame.placed(shift, exact));
}

Workload degenerate(const std::string& scenario, const std::string& a_name, Polyhedron a, const std::string& b_name,
                    Polyhedron b)
{
  return {"degenerate", scenario, a_name, b_name, std::move(a),
          std::move(b), 1,        {},     {},     {Question::surface, Question::solid}};
}

/// Two unit cubes that share a face, an edge or a vertex.
Workload cubes(const std::string& scenario, const Shift& shift, bool exact, int rotations, Random random)
{
  Workload w = degenerate(scenario, "cube", unit_cube(), "cube", unit_cube());
  for (int k = 0; k < rotations; ++k) add_poses(w, random, shift, exact);
  return w;
}

/// Two unit cubes face to face, alternately with a gap and an overlap, of 2^-20 down to 2^-60.
Workload cubes_with_gap(int rotations, Random random)
{
  Workload w = degenerate("gap of 2^-20 to 2^-60", "cube", unit_cube(), "cube", unit_cube());
  for (int k = 0; k < rotations; ++k) {
    const Rational gap = power_of_two(-20 - 40 * k / rotations);
    add_poses(w, random, {k % 2 == 0 ? Rational(1 + gap) : Rational(1 - gap), Rational(1) / 3, Rational(1) / 7}, true);
  }
  return w;
}

/// A small cube strictly inside a big one.
Workload nested(int rotations, Random random)
{
  Workload w = degenerate("nested", "cube", unit_cube(), "small cube", box({0, 0, 0}, {0.25, 0.25, 0.25}));
  for (int k = 0; k < rotations; ++k)
    add_poses(w, random, {Rational(1) / (3 + k % 5), Rational(3) / 8, Rational(1) / 3}, true);
  return w;
}

/// A small cube in the cavity of a box, alternately free and touching the wall from inside.
Workload in_cavity(int rotations, Random random)
{
  Workload w = degenerate("in a cavity", "box with cavity", box_with_cavity(0.5, 0.25), "small cube",
                          box({-0.125, -0.125, -0.125}, {0.125, 0.125, 0.125}));
  for (int k = 0; k < rotations; ++k)
    add_poses(w, random, {k % 2 == 0 ? Rational(1) / 8 : Rational(1) / 9, Rational(1) / 9, Rational(1) / 11}, true);
  return w;
}

/// The complex polyhedra side by side. A vertex of A that is farthest along x is alternately on a vertex of B that is
/// farthest against x and slightly off it.
Workload stacked(Objects& objects, int rotations, Random random)
{
  Workload w = degenerate("stacked", "complex-1", objects["complex-1"], "complex-2", objects["complex-2"]);
  const auto farthest = [](const Polyhedron& body, double sign) {
    double most = sign * body.vertices[0][0];
    for (const auto& v : body.vertices) most = std::max(most, sign * v[0]);
    std::vector<kernel::Vertex> all;
    std::ranges::copy_if(body.vertices, std::back_inserter(all),
                         [&](const kernel::Vertex& v) { return sign * v[0] == most; });
    return all;
  };
  const auto highest = farthest(w.a, 1), lowest = farthest(w.b, -1);
  for (int k = 0; k < rotations; ++k) {
    const kernel::Vertex &u = highest[random.bits() % highest.size()], &v = lowest[random.bits() % lowest.size()];
    Shift shift;
    for (int i = 0; i < 3; ++i) shift[i] = Rational(u[i]) - Rational(v[i]);
    if (k % 2 == 1) shift[0] += power_of_two(-50);
    add_poses(w, random, shift, true);
  }
  return w;
}

/// The mesh against itself, extreme vertex on extreme vertex along a random direction, alternately in contact and apart
/// by at most 2^-50 in each coordinate.
Workload vertex_on_vertex(Objects& objects, int rotations, Random random)
{
  Workload w = degenerate("vertex on vertex", "cat-size", objects["cat-size"], "cat-size", objects["cat-size"]);
  for (int k = 0; k < rotations; ++k) {
    std::array<double, 3> d;
    for (double& x : d) x = static_cast<int>(random.bits() % 129) - 64;
    if (d == std::array<double, 3>{0, 0, 0}) d[0] = 1;
    const auto along = [&d](const kernel::Vertex& v) -> Rational {
      return Rational(d[0]) * Rational(v[0]) + Rational(d[1]) * Rational(v[1]) + Rational(d[2]) * Rational(v[2]);
    };
    const auto less = [&along](const kernel::Vertex& u, const kernel::Vertex& v) { return along(u) < along(v); };
    const auto& vertices = w.a.vertices;
    const kernel::Vertex highest = *std::max_element(vertices.begin(), vertices.end(), less);
    const kernel::Vertex lowest = *std::min_element(vertices.begin(), vertices.end(), less);
    const Rational gap = k % 2 == 0 ? Rational(0) : power_of_two(-56);
    Shift shift;
    for (int i = 0; i < 3; ++i) shift[i] = Rational(highest[i]) - Rational(lowest[i]) + gap * Rational(d[i]);
    add_poses(w, random, shift, true);
  }
  return w;
}

}  // namespace

Common_frame::Common_frame(Random& random)
{
  while (quaternion_ == std::array<int, 4>{0, 0, 0, 0})
    for (int& x : quaternion_) x = static_cast<int>(random.bits() % 19) - 9;
  for (Rational& x : offset_) x = Rational(static_cast<int>(random.bits() % 2001) - 1000) / 97;
}

Pose Common_frame::placed(const Shift& shift, bool exact) const
{
  const auto [w, x, y, z] = quaternion_;
  const Pose rotation = Pose::from_quaternion(w, x, y, z);
  Shift t = offset_;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) t[i] += rotation.exact(4 * i + j) * shift[j];
  }
  const Pose pose = Pose::from_quaternion(w, x, y, z, t);
  return exact ? pose : Pose(pose.entries());
}

std::vector<Named_workload> study_workloads(const std::filesystem::path& models, int frames, int rotations,
                                            std::uint64_t seed)
{
  const auto objects = std::make_shared<Objects>(models);
  std::vector<Named_workload> list;

  const auto add_trajectory = [&](const std::string& trajectory, const std::string& a, const std::string& b,
                                  int ratio) {
    list.push_back({trajectory + "-" + a + "-" + b + "-" + std::to_string(ratio), [=, number = list.size()] {
                      return on_trajectory(*objects, trajectory, a, b, ratio, frames, seed + 1000 * number);
                    }});
  };
  const std::array<std::string, 4> names = {"complex-1", "complex-2", "cat-size", "horse-size"};
  for (const char* trajectory : {"circular", "contour"}) {
    for (std::size_t i = 0; i < names.size(); ++i)
      for (std::size_t j = i; j < names.size(); ++j) add_trajectory(trajectory, names[i], names[j], 1);
    for (const int ratio : {2, 4, 8, 16}) add_trajectory(trajectory, "horse-size", "horse-size", ratio);
  }

  const auto add = [&](const std::string& name, auto make) {
    list.push_back({"degenerate-" + name, [=, random = Random(seed + 1000 * list.size())] { return make(random); }});
  };
  for (const bool exact : {true, false}) {
    const std::string suffix = exact ? "" : " (rounded poses)";
    const std::string file = exact ? "" : "-rounded";
    add("face" + file, [=](Random r) { return cubes("shared face" + suffix, {1, 0, 0}, exact, rotations, r); });
    add("edge" + file, [=](Random r) { return cubes("shared edge" + suffix, {1, 1, 0}, exact, rotations, r); });
    add("vertex" + file, [=](Random r) { return cubes("shared vertex" + suffix, {1, 1, 1}, exact, rotations, r); });
  }
  add("gap", [=](Random r) { return cubes_with_gap(rotations, r); });
  const Rational ulp = power_of_two(-52);
  add("ulp", [=](Random r) { return cubes("gap of one ulp", {1 + ulp, 0, 0}, true, rotations, r); });
  add("nested", [=](Random r) { return nested(rotations, r); });
  add("cavity", [=](Random r) { return in_cavity(rotations, r); });
  add("stacked", [=](Random r) { return stacked(*objects, rotations, r); });
  add("vertex-on-vertex", [=](Random r) { return vertex_on_vertex(*objects, rotations, r); });
  return list;
}

}  // namespace tetracone::experiments
