#ifndef TETRACONE_EXPERIMENTS_CLI_REPORT_COMMAND_H
#define TETRACONE_EXPERIMENTS_CLI_REPORT_COMMAND_H

#include <CLI/CLI.hpp>

namespace tetracone::experiments {

/// `tetracone report`: the tables of a campaign's database, what is noted of other libraries and formulations, and the
/// page.
void add_report_command(CLI::App& app);

}  // namespace tetracone::experiments

#endif
