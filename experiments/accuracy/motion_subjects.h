#ifndef TETRACONE_EXPERIMENTS_ACCURACY_MOTION_SUBJECTS_H
#define TETRACONE_EXPERIMENTS_ACCURACY_MOTION_SUBJECTS_H

#include "tetracone/kernel/motion/moving_pair.h"

#include <span>
#include <string_view>

namespace tetracone::experiments {

/// A method that decides whether a moving vertex and face, or two moving edges, meet.
struct Motion_subject {
  std::string_view name, what;
  bool (*meet)(const kernel::Moving_pair& pair);
};

/// Returns our method and those of the field, written from their descriptions:
///  - adaptive: ours, `kernel::meet_in_motion`, which is exact;
///  - double, float: the roots of the volume in [0, 1], then barycentric coordinates at each, as Provot (1997)
///    proposed;
///  - tolerance: as double, with a slack of 1e-6 in barycentric coordinates. Contact within a distance of 1e-6 is also
///    tested at the ends and extrema of the volume. See Bridson, Fedkiw, Anderson, "Robust Treatment of Collisions",
///    2002;
///  - root-parity: Brochu, Edwards, Bridson, "Efficient Geometrically Exact Continuous Collision Detection", 2012: the
///    parity of a ray's crossings with the boundary of the image of the domain. It computes in rationals throughout,
///    where the published method filters: it has that method's answers, not its speed;
///  - inclusion: Wang et al., "A Large Scale Benchmark and an Inclusion-Based Algorithm for Continuous Collision
///    Detection", 2021. It bisects the domain, with boxes of the image grown by rounding. A box of at most 1e-6 about
///    the origin is a contact, and so is a pair that 2^15 boxes have not decided.
std::span<const Motion_subject> motion_subjects();

/// True when the moving primitives meet an odd number of times, by Brochu, Edwards and Bridson (2012). The differences
/// of their points, over time and both primitives' parameters, form a body whose boundary consists of triangles and
/// bilinear patches. A ray from the origin crosses it an odd number of times if an odd number of roots is within. An
/// origin on the boundary is a contact. It computes in rationals, without rounding. It does not notice an even number
/// of contacts.
bool meet_by_root_parity(const kernel::Moving_pair& pair);

}  // namespace tetracone::experiments

#endif
