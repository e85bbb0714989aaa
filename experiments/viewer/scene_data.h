#ifndef TETRACONE_EXPERIMENTS_VIEWER_SCENE_DATA_H
#define TETRACONE_EXPERIMENTS_VIEWER_SCENE_DATA_H

#include "experiments/support/model_file.h"
#include "tetracone/kernel/predicate/question.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace tetracone::experiments {

/// The largest number of poses over all bodies and frames: a larger page would not fit a browser.
constexpr std::size_t most_poses = 400'000;

/// Returns all that a page shows of a scene file, as one line of JSON; experiments/viewer/page/scene.js reads it. It
/// has `models`, each with `vertices` and the corners of its `triangles`; `bodies`, each by its model; `frames`, each
/// with its poses; and `pairs`, the colliding ones of each frame. A model without a body is empty. Throws
/// covering::Input_error for bad input and for a scene without a frame. It also throws it for more than `most_poses`
/// poses, and for models of more than `most_triangles` triangles (view_data.h).
std::string scene_data(const std::filesystem::path& file, kernel::Question question, const Model_options& models);

}  // namespace tetracone::experiments

#endif
