#ifndef TETRACONE_EXPERIMENTS_PEERS_CHECK_SUBJECT_H
#define TETRACONE_EXPERIMENTS_PEERS_CHECK_SUBJECT_H

#include <chrono>
#include <ostream>
#include <string>

namespace tetracone::experiments {

/// True when the command's program follows the subject protocol (experiments/subjects/README.md). The function holds
/// talks with the program, of a few questions each, whose right answers are clear. They are about surfaces, or about
/// solids where the program declines surfaces; one talk is about both. A declined question counts as right.
///
/// The function writes to `out` one line per talk: `ok` and its name, or `WRONG`, its name, what is wrong and what was
/// expected. It stops after the first talk if that has no answer. If no talk was wrong, lines say what the program
/// takes. Last come the number of skipped lines, if any, and the verdict. Each answer must come within `limit`, the
/// first of a process within three times that. All talks take at most a minute. Throws std::runtime_error when no
/// process can be started.
bool check_subject(const std::string& command, std::chrono::milliseconds limit, std::ostream& out);

}  // namespace tetracone::experiments

#endif
