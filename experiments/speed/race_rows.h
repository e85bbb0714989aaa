#ifndef TETRACONE_EXPERIMENTS_SPEED_RACE_ROWS_H
#define TETRACONE_EXPERIMENTS_SPEED_RACE_ROWS_H

#include "experiments/speed/race.h"
#include "experiments/support/experiment_options.h"

namespace tetracone::experiments {

/// Runs these contestants on the course and compares the others with the first. Returns a CSV with its header: a row
/// for each question and each contestant that takes it. The questions are surface and, when `solid`, solid. A row has
/// times, answers judged by the truth (which is saved under out/truth), build, memory and counts.
std::string race_rows(const Race_course& course, const std::vector<Contestant>& contestants, bool solid, int passes,
                      double seconds, const Experiment_options& options);

}  // namespace tetracone::experiments

#endif
