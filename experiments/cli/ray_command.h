#ifndef TETRACONE_EXPERIMENTS_CLI_RAY_COMMAND_H
#define TETRACONE_EXPERIMENTS_CLI_RAY_COMMAND_H

#include <CLI/CLI.hpp>

namespace tetracone::experiments {

/// `tetracone ray`: where rays meet a model's surface.
void add_ray_command(CLI::App& app);

}  // namespace tetracone::experiments

#endif
