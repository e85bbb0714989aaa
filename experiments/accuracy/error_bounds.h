#ifndef TETRACONE_EXPERIMENTS_ACCURACY_ERROR_BOUNDS_H
#define TETRACONE_EXPERIMENTS_ACCURACY_ERROR_BOUNDS_H

#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// Every constant of an error bound: what the code has, what is proved to be enough, and the worst that hill climbing
/// of so many steps finds, or why nothing looks for it. Writes OUT/error_bounds.csv, a row a constant. Requires Gappa;
/// throws std::runtime_error without it, covering::Input_error when `out` cannot be written.
void run_error_bounds(const std::filesystem::path& out, int steps, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
