#ifndef TETRACONE_EXPERIMENTS_CLI_COLLIDE_COMMAND_H
#define TETRACONE_EXPERIMENTS_CLI_COLLIDE_COMMAND_H

#include <CLI/CLI.hpp>

namespace tetracone::experiments {

/// Adds `tetracone collide A B` and `tetracone collide X.case.json`: whether two models, or the bodies of a case file,
/// collide, one answer a pose. Throws covering::Input_error for bad input and CLI::ValidationError for options that do
/// not go together.
void add_collide_command(CLI::App& app);

}  // namespace tetracone::experiments

#endif
