#ifndef TETRACONE_EXPERIMENTS_SPEED_ABLATION_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_SPEED_ABLATION_EXPERIMENT_H

#include "experiments/speed/race_rows.h"

namespace tetracone::experiments {

/// Measures the cost of each choice of JS08: the paper's tree in double with one choice changed at a time, and in steps
/// from the paper's listing to the fast tree. The objects are star-shaped ones of 760 triangles and others of 7172,
/// with FCL in the same run. Writes out/ablation.csv, out/ablation.svg and .pdf, and prints the table of steps. `full`:
/// all poses on the large objects.
void run_ablation(const Race_options& options);

}  // namespace tetracone::experiments

#endif
