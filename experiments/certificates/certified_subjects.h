#ifndef TETRACONE_EXPERIMENTS_CERTIFICATES_CERTIFIED_SUBJECTS_H
#define TETRACONE_EXPERIMENTS_CERTIFICATES_CERTIFIED_SUBJECTS_H

#include "verify/subjects/object_subject.h"
#include "verify/subjects/probe_subject.h"

namespace tetracone::experiments {

/// The subjects "certified tree" of campaigns: the library's default answers, each with its certificate, which the
/// checker of experiments/certificates/ proves. An answer without a proof, and a certificate that is refused, is a
/// failure. Each running subject has a checker of its own, a process of /usr/bin/python3.
verify::Object_subject certified_objects();  ///< of collisions and distances
verify::Point_subject certified_points();    ///< of points inside, on the surface and outside
verify::Ray_subject certified_rays();        ///< of first hits

}  // namespace tetracone::experiments

#endif
