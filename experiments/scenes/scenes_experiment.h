#ifndef TETRACONE_EXPERIMENTS_SCENES_SCENES_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_SCENES_SCENES_EXPERIMENT_H

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// Measures how fast the colliding pairs of many bodies are found, frame after frame. The methods are `Scene` on one
/// thread and on two, our queries on the pairs of CGAL's box intersection, and the scenes of FCL, Bullet and ODE, on
/// the same poses in one run. Each answer is compared with the truth in rationals: on all frames for a thousand bodies,
/// on the last frame for more. Writes out/scenes.csv, one row per scene and method. `full` adds 10^5 bodies, and bodies
/// of 7000 triangles.
void run_scenes(const std::filesystem::path& out, std::size_t frames, bool full, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
