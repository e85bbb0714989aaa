#ifndef TETRACONE_TETRATREE_PYTHON_QUERY_H
#define TETRACONE_TETRATREE_PYTHON_QUERY_H

#include "tetracone/tetratree/door/tetracone.h"

#include <pybind11/pybind11.h>

#include <array>
#include <span>
#include <string>

namespace tetracone::python {

/// Returns the columns of overlaps, as `Query.overlap` documents them; of one pair the single values.
pybind11::dict overlap_columns(std::span<const Overlap> found, bool is_one);
/// Returns the columns of exits, as `Query.exits` documents them.
pybind11::dict exit_columns(std::span<const Exits> found, bool is_one);
/// Returns the columns of depths, as `Query.depth` documents them.
pybind11::dict depth_columns(std::span<const Depth> found, bool is_one);

/// Returns the exact texts of three numbers. Throws Error for another count.
std::array<std::string, 3> direction_of(const pybind11::object& direction);

/// Adds `Query`, `kernels` and `methods` to the module.
void add_query(pybind11::module_& module);

}  // namespace tetracone::python

#endif
