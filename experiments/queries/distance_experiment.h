#ifndef TETRACONE_EXPERIMENTS_QUERIES_DISTANCE_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_QUERIES_DISTANCE_EXPERIMENT_H

#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// What does a distance cost, and how far off is it? The fast tree, exact and in double, against FCL's trees in one run:
/// a star-shaped body against itself on both trajectories, about 7000 triangles and, `full`, 70000; and cubes that touch
/// or are 2^-k apart. Also the question whether bodies are within a tenth of their size. Writes out/distance.csv, a row a
/// subject and trajectory.
void run_distance(const std::filesystem::path& out, int frames, bool full, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
