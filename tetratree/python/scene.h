#ifndef TETRACONE_TETRATREE_PYTHON_SCENE_H
#define TETRACONE_TETRATREE_PYTHON_SCENE_H

#include <pybind11/pybind11.h>

namespace tetracone::python {

/// Adds `Scene` to the module.
void add_scene(pybind11::module_& module);

}  // namespace tetracone::python

#endif
