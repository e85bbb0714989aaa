#ifndef TETRACONE_EXPERIMENTS_SCENES_DEMAND_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_SCENES_DEMAND_EXPERIMENT_H

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// Measures the fraction of all nodes and tables that the frames of a scene need. 200 bodies of 7000 triangles, each
/// with its own model, are drawn to the middle, so that ever more come near one another. Two scenes play the same
/// frames: one builds on demand, the other builds its trees first. Writes out/demand.csv, one row per frame, with the
/// totals of nodes, questions and time so far.
void run_demand(const std::filesystem::path& out, std::size_t frames, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
