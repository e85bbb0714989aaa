#ifndef TETRACONE_EXPERIMENTS_SPEED_PEERS_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_SPEED_PEERS_EXPERIMENT_H

#include "experiments/speed/race_rows.h"

namespace tetracone::experiments {

/// How fast are the fast tree and the paper's against FCL, CGAL, Bullet and ODE, in one run, poses shared and answers
/// counted? Real meshes and generated ones on both trajectories at relative sizes 1:1 and 1:8, and near contact that is
/// degenerate. Writes out/peers.csv, out/peers.svg and .pdf, and prints the means. `full`: 70000 triangles too.
void run_peers(const Race_options& options);

}  // namespace tetracone::experiments

#endif
