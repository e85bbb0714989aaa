#ifndef TETRACONE_EXPERIMENTS_CLI_CCD_COMMAND_H
#define TETRACONE_EXPERIMENTS_CLI_CCD_COMMAND_H

#include <CLI/CLI.hpp>

namespace tetracone::experiments {

/// Adds `tetracone ccd QUERIES.csv...`: whether a moving vertex and face, or two moving edges, meet: 1 or 0, a line a
/// query. Exact. Throws CLI::RuntimeError(1) where a file says otherwise, covering::Input_error for bad input.
void add_ccd_command(CLI::App& app);

}  // namespace tetracone::experiments

#endif
