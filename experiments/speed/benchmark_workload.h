#ifndef TETRACONE_EXPERIMENTS_SPEED_BENCHMARK_WORKLOAD_H
#define TETRACONE_EXPERIMENTS_SPEED_BENCHMARK_WORKLOAD_H

#include "experiments/speed/trajectory.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace tetracone::experiments {

/// Two bodies, and poses of B that every contestant can take: A stays in its own frame, and B's matrix is a rotation in
/// doubles. A relative size is scaled into B's vertices.
struct Race_course {
  std::string scenario;  ///< circular, contour, or a kind of near contact
  std::string object;    ///< both bodies are of this shape
  double ratio = 1;      ///< A's size over B's
  covering::Polyhedron a, b;
  std::vector<kernel::Pose> poses_b;
  bool degenerate = false;  ///< one of the courses of contact and near contact below

  /// Returns the file name of its rows.
  std::string name() const;
};

/// Returns the polyhedron with each face of more than three corners replaced by triangles. A face that has no
/// triangulation stays.
covering::Polyhedron triangulated(const covering::Polyhedron& polyhedron);

/// Returns the mesh. Throws covering::Input_error, which names the folder `models`, where there is none.
covering::Polyhedron required(std::optional<covering::Polyhedron> mesh, const std::filesystem::path& models);

/// Returns the fraction of face corners whose tetrahedron with the centroid is positive: 1 when the body is star-shaped
/// about it.
double star_share(const covering::Polyhedron& polyhedron);

/// Triangle meshes of about a given size by their name. "blob" (star-shaped) and "knot" (genus 1) are generated at any
/// size. The others are libcgal-demo's, normalised, and decimated if they are larger: "bunny", "dino", "camel" (on four
/// legs), "knot2", "anchor" (genus 4) and "elephant".
class Race_objects {
 public:
  /// `models` is the folder that fetch_models.sh filled.
  explicit Race_objects(std::filesystem::path models) : models_(std::move(models)) {}

  /// Returns the mesh, which is made once. Throws covering::Input_error when its file does not exist.
  const covering::Polyhedron& operator()(const std::string& name, std::size_t triangles);

 private:
  std::filesystem::path models_;
  std::map<std::pair<std::string, std::size_t>, covering::Polyhedron> made_;
};

/// Returns the object against itself, with B 1 / ratio as large, on `trajectories` consecutive trajectories of JS08
/// section 4, "circular" or "contour", of `frames` poses each. If B does not turn, the scenario's name tells it.
/// Requires triangles, and a ratio that is a power of two.
Race_course on_trajectory(const covering::Polyhedron& object, const std::string& name, const std::string& trajectory,
                          double ratio, int frames, std::uint64_t seed, int trajectories = 1,
                          Turning turning = Turning::yes);

// Contact and near contact. In the first three, the bodies are turned so that no face is parallel to an axis. All of
// their numbers are exact in doubles, so the contact is exactly degenerate.

/// A cube on another, shifted sideways: they share a part of a face.
Race_course stacked_boxes(int frames, std::uint64_t seed);
/// A plate of n x n squares on another, face on face.
Race_course face_on_face(int squares, int frames, std::uint64_t seed);
/// The plates of `face_on_face`, one ulp apart: nothing collides, and every near pair has to be decided.
Race_course sliding_apart(int squares, int frames, std::uint64_t seed);
/// A star-shaped body inside itself enlarged by 3 %, turned and shifted slightly in rounded poses. The surfaces are
/// nearly parallel and close everywhere, but do not meet; the solids always collide.
Race_course shell_in_shell(std::size_t triangles, int frames, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
