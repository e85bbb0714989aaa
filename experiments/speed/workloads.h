#ifndef TETRACONE_EXPERIMENTS_SPEED_WORKLOADS_H
#define TETRACONE_EXPERIMENTS_SPEED_WORKLOADS_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/question.h"
#include "verify/cases/random.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tetracone::experiments {

using Shift = std::array<kernel::Rational, 3>;

/// A random rigid map R: the rotation of an integer quaternion, then an offset of fractions.
class Common_frame {
 public:
  explicit Common_frame(verify::Random& random);

  /// Returns the pose that shifts a body, then applies R, in fractions. Unless `exact`, it is rounded to doubles.
  kernel::Pose placed(const Shift& shift, bool exact) const;

 private:
  std::array<int, 4> quaternion_{};
  Shift offset_;
};

/// Two bodies, their poses and the questions asked of them.
struct Workload {
  std::string regime;    ///< trajectory or degenerate
  std::string scenario;  ///< circular, contour, or the kind of contact
  std::string a_name, b_name;
  covering::Polyhedron a, b;
  double scale_b = 1;                          ///< the scale in the poses of B: 1 / relative size, a power of two
  std::vector<kernel::Pose> poses_a, poses_b;  ///< as many for A as for B, or one
  std::vector<kernel::Question> questions;

  /// Returns A's pose that goes with poses_b[k].
  const kernel::Pose& pose_a(std::size_t k) const { return poses_a[poses_a.size() == 1 ? 0 : k]; }
};

/// A workload that is made on demand.
struct Named_workload {
  std::string name;  ///< a file name
  std::function<Workload()> make;
};

/// Returns the workloads of the study. The four objects are those of JS08 Fig. 15: two complex polyhedra, a mesh of the
/// cat's size and one of the horse's. They move in all pairs on both trajectories of its section 4. The largest moves
/// against itself at relative sizes 1:2 to 1:16. Scenarios of exactly degenerate contact have `rotations` poses each.
/// `models` is the folder that fetch_models.sh filled. A workload's `make` throws covering::Input_error when a mesh
/// does not exist.
std::vector<Named_workload> study_workloads(const std::filesystem::path& models, int frames, int rotations,
                                            std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
