#ifndef TETRACONE_EXPERIMENTS_SPEED_BENCHMARK_WORKLOAD_H
#define TETRACONE_EXPERIMENTS_SPEED_BENCHMARK_WORKLOAD_H

#include "experiments/speed/trajectory.h"
#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/pose.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tetracone::experiments {

/// Two bodies, and poses of B that every contestant can take: A stays in its own frame, B's matrix is a rotation in
/// doubles. A relative size is in B's vertices.
struct Race_course {
  std::string scenario;  ///< circular, contour, or a kind of near contact
  std::string object;    ///< both bodies are of this shape
  double ratio = 1;      ///< A's size over B's
  covering::Polyhedron a, b;
  std::vector<kernel::Pose> poses_b;
  bool degenerate = false;

  /// The file name of its rows.
  std::string name() const;
};

/// The share of the corners of faces whose tetrahedron with the centroid is positive: 1 when the body is star-shaped
/// about it.
double star_share(const covering::Polyhedron& polyhedron);

/// Triangle meshes of a size by their name: "blob" (star-shaped) and "knot" (genus 1), generated, at any size; others
/// are libcgal-demo's, decimated and normalised: "bunny", "dino", "camel" (on four legs), "anchor" (genus 4) and
/// "elephant".
class Race_objects {
 public:
  /// `models` is the folder that fetch_models.sh filled.
  explicit Race_objects(std::filesystem::path models) : models_(std::move(models)) {}

  /// Made once. Throws covering::Input_error when the mesh is not there.
  const covering::Polyhedron& operator()(const std::string& name, std::size_t triangles);

 private:
  std::filesystem::path models_;
  std::map<std::pair<std::string, std::size_t>, covering::Polyhedron> made_;
};

/// The object against itself, B 1 / ratio as large, on `trajectories` of JS08 section 4, "circular" or "contour", one
/// after the other, `frames` poses each; where B does not turn, the scenario's name says so. Requires ratio a power of
/// two.
Race_course on_trajectory(const covering::Polyhedron& object, const std::string& name, const std::string& trajectory,
                          double ratio, int frames, std::uint64_t seed, int trajectories = 1,
                          Turning turning = Turning::yes);

// Exactly degenerate contact: bodies turned so that no face lies along an axis, in poses whose doubles say it exactly.
// Every answer takes the exact path.

/// Cubes, one on the other, shifted sideways: they share a part of a face.
Race_course stacked_boxes(int frames, std::uint64_t seed);
/// A plate of n x n squares, one on the other, face on face.
Race_course face_on_face(int squares, int frames, std::uint64_t seed);
/// The plates of `face_on_face`, one ulp apart: nothing collides, and every near pair has to be decided.
Race_course sliding_apart(int squares, int frames, std::uint64_t seed);
/// A star-shaped shell in the same 3 % larger, turned and shifted by a little: two surfaces nearly parallel and close
/// everywhere, nothing collides.
Race_course shell_in_shell(std::size_t triangles, int frames, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
