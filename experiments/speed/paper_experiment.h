#ifndef TETRACONE_EXPERIMENTS_SPEED_PAPER_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_SPEED_PAPER_EXPERIMENT_H

#include "experiments/speed/race_rows.h"

namespace tetracone::experiments {

/// Repeats the claims of JS08 section 4 about the paper's tree other than frames per second, in double. These are the
/// cost and gain of adjusting bounding tetrahedra, the depth that suits a relative size, its effect on the number of
/// tests, and the effect of B's turning. Meshes of the cat's and the horse's size are asked against themselves at
/// relative sizes 1:1 to 1:16. Writes out/paper.csv, out/paper.svg and .pdf, and prints the tables. `full`: every pose
/// for every tree.
void run_paper(const Race_options& options);

}  // namespace tetracone::experiments

#endif
