#ifndef TETRACONE_EXPERIMENTS_SPEED_TRAJECTORY_H
#define TETRACONE_EXPERIMENTS_SPEED_TRAJECTORY_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/pose.h"

#include <cstdint>
#include <functional>
#include <vector>

/// The trajectories of the paper's time study (JS08 section 4). A stays in its own frame; B moves, scaled to 1 /
/// `ratio` and by default turning. The scale is in B's pose, whose matrix is (1 / ratio) times a rotation.
///
/// Both reach the paper's fraction of colliding frames by trial. The caller decides whether a pose collides, which
/// should mean that the surfaces meet. Equal answers give equal poses on every machine. Both require ratio > 0 (a power
/// of two scales exactly), frames >= 1, and polyhedra of about equal radius.
namespace tetracone::experiments {

/// True when A collides with B in this pose. A fast kernel in double is enough: a wrong answer changes the number of
/// colliding frames by one.
using Collides = std::function<bool(const kernel::Pose&)>;

/// Whether B turns about itself on its path: twice round. The paper does not state whether its moving object does.
enum class Turning { yes, no };

/// Returns one turn round a circle in a random plane through A's centroid, with each frame moved by up to 2 % of A's
/// radius. The circle is the largest found on which 3 % to 4.5 % of the frames collide. If no whole number of frames is
/// in that range, it is the largest number under 5 %; it is never 5 % or more. If no circle achieves it (B so small
/// that it never meets A's surface), none collides. Calls `collides` some 10 to 30 times per frame, mostly far away.
std::vector<kernel::Pose> circular_trajectory(const covering::Polyhedron& a, const covering::Polyhedron& b,
                                              double ratio, int frames, std::uint64_t seed, const Collides& collides,
                                              Turning turning = Turning::yes);

/// Returns poses close to A's border all along. B stands on a spiral of directions over the sphere about A's centroid.
/// Along each direction steps and bisection bring it to touch from outside. Then it is moved out by a small distance,
/// equal in all frames, and by a random translation. The translation is up to 1.6 % (ratio 1) to 0.8 % (large ratios)
/// of A's radius. The distance is about two thirds of that: 5.5 % to 9.5 % of the frames collide then. If no whole
/// number of frames is in that range, it is the number nearest to 7.5 %. Where B reaches A's centroid without touching
/// (through a tunnel), it keeps the distance of the frame before. Calls `collides` some 15 to 40 times per frame.
std::vector<kernel::Pose> contour_trajectory(const covering::Polyhedron& a, const covering::Polyhedron& b, double ratio,
                                             int frames, std::uint64_t seed, const Collides& collides,
                                             Turning turning = Turning::yes);

/// Returns a smooth walk: one turn round A on a wave over the sphere of directions, without jitter, as bodies move in
/// time. In each of some hundred directions B keeps a clearance from touching of at least `clearance` times A's radius.
/// Where the contour is steep it keeps farther away, so that its radial steps are no steeper than its steps around A.
/// Poses of more frames lie on the same path. Calls `collides` some 10 to 30 times per direction.
std::vector<kernel::Pose> smooth_walk(const covering::Polyhedron& a, const covering::Polyhedron& b, double ratio,
                                      int frames, double clearance, std::uint64_t seed, const Collides& collides);

/// Returns B's mean motion from one frame to the next. It is the largest motion of a corner of its bounding box, as a
/// fraction of A's largest extent. Requires two poses.
double mean_motion(const covering::Polyhedron& a, const covering::Polyhedron& b,
                   const std::vector<kernel::Pose>& poses);

}  // namespace tetracone::experiments

#endif
