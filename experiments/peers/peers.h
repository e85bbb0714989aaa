#ifndef TETRACONE_EXPERIMENTS_PEERS_PEERS_H
#define TETRACONE_EXPERIMENTS_PEERS_PEERS_H

#include "verify/subjects/moving_bodies_subject.h"
#include "verify/subjects/object_subject.h"

#include <chrono>
#include <string>
#include <vector>

namespace tetracone::experiments {

/// Returns every peer of this build as a subject of a campaign. For each one, `program` (the path of this program) is
/// started as `program peer-worker NAME` at the first question. A peer's failure stays in its own process: a crash, an
/// exception, or no answer within 10 seconds is `Outcome::failed`, and the next question restarts it. A peer is not
/// asked about a pose that is not rigid or has a fraction that no double equals. Nor is it asked about a body of more
/// than 30,000 faces, or one that it does not take. A peer of solids is not asked about surfaces. Times are the peer's
/// own, without the pipe. A question throws std::runtime_error when `program` cannot be started, or is not ready within
/// 30 seconds.
std::vector<verify::Object_subject> peer_subjects(const std::string& program);

/// Returns the peer of this name, with this time limit for one question, including the building of its trees. The
/// worker also knows the tests' peers `crash` and `hang`; for any other name it cannot be started.
verify::Object_subject peer_subject(const std::string& program, const std::string& name,
                                    std::chrono::milliseconds limit = std::chrono::seconds(10));

/// Returns every motion peer of this build, run likewise, and about bodies of any number of faces. They are asked about
/// surfaces only, where A rests in its model's coordinates and B is shifted by doubles. A time outside [0, 1] is
/// `Outcome::failed`.
std::vector<verify::Moving_bodies_subject> motion_peer_subjects(const std::string& program);

}  // namespace tetracone::experiments

#endif
