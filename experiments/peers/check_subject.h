#ifndef TETRACONE_EXPERIMENTS_PEERS_CHECK_SUBJECT_H
#define TETRACONE_EXPERIMENTS_PEERS_CHECK_SUBJECT_H

#include <chrono>
#include <ostream>
#include <string>

namespace tetracone::experiments {

/// Whether the command's program follows the subject protocol (experiments/subjects/README.md), by talks with it of
/// some questions each, whose right answers are clear. Writes a line a talk: `ok` or `WRONG`, and what was expected.
/// Each answer must come within `limit`; all takes at most a minute. Throws std::runtime_error when no process can be
/// started.
bool check_subject(const std::string& command, std::chrono::milliseconds limit, std::ostream& out);

}  // namespace tetracone::experiments

#endif
