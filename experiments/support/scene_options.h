#ifndef TETRACONE_EXPERIMENTS_SUPPORT_SCENE_OPTIONS_H
#define TETRACONE_EXPERIMENTS_SUPPORT_SCENE_OPTIONS_H

#include "experiments/support/model_file.h"
#include "tetracone/kernel/number/pose.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>

namespace tetracone::experiments {

/// The user's options for a scene: one or two models with their poses, or a case file alone.
struct Scene_names {
  std::string a, b, poses_a, poses_b;
  Model_options models;

  /// Adds the options of models and poses. The command itself defines what A and B may be.
  void add_options_to(CLI::App& command);

  /// Throws CLI::ValidationError when something is named beside a case file, which holds both bodies and poses.
  void refuse_all_but_case() const;

  /// Throws covering::Input_error when the output is a file of the scene.
  void refuse_as_output(const std::filesystem::path& output) const;
};

/// The poses of two bodies, in pairs; a single pose of one body is paired with every pose of the other.
struct Pose_pairs {
  std::vector<kernel::Pose> a, b;

  std::size_t count() const { return std::max(a.size(), b.size()); }
  const kernel::Pose& of_a(std::size_t k) const { return a[a.size() == 1 ? 0 : k]; }
  const kernel::Pose& of_b(std::size_t k) const { return b[b.size() == 1 ? 0 : k]; }
};

/// Reads the poses of both files; without a file, the identity. Throws covering::Input_error for bad files, and for
/// numbers of poses that do not match.
Pose_pairs read_pose_pairs(const Scene_names& names);

}  // namespace tetracone::experiments

#endif
