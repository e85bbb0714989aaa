#ifndef TETRACONE_EXPERIMENTS_SCENES_COHERENCE_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_SCENES_COHERENCE_EXPERIMENT_H

#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// What remembering the last pose saves, by how far a body moves from one pose to the next: smooth walks of `frames`
/// poses and 5, 25 and 125 times as many, at some clearances and in contact, asked with memory and without in turn.
/// Writes out/coherence.csv and prints it as a table.
void run_coherence(const std::filesystem::path& out, int frames, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
