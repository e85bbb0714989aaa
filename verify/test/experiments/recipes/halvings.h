#ifndef TETRACONE_VERIFY_TEST_EXPERIMENTS_RECIPES_HALVINGS_H
#define TETRACONE_VERIFY_TEST_EXPERIMENTS_RECIPES_HALVINGS_H
// Recipe "An experiment": its declaration is in experiments.h of its room, its source here.

#include "experiments/support/csv_row.h"
#include "experiments/support/experiment_options.h"
#include "experiments/support/output_file.h"
#include "verify/cases/shape_generators.h"
#include "verify/subjects/subject.h"

#include <cmath>

namespace tetracone::experiments {

/// Finds, for two unit cubes 2^-k apart, the k at which each kernel first answers that they touch. Writes
/// OUT/halvings.csv, one row per kernel. Throws covering::Input_error when `options.out` cannot be written.
inline void run_halvings(const Experiment_options& options)
{
  make_folder(options.out);
  const covering::Polyhedron cube = verify::unit_cube();
  Csv_table table;
  for (const char* kernel : {"adaptive", "double", "float"}) {
    const verify::Subject subject = *verify::Subject::parse(kernel);
    const auto pair = verify::prepare(subject, cube, cube);
    int k = 0;
    while (!pair->collide(kernel::Pose(), kernel::Pose::translation(1 + std::ldexp(1.0, -k), 0, 0),
                          kernel::Question::solid))
      ++k;
    table.add(Csv_row().add("subject", subject.name()).add("halvings", k).add_origin(0));
  }
  write_whole(options.out / "halvings.csv", table.text());
}

}  // namespace tetracone::experiments

#endif
