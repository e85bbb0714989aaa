#ifndef TETRACONE_EXPERIMENTS_CLI_FUZZ_COMMAND_H
#define TETRACONE_EXPERIMENTS_CLI_FUZZ_COMMAND_H

#include <CLI/CLI.hpp>

namespace tetracone::experiments {

/// Adds `tetracone fuzz`: new wrong answers on fresh and mutated cases of all families, shrunk, each a case file.
/// Throws CLI::RuntimeError(1) when an exact subject was wrong, CLI::ValidationError for an unknown subject,
/// covering::Input_error for a folder that cannot be written.
void add_fuzz_command(CLI::App& app);

}  // namespace tetracone::experiments

#endif
