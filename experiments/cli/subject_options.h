#ifndef TETRACONE_EXPERIMENTS_CLI_SUBJECT_OPTIONS_H
#define TETRACONE_EXPERIMENTS_CLI_SUBJECT_OPTIONS_H

#include "verify/subjects/object_subject.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <string>
#include <vector>

namespace tetracone::experiments {

/// The options by which `verify`, `fuzz`, `collide` and `experiment` accept external methods.
struct Subject_options {
  std::vector<std::string> commands;  ///< NAME=COMMAND
  double limit = 10;                  ///< seconds for an answer

  std::chrono::milliseconds limit_ms() const { return std::chrono::milliseconds(long(limit * 1000)); }
};

/// Adds `--subject-command` and `--subject-limit`.
void add_subject_options(CLI::App& command, Subject_options& options);

/// Returns the subjects of `--subject-command`; each program was started once and asked one question. Their digest is
/// the hash of the programs and scripts that their commands name. Throws CLI::ValidationError for an invalid name, for
/// a command that the shell cannot run, and for a limit that is no number. It also throws it for a name that is given
/// twice, is "truth", or is the first word of a name in `others`.
std::vector<verify::Object_subject> command_subjects(const Subject_options& options,
                                                     const std::vector<verify::Object_subject>& others);

/// Returns the names of all families of cases, of all levels.
std::vector<std::string> family_names();

/// Throws CLI::ValidationError for a name of no family, with the list of all.
[[noreturn]] void refuse_family(const std::string& name);

}  // namespace tetracone::experiments

#endif
