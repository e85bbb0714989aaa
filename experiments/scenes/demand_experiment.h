#ifndef TETRACONE_EXPERIMENTS_SCENES_DEMAND_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_SCENES_DEMAND_EXPERIMENT_H

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// How much of what could be made the frames of a scene ask for: 200 bodies of 7000 triangles, each of a model of its
/// own, are drawn to the middle, so that more and more come near one another. Two scenes play the same frames, one that
/// makes what is asked and one whose trees are made first. Writes out/demand.csv, a row a frame, of all that has been
/// made, asked and spent up to it.
void run_demand(const std::filesystem::path& out, std::size_t frames, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
