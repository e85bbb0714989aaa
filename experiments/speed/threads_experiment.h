#ifndef TETRACONE_EXPERIMENTS_SPEED_THREADS_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_SPEED_THREADS_EXPERIMENT_H

#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// How many queries a second do 1, 2, 4 ... threads make on the same two bodies, up to twice the processors: on fresh
/// bodies, whose nodes are made on the way, and on warm ones? Poses of a contour trajectory, shared out in turn. And how
/// fast do they make bodies of 70,000 and 700,000 triangles, all nodes included, a triangle? Writes out/threads.csv and
/// prints it as a table.
void run_threads(const std::filesystem::path& out, int frames, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
