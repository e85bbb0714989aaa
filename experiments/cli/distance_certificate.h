#ifndef TETRACONE_EXPERIMENTS_CLI_DISTANCE_CERTIFICATE_H
#define TETRACONE_EXPERIMENTS_CLI_DISTANCE_CERTIFICATE_H

#include "experiments/support/scene_options.h"
#include "tetracone/kernel/predicate/question.h"

#include <string>

namespace tetracone::experiments {

/// Returns JSON from which experiments/support/check_certificate.py proves the distance of each pair of poses. It holds
/// both bodies with their faces as triangles, and the two nearest points with the features that contain them. It also
/// holds pairs of parts, each with a direction along which they are at least as far apart; together the parts cover
/// every pair of triangles. Throws Error for faces that cannot be triangulated without new vertices.
std::string distance_certificate(const covering::Polyhedron& a, const covering::Polyhedron& b, const Pose_pairs& poses,
                                 kernel::Question question);

}  // namespace tetracone::experiments

#endif
