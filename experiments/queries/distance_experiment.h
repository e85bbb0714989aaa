#ifndef TETRACONE_EXPERIMENTS_QUERIES_DISTANCE_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_QUERIES_DISTANCE_EXPERIMENT_H

#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// Measures the cost and the error of a distance: the fast tree, exact and in double, against FCL's trees in one run.
/// The bodies are a star-shaped body against itself on both trajectories, of about 7000 triangles and, with `full`,
/// 70000; and cubes that touch or are 2^-k apart. It also asks whether bodies are within a tenth of their size. Writes
/// out/distance.csv, one row per subject and trajectory.
void run_distance(const std::filesystem::path& out, int frames, bool full, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
