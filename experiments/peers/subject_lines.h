#ifndef TETRACONE_EXPERIMENTS_PEERS_SUBJECT_LINES_H
#define TETRACONE_EXPERIMENTS_PEERS_SUBJECT_LINES_H

#include "experiments/peers/command_process.h"
#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/question.h"
#include "verify/cases/case.h"
#include "verify/subjects/object_subject.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// The lines of the subject protocol, experiments/subjects/README.md: one JSON object each. Numbers are shortest
/// decimals of doubles; other rationals are strings "n/d".
namespace tetracone::experiments::subject_lines {

/// What a subject says of itself before it answers. What it does not say is the widest: it may be asked all.
struct Hello {
  std::string text;                    ///< the line
  std::string bodies = "any";          ///< "convex", "manifold", "closed" or "any"
  std::vector<std::string> questions;  ///< "surface", "solid"; none: both
  bool is_rigid = false;               ///< it takes rigid poses alone
  bool takes_batches = false;

  bool takes(kernel::Question question) const;
  bool takes(const kernel::Pose& pose) const;

  /// Convexity is decided exactly, for bodies of at most 1000 faces; larger ones are not taken for convex.
  bool takes(const covering::Polyhedron& body) const;
};

/// Returns the contents of a hello; nothing for another line.
std::optional<Hello> read_hello(const std::string& line);

/// Returns the next line that begins with `{`; nothing when the child ends or the deadline passes first. The others,
/// which libraries print, are counted in `skipped`.
std::optional<std::string> next_object(Command_process& process, Command_process::Deadline deadline,
                                       std::uint64_t& skipped);

/// Returns the quaternion (w, x, y, z) and the translation of a pose whose matrix is a rotation to 1e-12, each rounded
/// to double. Returns nothing for another pose.
std::optional<std::array<double, 7>> rigid_motion(const kernel::Pose& pose);

/// Returns a line to the subject, including its end. A body that cannot be triangulated has no triangles.
std::string model(std::uint64_t number, const covering::Polyhedron& body);
std::string forget(std::uint64_t number);
std::string ask(std::uint64_t ask, std::uint64_t a, std::uint64_t b, const kernel::Pose& pose_a,
                const kernel::Pose& pose_b, kernel::Question question);

/// Returns one line of several asks, each a line of `ask`.
std::string batch(const std::vector<std::string>& asks);

/// The contents of a line from the subject.
struct Reply {
  std::optional<verify::Outcome> outcome;  ///< yes, no, or not_asked where it declines; nothing for a wrong line
  std::string wrong;                       ///< what is wrong with the line, and what was expected
  std::optional<std::uint64_t> ns;         ///< the time that it says it took; what is no number from 0 is none
};

/// Reads the line that answers the question with the number `ask`.
Reply read(const std::string& line, std::uint64_t ask);

/// Reads the line that answers a batch of the asks from `first` on; one reply each. A wrong line is one wrong reply.
std::vector<Reply> read_batch(const std::string& line, std::uint64_t first, std::size_t count);

}  // namespace tetracone::experiments::subject_lines

#endif
