#ifndef TETRACONE_EXPERIMENTS_QUERIES_MOVING_BODIES_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_QUERIES_MOVING_BODIES_EXPERIMENT_H

#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// Measures the cost of the exact first contact of two moving bodies, in static questions of the same tree. It also
/// counts the contacts that static questions at 10, 100 and 1000 times miss, and those that FCL's continuousCollide
/// misses. The motions are steps of the contour trajectory and of the circular one, and throws through a body and
/// through a thin plate. B moves, `motions` times each. Our own first contacts are the truth; tests judge them. Writes
/// OUT/moving_bodies.csv, one row per course and subject. It also measures a face that lands flat on a face against the
/// same motion tilted by a thousandth. Writes OUT/landings.csv, one row per pair of bodies and motion. Throws
/// covering::Input_error when `out` cannot be written.
void run_moving_bodies(const std::filesystem::path& out, int motions, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
