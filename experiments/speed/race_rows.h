#ifndef TETRACONE_EXPERIMENTS_SPEED_RACE_ROWS_H
#define TETRACONE_EXPERIMENTS_SPEED_RACE_ROWS_H

#include "experiments/speed/race.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace tetracone::experiments {

/// What the experiments of speed run on.
struct Race_options {
  std::filesystem::path out = "out";
  std::filesystem::path models;  ///< the folder that fetch_models.sh filled
  int frames = 400;              ///< poses of each trajectory
  bool full = false;             ///< larger objects too
  std::uint64_t seed = 1;
  double seconds = 0;  ///< of processor time after which a contestant rests, in place of each race's own; 0: its own

  double seconds_or(double own) const { return seconds > 0 ? seconds : own; }
};

/// Runs these contestants on the course, the first one that others are compared with, and returns a row for each
/// question, first surface and, when `solid`, then solid, and each contestant that takes it: times, answers judged by
/// the truth, which is kept under out/truth, build, memory, counts. A CSV with its header.
std::string race_rows(const Race_course& course, const std::vector<Contestant>& contestants, bool solid, int passes,
                      double seconds, const Race_options& options);

}  // namespace tetracone::experiments

#endif
