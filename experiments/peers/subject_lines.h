#ifndef TETRACONE_EXPERIMENTS_PEERS_SUBJECT_LINES_H
#define TETRACONE_EXPERIMENTS_PEERS_SUBJECT_LINES_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/question.h"
#include "verify/subjects/object_subject.h"

#include <cstdint>
#include <optional>
#include <string>

/// The lines of the subject protocol, experiments/subjects/README.md: one JSON object each. Numbers are shortest
/// decimals of doubles; other rationals are strings "n/d".
namespace tetracone::experiments::subject_lines {

/// Returns a line to the subject, including its end.
std::string model(std::uint64_t number, const covering::Polyhedron& body);
std::string forget(std::uint64_t number);
std::string ask(std::uint64_t ask, std::uint64_t a, std::uint64_t b, const kernel::Pose& pose_a,
                const kernel::Pose& pose_b, kernel::Question question);

/// The contents of a line from the subject.
struct Reply {
  std::optional<verify::Outcome> outcome;  ///< yes, no, or not_asked where it declines; nothing for a wrong line
  std::string wrong;                       ///< what is wrong with the line, and what was expected
  std::optional<std::uint64_t> ns;         ///< the time that it says it took; what is no number from 0 is none
};

/// Reads the line that answers the question with the number `ask`.
Reply read(const std::string& line, std::uint64_t ask);

}  // namespace tetracone::experiments::subject_lines

#endif
