#ifndef TETRACONE_EXPERIMENTS_CLI_VERIFY_COMMAND_H
#define TETRACONE_EXPERIMENTS_CLI_VERIFY_COMMAND_H

#include <CLI/CLI.hpp>

namespace tetracone::experiments {

/// `tetracone verify`: a campaign, and `tetracone merge`: several databases into one.
void add_verify_command(CLI::App& app);
void add_merge_command(CLI::App& app);

}  // namespace tetracone::experiments

#endif
