#ifndef TETRACONE_EXPERIMENTS_CERTIFICATES_CERTIFIED_SUBJECTS_H
#define TETRACONE_EXPERIMENTS_CERTIFICATES_CERTIFIED_SUBJECTS_H

#include "verify/subjects/moving_bodies_subject.h"
#include "verify/subjects/object_subject.h"
#include "verify/subjects/probe_subject.h"

#include <cstdint>
#include <string>

namespace tetracone::experiments {

/// The subjects "certified tree" of campaigns: the library's default answers, each with its certificate, which the
/// checker of experiments/certificates/ proves. A certificate that is refused is a failure. Relations, exits, depths
/// and motions may have no proof, which is counted. Each running subject has a checker of its own: a process of
/// /usr/bin/python3, or of the program that TETRACONE_CHECKER names.
verify::Object_subject certified_objects();         ///< of collisions, distances, relations, exits and depths
verify::Point_subject certified_points();           ///< of points inside, on the surface and outside
verify::Ray_subject certified_rays();               ///< of first hits
verify::Moving_bodies_subject certified_motions();  ///< of first contacts

/// Returns a CSV with what the certificates of this program have cost, a row for each kind of answer; nothing if there
/// were none. Times are means, in nanoseconds. `seed` is that of the campaign.
std::string certificate_costs(std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
