#ifndef TETRACONE_EXPERIMENTS_SPEED_ABLATION_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_SPEED_ABLATION_EXPERIMENT_H

#include "experiments/speed/race_rows.h"

namespace tetracone::experiments {

/// What does each choice of JS08 cost? The paper's tree in double, one choice changed at a time, and step by step from
/// the paper's listing to the fast tree, on star-shaped objects of 760 triangles and on objects of 7172 that are not,
/// with FCL in the same run. Writes out/ablation.csv, out/ablation.svg and .pdf, and prints the table of steps. `full`:
/// all poses on the large objects.
void run_ablation(const Race_options& options);

}  // namespace tetracone::experiments

#endif
