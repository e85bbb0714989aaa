#ifndef TETRACONE_EXPERIMENTS_SCENES_SCENES_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_SCENES_SCENES_EXPERIMENT_H

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// Which of many bodies collide, frame after frame: `Scene` on one thread and on two, our queries on the pairs of CGAL's
/// box intersection, and the scenes of FCL, Bullet and ODE, on the same poses in one run. What each answers is compared
/// with the truth in rationals: on all frames of a thousand bodies, of more on the last frame. Writes out/scenes.csv, a
/// row a scene and method. `full`: also 10^5 bodies, and bodies of 7000 triangles.
void run_scenes(const std::filesystem::path& out, std::size_t frames, bool full, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
