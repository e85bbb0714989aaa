#ifndef TETRACONE_EXPERIMENTS_CLI_EXPERIMENT_COMMAND_H
#define TETRACONE_EXPERIMENTS_CLI_EXPERIMENT_COMMAND_H

#include <CLI/CLI.hpp>

namespace tetracone::experiments {

/// Adds `tetracone experiment NAME`: one question, its CSV and figure. `--list` names them with their time.
void add_experiment_command(CLI::App& app);

}  // namespace tetracone::experiments

#endif
