#ifndef TETRACONE_EXPERIMENTS_CLI_VIEW_COMMAND_H
#define TETRACONE_EXPERIMENTS_CLI_VIEW_COMMAND_H

#include <CLI/CLI.hpp>

namespace tetracone::experiments {

/// Adds `tetracone view A [B] --out FILE.html` and `tetracone view X.case.json --out FILE.html`: one page in 3D that
/// needs no network and no other file, of the bodies, their poses and answers, and the paper's covering, tree and
/// bounding volumes. Throws covering::Input_error for bad input and CLI::ValidationError for options that do not go
/// together.
void add_view_command(CLI::App& app);

}  // namespace tetracone::experiments

#endif
