#ifndef TETRACONE_EXPERIMENTS_SPEED_TRAJECTORY_H
#define TETRACONE_EXPERIMENTS_SPEED_TRAJECTORY_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/pose.h"

#include <cstdint>
#include <functional>
#include <vector>

/// The trajectories of the paper's time study (JS08 section 4): A stays in its own frame, B moves, scaled to 1 /
/// `ratio` and, where not told otherwise, turning. The scale is in B's pose, whose matrix is (1 / ratio) times a
/// rotation.
///
/// Both keep to the paper's share of frames that collide by trial: the caller says whether a pose collides, which
/// should mean that the surfaces meet. With the same answers the poses are the same on every machine. Both require
/// ratio > 0 (a power of two scales exactly), frames >= 1, and polyhedra of about the same radius.
namespace tetracone::experiments {

/// Whether A collides with B in this pose. A fast kernel in double will do: a wrong answer shifts the share by a frame.
using Collides = std::function<bool(const kernel::Pose&)>;

/// Whether B turns about itself on its way: twice round. The paper does not say whether its moving object does.
enum class Turning { yes, no };

/// Once round a circle in a random plane through A's centroid, each frame moved by up to 2 % of A's radius. The
/// circle is the largest found on which 3 % to 4.5 % of the frames collide; where no whole number of frames is in
/// that range, the largest number under 5 %. Never 5 % or more. Where no circle does it (B so small that it never
/// meets A's surface), none collides. Asks some 10 to 30 times a frame, mostly far away.
std::vector<kernel::Pose> circular_trajectory(const covering::Polyhedron& a, const covering::Polyhedron& b,
                                              double ratio, int frames, std::uint64_t seed, const Collides& collides,
                                              Turning turning = Turning::yes);

/// Close to A's border all the way: B stands on a spiral of directions over the sphere about A's centroid; along each
/// it is brought to touch from outside, by steps and bisection, then moved out again by a small distance, the same
/// for all frames, and by a random translation of up to 1.6 % (ratio 1) to 0.8 % (large ratios) of A's radius. The
/// distance, about two thirds of that, is the one with which 5.5 % to 9.5 % of the frames collide; where no whole
/// number of frames is in that range, the nearest to 7.5 %. Where B reaches A's centroid without touching (through a
/// tunnel), it keeps the distance of the frame before. Asks some 15 to 40 times a frame.
std::vector<kernel::Pose> contour_trajectory(const covering::Polyhedron& a, const covering::Polyhedron& b, double ratio,
                                             int frames, std::uint64_t seed, const Collides& collides,
                                             Turning turning = Turning::yes);

/// Returns a smooth walk: one turn round A on a wave over the sphere of directions, without jitter, as bodies move in
/// time. In each of some hundred directions B keeps a clearance from touching of at least `clearance` times A's radius.
/// Where the contour is steep it keeps farther away, so that its radial steps are no steeper than its steps around A.
/// Poses of more frames lie on the same path. Calls `collides` some 10 to 30 times per direction.
std::vector<kernel::Pose> smooth_walk(const covering::Polyhedron& a, const covering::Polyhedron& b, double ratio,
                                      int frames, double clearance, std::uint64_t seed, const Collides& collides);

/// The mean of how far B moves from one frame to the next, the farthest moved corner of its bounding box, as a share of
/// A's largest extent. Requires two poses.
double mean_motion(const covering::Polyhedron& a, const covering::Polyhedron& b,
                   const std::vector<kernel::Pose>& poses);

}  // namespace tetracone::experiments

#endif
