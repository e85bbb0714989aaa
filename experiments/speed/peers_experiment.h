#ifndef TETRACONE_EXPERIMENTS_SPEED_PEERS_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_SPEED_PEERS_EXPERIMENT_H

#include "experiments/speed/race_rows.h"

namespace tetracone::experiments {

/// Measures the fast tree and the paper's against FCL, CGAL, Bullet and ODE in one run, with shared poses and judged
/// answers. Real and generated meshes move on both trajectories at relative sizes 1:1 and 1:8, and in degenerate near
/// contact. Writes out/peers.csv, out/peers.svg and .pdf, and prints the means. `full`: also 70000 triangles.
void run_peers(const Race_options& options);

}  // namespace tetracone::experiments

#endif
