#ifndef TETRACONE_EXPERIMENTS_ACCURACY_ERROR_BOUNDS_H
#define TETRACONE_EXPERIMENTS_ACCURACY_ERROR_BOUNDS_H

#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// Lists every constant of an error bound with its value in the code, the value that is proved to be enough, and the
/// worst error that hill climbing of `steps` steps finds, or why no search exists. Writes OUT/error_bounds.csv, one row
/// per constant. Requires Gappa; throws std::runtime_error without it, covering::Input_error when `out` cannot be
/// written.
void run_error_bounds(const std::filesystem::path& out, int steps, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
