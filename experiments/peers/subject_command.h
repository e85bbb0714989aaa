#ifndef TETRACONE_EXPERIMENTS_PEERS_SUBJECT_COMMAND_H
#define TETRACONE_EXPERIMENTS_PEERS_SUBJECT_COMMAND_H

#include "verify/subjects/object_subject.h"

#include <chrono>
#include <string>

namespace tetracone::experiments {

/// How long a program may take to start, besides the limit of its first question, until it has once shown to need less.
constexpr std::chrono::seconds longest_start{30};

/// Somebody else's method as a subject: `command`, a command of the shell that speaks the subject protocol
/// (experiments/subjects/README.md), is started for each one that answers, when it is first asked. An end, a wrong
/// line, or no line within `limit` of a question, the announcing of its bodies included, is `Outcome::failed`, and the
/// next question starts it anew; a declined question is `Outcome::not_asked`. Any pose and any polyhedron is asked.
verify::Object_subject subject_command(const std::string& name, const std::string& command,
                                       std::chrono::milliseconds limit);

/// Throws std::runtime_error when the shell cannot run the command: it is asked one question and ends with status 126
/// or 127. What else it does is for the campaign to count.
void require_command(const std::string& command, std::chrono::milliseconds limit);

}  // namespace tetracone::experiments

#endif
