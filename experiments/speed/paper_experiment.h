#ifndef TETRACONE_EXPERIMENTS_SPEED_PAPER_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_SPEED_PAPER_EXPERIMENT_H

#include "experiments/speed/race_rows.h"

namespace tetracone::experiments {

/// What JS08 section 4 says of the paper's tree beside frames per second, in double: what adjusting bounding tetrahedra
/// costs and saves, which depth suits a relative size, how the number of tests goes with it, and what it matters that B
/// turns. Meshes of the cat's and the horse's size against themselves at relative sizes 1:1 to 1:16. Writes
/// out/paper.csv, out/paper.svg and .pdf, and prints the tables. `full`: every pose for every tree.
void run_paper(const Race_options& options);

}  // namespace tetracone::experiments

#endif
