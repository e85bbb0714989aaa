#ifndef TETRACONE_EXPERIMENTS_QUERIES_MOVING_BODIES_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_QUERIES_MOVING_BODIES_EXPERIMENT_H

#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// What does the exact first contact of two moving bodies cost, in static questions of the same tree, and which contacts
/// do static questions at 10, 100 and 1000 times and FCL's continuousCollide miss? Steps of the contour trajectory and of
/// the circular one, and throws through a body and through a thin plate; B moves, `motions` times each. Our own first
/// contacts are the truth, which tests judge. Writes OUT/moving_bodies.csv, a row a course and subject. And what does a
/// face cost that lands flat on a face, beside the same motion tilted by a thousandth? Writes OUT/landings.csv, a row a
/// pair of bodies and motion. Throws covering::Input_error when `out` cannot be written.
void run_moving_bodies(const std::filesystem::path& out, int motions, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
