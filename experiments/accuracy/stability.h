#ifndef TETRACONE_EXPERIMENTS_ACCURACY_STABILITY_H
#define TETRACONE_EXPERIMENTS_ACCURACY_STABILITY_H

#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// Measures the smallest change that matters. A body moves straight at another, everything under one exact rotation,
/// and the exact answer changes between two neighbouring doubles of its path. It counts how many doubles away each
/// kernel's own answer changes. Writes OUT/stability.csv, one row for each motion, path and subject: the exact
/// threshold (the last double without contact), and the distance of the subject's threshold, in doubles and in ulps of
/// the exact one. Takes a few seconds for 20 paths per motion. Throws std::logic_error when the truth by brute force
/// denies an exact threshold; covering::Input_error when `out` cannot be written.
void run_stability(const std::filesystem::path& out, int ways, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
