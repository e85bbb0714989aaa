#ifndef TETRACONE_EXPERIMENTS_CLI_INSIDE_COMMAND_H
#define TETRACONE_EXPERIMENTS_CLI_INSIDE_COMMAND_H

#include <CLI/CLI.hpp>

namespace tetracone::experiments {

/// Adds `tetracone inside MODEL POINTS`: 1 inside, 0 on the surface, -1 outside, a line a point. Exact. Throws
/// covering::Input_error for bad input.
void add_inside_command(CLI::App& app);

}  // namespace tetracone::experiments

#endif
