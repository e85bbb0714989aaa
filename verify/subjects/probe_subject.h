#ifndef TETRACONE_VERIFY_SUBJECTS_PROBE_SUBJECT_H
#define TETRACONE_VERIFY_SUBJECTS_PROBE_SUBJECT_H

#include "tetracone/tetratree/ray_hit.h"
#include "verify/cases/probe_case.h"
#include "verify/subjects/running.h"

#include <optional>
#include <vector>

namespace tetracone::verify {

using tetratree::Ray_hit;

/// 1 inside, 0 on the surface, -1 outside. Requires a closed body.
using Running_points = Running<Probe_case, int>;
using Point_subject = Subject_of<Running_points>;

/// The hits of a ray. Requires a direction that is not 0.
struct Ray_answer {
  std::optional<Ray_hit> first;
  std::vector<Ray_hit> all;
  bool is_first_t = false;  ///< it knows the `t` of the first hit and no more
};
using Running_rays = Running<Probe_case, Ray_answer>;
using Ray_subject = Subject_of<Running_rays>;

/// Subjects for points: the library's `Body::inside` of bodies triangulated, whole and placed by fractions; and JS08's
/// signed sums over the whole covering by some kernels.
std::vector<Point_subject> point_subjects();

/// Subjects for rays: the library's `Body::hits` and `first_hit` of bodies triangulated and whole. In double there is
/// also the field's usual test of each triangle by Moeller and Trumbore.
std::vector<Ray_subject> ray_subjects();

}  // namespace tetracone::verify

#endif
