#ifndef TETRACONE_EXPERIMENTS_SUPPORT_EXPERIMENT_OPTIONS_H
#define TETRACONE_EXPERIMENTS_SUPPORT_EXPERIMENT_OPTIONS_H

#include "verify/subjects/object_subject.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace tetracone::experiments {

/// The options of `tetracone experiment`. Each experiment takes those that its row in the command's list names.
struct Experiment_options {
  std::filesystem::path out = "out";
  std::filesystem::path models;               ///< the folder that fetch_models.sh filled
  std::filesystem::path model;                ///< of `method`; empty: a generated one
  std::filesystem::path queries;              ///< of `motion`: a folder of published queries; empty: none
  std::vector<std::filesystem::path> meshes;  ///< of `points`: closed meshes of triangles, beside the generated
  std::uint64_t seed = 1;
  std::uint64_t cases = 20;          ///< of `dataset`: per family and level; of `motion`: a tenth of a family's pairs
  int frames = 60, rotations = 100;  ///< of `study`: poses of a trajectory, and of a degenerate scenario (also of
                                     ///< `contact-cost`)
  int race_frames = 400;             ///< poses of each trajectory of the others
  double race_seconds = 0;           ///< seconds of processor time after which a contestant rests; 0: each race's own
  int size = 256, points = 20'000;   ///< of `sign-maps`: rows and columns; of `points`: points of a kind, and rays
  bool full = false;                 ///< larger objects, or more of everything
  bool rows_alone = false;           ///< of `study`: no report
  std::vector<verify::Object_subject> programs;  ///< of `study` and `peers`: somebody else's methods

  /// Returns `race_seconds`, or a race's own number where that is 0.
  double seconds_or(double own) const { return race_seconds > 0 ? race_seconds : own; }
};

}  // namespace tetracone::experiments

#endif
