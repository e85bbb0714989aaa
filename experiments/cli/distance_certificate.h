#ifndef TETRACONE_EXPERIMENTS_CLI_DISTANCE_CERTIFICATE_H
#define TETRACONE_EXPERIMENTS_CLI_DISTANCE_CERTIFICATE_H

#include "experiments/support/scene_options.h"
#include "tetracone/kernel/predicate/question.h"

#include <string>

namespace tetracone::experiments {

/// JSON from which experiments/support/check_certificate.py proves the distance of each pair of poses: both bodies, their
/// faces as triangles, the two nearest points with what holds them, and parts of both that are at least as far apart
/// along a direction each, which together have every pair of triangles. Throws Error for faces that cannot be
/// triangulated without new vertices.
std::string distance_certificate(const covering::Polyhedron& a, const covering::Polyhedron& b, const Pose_pairs& poses,
                                 kernel::Question question);

}  // namespace tetracone::experiments

#endif
