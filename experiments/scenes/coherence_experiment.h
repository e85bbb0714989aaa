#ifndef TETRACONE_EXPERIMENTS_SCENES_COHERENCE_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_SCENES_COHERENCE_EXPERIMENT_H

#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// Measures the gain of remembering the last pose against a body's motion from one pose to the next. Smooth walks of
/// `frames` poses, and of 5, 25 and 125 times as many, at some clearances and in contact, are asked with and without
/// memory in turn. Writes out/coherence.csv and prints it as a table.
void run_coherence(const std::filesystem::path& out, int frames, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
