#ifndef TETRACONE_EXPERIMENTS_PEERS_PEERS_H
#define TETRACONE_EXPERIMENTS_PEERS_PEERS_H

#include "verify/subjects/moving_bodies_subject.h"
#include "verify/subjects/object_subject.h"

#include <chrono>
#include <string>
#include <vector>

namespace tetracone::experiments {

/// Every peer of this build as a subject of a campaign: `program`, the path of this program, is started for each one
/// that answers as `program peer-worker NAME`, when it is first asked. What the peer gets wrong stays in its process: a
/// crash, an exception, or no answer in 10 seconds is `Outcome::failed`, and the next question starts it again. A pose
/// that is not rigid or has a fraction, which no double is, is not asked, nor are polyhedra that the peer does not take.
/// Times are the peer's own, without the pipe. Throws std::runtime_error when `program` cannot be started.
std::vector<verify::Object_subject> peer_subjects(const std::string& program);

/// The peer of this name, with this limit for one question, the building of its trees included.
verify::Object_subject peer_subject(const std::string& program, const std::string& name,
                                    std::chrono::milliseconds limit = std::chrono::seconds(10));

/// Every peer of motions of this build, likewise: asked of surfaces alone, of bodies of which A rests where its model is
/// and B is shifted by doubles. A time that is not in [0, 1] is `Outcome::failed`.
std::vector<verify::Moving_bodies_subject> motion_peer_subjects(const std::string& program);

}  // namespace tetracone::experiments

#endif
