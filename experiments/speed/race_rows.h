#ifndef TETRACONE_EXPERIMENTS_SPEED_RACE_ROWS_H
#define TETRACONE_EXPERIMENTS_SPEED_RACE_ROWS_H

#include "experiments/speed/race.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace tetracone::experiments {

/// The options of the experiments of speed.
struct Race_options {
  std::filesystem::path out = "out";
  std::filesystem::path models;  ///< the folder that fetch_models.sh filled
  int frames = 400;              ///< poses of each trajectory
  bool full = false;             ///< larger objects too
  std::uint64_t seed = 1;
  double seconds = 0;  ///< processor time after which a contestant is asked no more; 0: each race's own limit

  double seconds_or(double own) const { return seconds > 0 ? seconds : own; }
};

/// Runs these contestants on the course and compares the others with the first. Returns a CSV with its header: a row
/// for each question and each contestant that takes it. The questions are surface and, when `solid`, solid. A row has
/// times, answers judged by the truth (which is saved under out/truth), build, memory and counts.
std::string race_rows(const Race_course& course, const std::vector<Contestant>& contestants, bool solid, int passes,
                      double seconds, const Race_options& options);

}  // namespace tetracone::experiments

#endif
