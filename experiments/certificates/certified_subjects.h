#ifndef TETRACONE_EXPERIMENTS_CERTIFICATES_CERTIFIED_SUBJECTS_H
#define TETRACONE_EXPERIMENTS_CERTIFICATES_CERTIFIED_SUBJECTS_H

#include "verify/subjects/moving_bodies_subject.h"
#include "verify/subjects/object_subject.h"
#include "verify/subjects/probe_subject.h"

#include <cstdint>
#include <string>

namespace tetracone::experiments {

/// The subjects "certified tree" of campaigns: the library's default answers, each with its certificate, which the
/// checker of experiments/certificates/ proves. An answer fails when the checker refuses its certificate or takes
/// longer than a minute. Relations, exits, depths and motions may have no proof, which is counted. `certified_objects`
/// is not asked about bodies of more than `verify::most_faces` faces. Each running subject has a checker of its own: a
/// process of /usr/bin/python3, or of the program that the environment variable TETRACONE_CHECKER names.
verify::Object_subject certified_objects();         ///< of collisions, distances, `within`, relations, exits, depths
verify::Point_subject certified_points();           ///< of points inside, on the surface and outside
verify::Ray_subject certified_rays();               ///< of first hits
verify::Moving_bodies_subject certified_motions();  ///< of first contacts

/// Returns a CSV of the costs of all certificates of this process so far, one row per kind of answer; empty if there
/// were none. `made_ns` is the mean of all answers, in nanoseconds. It includes answering for collisions, distances,
/// `within`, points and rays. `checked_ns` and `bytes_mean` are means of those that have a proof, and `bytes_most` is
/// their largest. `seed` is the campaign's. Thread-safe.
std::string certificate_costs(std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
