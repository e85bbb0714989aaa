#ifndef TETRACONE_EXPERIMENTS_SPEED_STUDY_H
#define TETRACONE_EXPERIMENTS_SPEED_STUDY_H

#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// The options of the study.
struct Study_options {
  std::filesystem::path out = "out";
  std::filesystem::path models;  ///< the folder that fetch_models.sh filled with libcgal-demo's meshes
  int frames = 60;               ///< poses of each trajectory
  int rotations = 100;           ///< rotations of each degenerate scenario
  std::uint64_t seed = 1;
};

/// Runs the robustness and time study. Every subject is asked on the trajectories of JS08 section 4 and on exactly
/// degenerate contacts; its answers are judged by the truth and its time is measured. Writes out/study.csv, one row for
/// each workload, question and subject.
///
/// Each workload's rows are saved under out/study/ as soon as they are made. Started again with equal options, the
/// study continues after the last of them. Throws covering::Input_error when the models do not exist or `out` cannot be
/// written.
void run_study(const Study_options& options);

}  // namespace tetracone::experiments

#endif
