#ifndef TETRACONE_EXPERIMENTS_CLI_MOTION_COMMAND_H
#define TETRACONE_EXPERIMENTS_CLI_MOTION_COMMAND_H

#include <CLI/CLI.hpp>

namespace tetracone::experiments {

/// Adds `tetracone motion A B`: when two moving models first meet, exactly, a line a motion. Throws covering::Input_error
/// for bad input.
void add_motion_command(CLI::App& app);

}  // namespace tetracone::experiments

#endif
