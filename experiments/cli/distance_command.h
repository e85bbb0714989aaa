#ifndef TETRACONE_EXPERIMENTS_CLI_DISTANCE_COMMAND_H
#define TETRACONE_EXPERIMENTS_CLI_DISTANCE_COMMAND_H

#include <CLI/CLI.hpp>

namespace tetracone::experiments {

/// Adds `tetracone distance A B`: the double nearest to the exact distance, a line a pose. Throws covering::Input_error
/// for bad input.
void add_distance_command(CLI::App& app);

}  // namespace tetracone::experiments

#endif
