#ifndef TETRACONE_EXPERIMENTS_VIEWER_SCENE_DATA_H
#define TETRACONE_EXPERIMENTS_VIEWER_SCENE_DATA_H

#include "experiments/support/model_file.h"
#include "tetracone/kernel/predicate/question.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace tetracone::experiments {

/// Poses of all bodies and frames: a page of more would be too large for a browser.
constexpr std::size_t most_poses = 400'000;

/// All that a page shows of a scene file, as one line of JSON; experiments/viewer/page/scene.js reads it: `models`, of
/// each `vertices` and the corners of its `triangles`; of each of the `bodies` its model; `frames`, of each the poses;
/// `pairs`, of each frame those that collide. Throws covering::Input_error for bad input, for more than `most_poses`
/// and for models of more triangles than a page of two bodies takes.
std::string scene_data(const std::filesystem::path& file, kernel::Question question, const Model_options& models);

}  // namespace tetracone::experiments

#endif
