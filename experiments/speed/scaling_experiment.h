#ifndef TETRACONE_EXPERIMENTS_SPEED_SCALING_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_SPEED_SCALING_EXPERIMENT_H

#include "experiments/speed/race_rows.h"

namespace tetracone::experiments {

/// Measures how time per query, build and memory grow with the number of triangles, 10^3 to 10^5 (`full`: 10^6), of one
/// geometry in equal poses. It also measures the fraction of the tree that queries build when nodes are built on
/// demand. Writes out/scaling.csv, out/scaling.svg and .pdf, and prints the fitted exponents.
void run_scaling(const Race_options& options);

}  // namespace tetracone::experiments

#endif
