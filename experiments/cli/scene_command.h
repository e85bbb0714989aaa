#ifndef TETRACONE_EXPERIMENTS_CLI_SCENE_COMMAND_H
#define TETRACONE_EXPERIMENTS_CLI_SCENE_COMMAND_H

#include <CLI/CLI.hpp>

namespace tetracone::experiments {

/// Adds `tetracone scene FILE`: the colliding pairs of many bodies, frame after frame. Throws covering::Input_error for
/// bad input.
void add_scene_command(CLI::App& app);

}  // namespace tetracone::experiments

#endif
