#ifndef TETRACONE_EXPERIMENTS_SUPPORT_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_SUPPORT_EXPERIMENT_H

// What experiments have in common: their options, clocks, rows and files, and the parts of the standard library that
// nearly all of them use.

#include "experiments/support/csv_row.h"
#include "experiments/support/draw.h"
#include "experiments/support/experiment_options.h"
#include "experiments/support/output_file.h"
#include "experiments/support/progress.h"
#include "experiments/support/resumable_csv.h"

#include <array>
#include <cstddef>
#include <iterator>
#include <memory>

namespace tetracone::experiments {

/// Returns the number of elements of `in` that `from` lacks. Requires sorted lists.
template <class List>
std::size_t missing(const List& from, const List& in)
{
  List rest;
  std::ranges::set_difference(in, from, std::back_inserter(rest));
  return rest.size();
}

}  // namespace tetracone::experiments

#endif
