#ifndef TETRACONE_TETRATREE_PYTHON_BODY_H
#define TETRACONE_TETRATREE_PYTHON_BODY_H

#include "tetracone/tetratree/door/tetracone.h"

#include <pybind11/pybind11.h>

#include <cstddef>
#include <utility>

namespace tetracone::python {

/// A body that any number of threads may ask at once.
struct Python_body {
  explicit Python_body(Body b) : body(std::move(b)) {}

  /// Throws Error. pybind11 calls it only for an object of `Body.__new__` without `__init__`; make_shared makes all
  /// others.
  static void* operator new(std::size_t) { throw Error("body: not made; expected Body(vertices, faces)"); }

  const Body body;
};

/// Adds `Body` and `read` to the module.
void add_body(pybind11::module_& module);

}  // namespace tetracone::python

#endif
