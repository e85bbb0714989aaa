#ifndef TETRACONE_EXPERIMENTS_PEERS_CHECK_SUBJECT_H
#define TETRACONE_EXPERIMENTS_PEERS_CHECK_SUBJECT_H

#include <chrono>
#include <ostream>
#include <string>

namespace tetracone::experiments {

/// True when the command's program follows the subject protocol (experiments/subjects/README.md). The function holds
/// talks with the program, of a few questions each, whose right answers are clear. They are about surfaces, or about
/// solids where the program declines surfaces; one talk is about both. A declined question counts as right. The talks
/// end where the program has answered nothing so far.
///
/// The function writes one line per talk: `ok` or `WRONG`, and the expected answer. Then it writes what the program
/// takes, but only where all talks are `ok`. Each answer must come within `limit`, the first of a process within three
/// times that. All talks take at most a minute. Throws std::runtime_error when no process can be started.
bool check_subject(const std::string& command, std::chrono::milliseconds limit, std::ostream& out);

}  // namespace tetracone::experiments

#endif
