#ifndef TETRACONE_EXPERIMENTS_SPEED_THREADS_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_SPEED_THREADS_EXPERIMENT_H

#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// Measures the queries per second that 1, 2, 4 ... threads make on the same two bodies, up to twice the number of
/// processors. The bodies are fresh ones, whose nodes are built on demand, and warm ones. The poses of a contour
/// trajectory are dealt out in turn. It also measures how fast the threads build bodies of 70,000 and 700,000 triangles
/// with all nodes, per triangle. Writes out/threads.csv and prints it as a table.
void run_threads(const std::filesystem::path& out, int frames, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
