#ifndef TETRACONE_TETRATREE_PYTHON_QUERY_H
#define TETRACONE_TETRATREE_PYTHON_QUERY_H

#include <pybind11/pybind11.h>

namespace tetracone::python {

/// Adds `Query`, `kernels` and `methods` to the module.
void add_query(pybind11::module_& module);

}  // namespace tetracone::python

#endif
