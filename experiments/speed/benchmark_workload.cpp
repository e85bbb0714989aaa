#include "experiments/speed/benchmark_workload.h"

#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/repair/repair.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/tetratree/query/bvh8_collision.h"
#include "verify/cases/random.h"
#include "verify/cases/shape_generators.h"

#include <array>
#include <cmath>

namespace tetracone::experiments {

using namespace verify;
namespace {

using kernel::Pose;
using kernel::Question;

Polyhedron scaled(Polyhedron polyhedron, double factor)
{
  for (auto& vertex : polyhedron.vertices)
    for (double& x : vertex) x *= factor;
  return polyhedron;
}

Polyhedron plate(int squares)
{
  return triangulated(
      voxel_solid(std::vector<bool>(static_cast<std::size_t>(squares) * squares, true), squares, squares, 1));
}

/// 15/16 of the rotation by the quaternion (3, 1, 2, 1): its entries are whole sixteenths, so that turned dyadic points
/// are exact.
constexpr std::array<std::array<double, 3>, 3> turned = {
    {{5 / 16., -2 / 16., 14 / 16.}, {10 / 16., 11 / 16., -2 / 16.}, {-10 / 16., 10 / 16., 5 / 16.}}};

Vertex turn_exactly(const Vertex& v)
{
  Vertex image;
  for (int i = 0; i < 3; ++i) image[i] = turned[i][0] * v[0] + turned[i][1] * v[1] + turned[i][2] * v[2];
  return image;
}

/// A multiple of 2^-10 in [-1, 1).
double dyadic(Random& random) { return std::floor(1024 * random.symmetric()) / 1024; }

/// The turned body, whose faces are parallel to no axis, and a copy on top of it. The copy is `height` up and shifted
/// sideways by up to `range`. With `lift`, it is one ulp more in a coordinate. All numbers are exact.
Race_course slid(const std::string& scenario, const std::string& object, Polyhedron body, double range, double height,
                 bool lift, int frames, std::uint64_t seed)
{
  for (Vertex& v : body.vertices) v = turn_exactly(v);
  Race_course course{scenario, object, 1, body, body, {}, true};
  Random random(seed);
  for (int k = 0; k < frames; ++k) {
    const double x = range * dyadic(random), y = range * dyadic(random);
    Vertex shift = turn_exactly({x, y, height});
    if (lift) shift[0] = std::nextafter(shift[0], 100);  // the coordinate in which up is most
    course.poses_b.push_back(Pose::translation(shift[0], shift[1], shift[2]));
  }
  return course;
}

}  // namespace

std::string Race_course::name() const
{
  std::string text =
      scenario + "-" + object + "-" + std::to_string(a.face_count()) + "-" + std::to_string(static_cast<int>(ratio));
  for (char& c : text)
    if (c == ' ') c = '-';
  return text;
}

Polyhedron triangulated(const Polyhedron& polyhedron)
{
  return covering::each_triangle_a_face(polyhedron, covering::triangulate_faces(polyhedron));
}

Polyhedron required(std::optional<Polyhedron> mesh, const std::filesystem::path& models)
{
  if (!mesh)
    throw covering::Input_error(models.native(), 0, "the meshes of libcgal-demo are not there",
                                "expected them: run experiments/support/fetch_models.sh");
  return *std::move(mesh);
}

double star_share(const Polyhedron& polyhedron)
{
  const Vertex centre = centroid(polyhedron);
  std::size_t corners = 0, positive = 0;
  for (covering::Index f = 0; f < polyhedron.face_count(); ++f) {
    const auto loop = polyhedron.loop(f, 0);
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
      const auto corner = [&](std::size_t i) { return kernel::difference(polyhedron.vertices[loop[i]], centre); };
      positive += kernel::determinant(corner(0), corner(k), corner(k + 1)) > 0;
      ++corners;
    }
  }
  return corners == 0 ? 0 : double(positive) / double(corners);
}

const Polyhedron& Race_objects::operator()(const std::string& name, std::size_t triangles)
{
  const auto found = made_.find({name, triangles});
  if (found != made_.end()) return found->second;
  const auto keep = [&](Polyhedron mesh) -> const Polyhedron& {
    return made_.emplace(std::pair(name, triangles), std::move(mesh)).first->second;
  };
  if (name == "blob") return keep(blob(triangles, 1));
  if (name == "knot") return keep(round_torus_knot(triangles));
  const char* file = name == "bunny"      ? "bunny00"
                     : name == "anchor"   ? "anchor_dense"
                     : name == "elephant" ? "refined_elephant"
                                          : name.c_str();
  const Polyhedron mesh = required(demo_mesh(models_, file), models_);
  return keep(normalised(triangles < mesh.face_count() ? decimate(mesh, triangles) : mesh));
}

Race_course on_trajectory(const Polyhedron& object, const std::string& name, const std::string& trajectory,
                          double ratio, int frames, std::uint64_t seed, int trajectories, Turning turning)
{
  Race_course course{turning == Turning::yes ? trajectory : trajectory + " not turning",
                     name,
                     ratio,
                     object,
                     scaled(object, 1 / ratio),
                     {}};
  tetratree::Bvh8 a(course.a), b(object);
  tetratree::Bvh8_collision collide(a, b);
  const auto collides = [&](const Pose& pose) { return collide(Pose(), pose, Question::surface); };
  const auto find = trajectory == "circular" ? circular_trajectory : contour_trajectory;
  for (int k = 0; k < trajectories; ++k)
    for (const Pose& pose : find(object, object, ratio, frames, seed + 100 * std::uint64_t(k), collides, turning)) {
      auto entries = pose.entries();
      for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) entries[4 * row + column] *= ratio;
      course.poses_b.emplace_back(entries);
    }
  return course;
}

Race_course stacked_boxes(int frames, std::uint64_t seed)
{
  return slid("stacked boxes", "cube", triangulated(unit_cube()), 0.75, 1, false, frames, seed);
}

Race_course face_on_face(int squares, int frames, std::uint64_t seed)
{
  return slid("face on face", "plate", plate(squares), 1, 1, false, frames, seed);
}

Race_course sliding_apart(int squares, int frames, std::uint64_t seed)
{
  return slid("one ulp apart", "plate", plate(squares), 1, 1, true, frames, seed);
}

Race_course shell_in_shell(std::size_t triangles, int frames, std::uint64_t seed)
{
  const Polyhedron inner = blob(triangles, 1);
  Race_course course{"shell in shell", "blob", 1, scaled(inner, 1.03), inner, {}, true};
  Random random(seed);
  for (int k = 0; k < frames; ++k) {
    const auto axis = random.in_ball(), shift = random.in_ball();
    const Rotation m = rotation(1, 0.001 * axis[0], 0.001 * axis[1], 0.001 * axis[2]);
    std::array<double, 12> entries;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) entries[4 * row + column] = m[row][column];
      entries[4 * row + 3] = 0.003 * shift[row];
    }
    course.poses_b.emplace_back(entries);
  }
  return course;
}

}  // namespace tetracone::experiments
