#ifndef TETRACONE_EXPERIMENTS_ACCURACY_STABILITY_H
#define TETRACONE_EXPERIMENTS_ACCURACY_STABILITY_H

#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// The smallest change that matters: a body is moved straight at another, everything under one exact rotation, and
/// between two neighbouring doubles of its way the exact answer changes. Each kernel's own answer changes elsewhere:
/// how many doubles away? Writes OUT/stability.csv, one row for each motion, way and subject: the exact threshold (the
/// last double without contact), and the distance of the subject's, in doubles and in ulps of the threshold. Takes a
/// few seconds for 20 ways a motion. Throws std::logic_error when the truth by brute force denies an exact threshold;
/// covering::Input_error when `out` cannot be written.
void run_stability(const std::filesystem::path& out, int ways, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
