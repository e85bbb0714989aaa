#ifndef TETRACONE_EXPERIMENTS_CLI_SAVE_COMMAND_H
#define TETRACONE_EXPERIMENTS_CLI_SAVE_COMMAND_H

#include <CLI/CLI.hpp>

namespace tetracone::experiments {

/// Adds `tetracone save MODEL --out FILE.body`: the model with its tree, to be taken wherever a model is. Throws
/// covering::Input_error for bad input, and for a file that cannot be written.
void add_save_command(CLI::App& app);

}  // namespace tetracone::experiments

#endif
