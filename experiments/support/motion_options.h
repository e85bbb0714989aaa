#ifndef TETRACONE_EXPERIMENTS_SUPPORT_MOTION_OPTIONS_H
#define TETRACONE_EXPERIMENTS_SUPPORT_MOTION_OPTIONS_H

#include "experiments/support/scene_options.h"
#include "tetracone/tetratree/door/motion.h"

namespace tetracone::experiments {

/// The user's options for motions of two models: the poses of each at t = 0 and t = 1, or the poses of a path of B.
struct Motion_names {
  std::string a, b, kind = "linear";
  std::string path;                  ///< consecutive poses of B, while A rests at --pose-a0; empty: none
  std::array<std::string, 4> poses;  ///< --pose-a0, --pose-a1, --pose-b0, --pose-b1; empty: the identity
  Model_options models;

  /// Adds the options of poses and of their kind, without the option of the path.
  void add_options_to(CLI::App& command);

  /// True when a pose is named.
  bool is_given() const
  {
    return std::ranges::any_of(poses, [](const std::string& file) { return !file.empty(); });
  }

  /// Throws covering::Input_error when the output is a file that is read.
  void refuse_as_output(const std::filesystem::path& output) const;
};

/// The motions of two bodies, in pairs.
struct Motion_pairs {
  std::vector<Motion> a, b;
};

/// Reads the motions of the files. A file with one pose is paired with every pose of the other file. A path moves from
/// each pose to the next. A line on stderr reports that a matrix was replaced by the motion of a quaternion near it.
/// Throws covering::Input_error for bad files, for numbers of poses that do not match, and for a path of one pose.
/// Quaternions between which one is 0 throw it too. Throws CLI::ValidationError for an unknown kind, and for a path
/// beside poses other than --pose-a0.
Motion_pairs read_motion_pairs(const Motion_names& names);

}  // namespace tetracone::experiments

#endif
