#ifndef TETRACONE_TETRATREE_PYTHON_BODY_H
#define TETRACONE_TETRATREE_PYTHON_BODY_H

#include "tetracone/tetratree/door/tetracone.h"

#include <pybind11/pybind11.h>

#include <cstddef>
#include <mutex>
#include <optional>
#include <utility>

namespace tetracone::python {

/// A body, and the query of points that it answers by, made when it is first asked.
struct Shared_body {
  explicit Shared_body(Body b) : body(std::move(b)) {}

  /// What pybind11 calls for the object of `Body.__new__`, which nobody has made; others are made by make_shared.
  static void* operator new(std::size_t) { throw Error("body: not made; expected Body(vertices, faces)"); }

  const Body body;
  std::mutex lock;  // of what follows; never waited for with the interpreter's lock
  std::optional<Point_query> points;
};

/// Adds `Body` and `read`.
void add_body(pybind11::module_& module);

}  // namespace tetracone::python

#endif
