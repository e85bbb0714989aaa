#ifndef TETRACONE_EXPERIMENTS_CLI_CHECK_COMMAND_H
#define TETRACONE_EXPERIMENTS_CLI_CHECK_COMMAND_H

#include <CLI/CLI.hpp>

namespace tetracone::experiments {

/// Adds `tetracone check MODEL...`: what each model is. Throws CLI::RuntimeError(1) when one is no closed polyhedron,
/// and with --strict when one has a face that is not exactly planar; covering::Input_error for an unreadable file.
void add_check_command(CLI::App& app);

}  // namespace tetracone::experiments

#endif
