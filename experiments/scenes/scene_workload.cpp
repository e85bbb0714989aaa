#include "experiments/scenes/scene_workload.h"

#include "experiments/speed/benchmark_workload.h"
#include "tetracone/kernel/number/products.h"
#include "verify/cases/object_placing.h"
#include "verify/cases/random.h"
#include "verify/cases/shape_generators.h"

#include <array>
#include <cmath>

namespace tetracone::experiments {
namespace {

using covering::Index;
using covering::Polyhedron;
using kernel::Pose;
using verify::Random;
using verify::Vector;

constexpr double frames_a_second = 60;

/// An icosahedron whose faces are parted in four, on a sphere of radius 1: 80 triangles.
Polyhedron ball()
{
  const double g = (1 + std::sqrt(5.0)) / 2;
  std::vector<Vector> points;
  for (const double s : {-1.0, 1.0})
    for (const double t : {-g, g})
      for (int k = 0; k < 3; ++k) {
        Vector p{};
        p[k] = s;
        p[(k + 1) % 3] = t;
        points.push_back(p);
      }
  const auto are_near = [&](std::size_t a, std::size_t b) {
    const Vector way = kernel::difference(points[a], points[b]);
    return kernel::dot(way, way) <= 4.1;
  };
  Polyhedron ball;
  std::map<std::pair<Index, Index>, Index> middle;
  const auto add = [&ball](const Vector& p) {
    const double length = std::sqrt(kernel::dot(p, p));
    ball.vertices.push_back({p[0] / length, p[1] / length, p[2] / length});
    return Index(ball.vertices.size() - 1);
  };
  for (const Vector& p : points) add(p);
  const auto between = [&](Index a, Index b) {
    const auto [known, is_new] = middle.try_emplace(std::minmax(a, b), 0);
    const auto &p = ball.vertices[a], &q = ball.vertices[b];
    if (is_new) known->second = add({p[0] + q[0], p[1] + q[1], p[2] + q[2]});
    return known->second;
  };
  for (Index a = 0; a < 12; ++a)
    for (Index b = a + 1; b < 12; ++b)
      for (Index c = b + 1; c < 12; ++c) {
        if (!are_near(a, b) || !are_near(b, c) || !are_near(a, c)) continue;
        const bool is_outward = kernel::determinant(points[a], points[b], points[c]) > 0;
        const Index second = is_outward ? b : c, third = is_outward ? c : b;
        const Index ab = between(a, second), bc = between(second, third), ca = between(third, a);
        for (const auto& t : {std::array{a, ab, ca}, {ab, second, bc}, {ca, bc, third}, {ab, bc, ca}})
          ball.add_polygon(t);
      }
  return ball;
}

Pose pose_of(const std::array<double, 4>& q, const Vector& at)
{
  return verify::object_family::rotated(verify::rotation(q[0], q[1], q[2], q[3]), at);
}

/// Where a body is, how it stands, and how both change.
struct Moving_body {
  Vector at, velocity;
  std::array<double, 4> turn, spin;
};

/// A frame later, in a cube of this size about 0.
void move(Moving_body& body, const std::string& kind, double size, Random& random)
{
  const auto wander = [&](double by) {
    for (double& x : body.at) x += by * random.symmetric();
    for (double& q : body.turn) q += by * random.symmetric();
  };
  const auto go = [&] {
    for (int k = 0; k < 3; ++k) body.at[k] += body.velocity[k] / frames_a_second;
  };
  if (kind == "brownian") wander(0.01);
  if (kind == "fall") {
    body.velocity[2] -= 9.81 / frames_a_second;
    go();
    if (body.at[2] < -size / 2) {
      body.at[2] += size;
      body.velocity[2] = 0;
    }
  }
  if (kind == "gravity") {
    for (int k = 0; k < 3; ++k) body.velocity[k] -= 2 * body.at[k] / frames_a_second;
    go();
  }
  if (kind == "fall" || kind == "gravity" || kind == "thin")
    for (int k = 0; k < 4; ++k) body.turn[k] += body.spin[k] / frames_a_second;
}

}  // namespace

Scene_workload scene_workload(const std::string& kind, const std::string& model, std::size_t bodies, std::size_t frames,
                              std::uint64_t seed)
{
  Random random(seed);
  Scene_workload scene{kind, model, {}, {}, {}};
  if (kind == "thin")
    for (const double x : {10, 20}) scene.models.push_back(triangulated(verify::box({-x, -0.5, -0.5}, {x, 0.5, 0.5})));
  else if (model == "convex")
    scene.models = {ball()};
  else
    for (const std::uint64_t k : {1, 2}) scene.models.push_back(verify::blob(model == "blob" ? 760 : 7000, seed + k));
  const double volume = kind == "thin" ? 30 : 5;
  const double size = std::cbrt(double(bodies) * volume * 10);

  std::vector<Moving_body> all(bodies);
  for (std::size_t k = 0; k < bodies; ++k) {
    scene.model_of.push_back(k % scene.models.size());
    Moving_body& body = all[k];
    for (double& x : body.at) x = size / 2 * random.symmetric();
    for (double& v : body.velocity) v = random.symmetric();
    for (double& q : body.turn) q = random.symmetric();
    body.turn[0] += 2;
    for (double& q : body.spin) q = random.symmetric();
  }
  for (std::size_t frame = 0; frame < frames; ++frame) {
    std::vector<Pose>& poses = scene.frames.emplace_back();
    for (std::size_t k = 0; k < bodies; ++k) {
      Moving_body& body = all[k];
      if (frame > 0) move(body, kind == "resting" ? (k % 100 == 0 ? "brownian" : "none") : kind, size, random);
      poses.push_back(frame > 0 && kind == "resting" && k % 100 != 0 ? scene.frames[frame - 1][k]
                                                                     : pose_of(body.turn, body.at));
    }
  }
  return scene;
}

}  // namespace tetracone::experiments
