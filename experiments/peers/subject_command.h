#ifndef TETRACONE_EXPERIMENTS_PEERS_SUBJECT_COMMAND_H
#define TETRACONE_EXPERIMENTS_PEERS_SUBJECT_COMMAND_H

#include "experiments/peers/subject_lines.h"
#include "verify/subjects/moving_bodies_subject.h"
#include "verify/subjects/predicate_subject.h"
#include "verify/subjects/probe_subject.h"

namespace tetracone::experiments {

/// The time that a program may need to start, besides the limit of its first question. Later starts have less: about
/// twice what a start took, and a quarter after one that failed.
constexpr std::chrono::seconds longest_start{30};

/// Returns an external method as a subject: `command`, a shell command that follows the subject protocol
/// (experiments/subjects/README.md). It is started for each running subject at the first question. It fails by an end,
/// by a wrong line, or by no line within `limit` of a question, the announcement of its bodies included. The next
/// question then restarts it. A declined question is `Outcome::not_asked`. It is asked what its hello takes; without a
/// hello, collisions of any bodies in any poses. After three time-outs in a size class, if it answered fewer questions
/// there, it is asked nothing of that size or larger. A size class has twice the faces of the one before.
verify::Object_subject subject_command(const std::string& name, const std::string& command,
                                       std::chrono::milliseconds limit,
                                       const std::optional<subject_lines::Hello>& hello = std::nullopt);

/// True when the subject's hello names the distance or `within`.
bool tells_distances(const verify::Object_subject& subject);

/// Returns the same program as a subject of points, of rays, or of motions; nothing where its hello does not name
/// these. Motions that turn are not asked. Its answer is one number: a place, or the first t.
std::optional<verify::Point_subject> point_command(const verify::Object_subject& subject,
                                                   std::chrono::milliseconds limit);
std::optional<verify::Ray_subject> ray_command(const verify::Object_subject& subject, std::chrono::milliseconds limit);
std::optional<verify::Moving_bodies_subject> motion_command(const verify::Object_subject& subject,
                                                            std::chrono::milliseconds limit);

/// Returns the same program as a subject of two triangles; nothing where its hello does not name them.
std::optional<verify::Predicate_subject> triangle_command(const verify::Object_subject& subject,
                                                          std::chrono::milliseconds limit);

/// Returns the program's hello, if it begins with one. It asks the program one question. Throws std::runtime_error when
/// no process can be started, and when the shell cannot run the command: that ends with status 126 or 127. The campaign
/// counts any other failure.
std::optional<subject_lines::Hello> require_command(const std::string& command, std::chrono::milliseconds limit);

}  // namespace tetracone::experiments

#endif
