// The door in Python, as the module tetracone._tetracone; the package `tetracone` beside it is what users import.

#include "tetracone/tetratree/python/body.h"
#include "tetracone/tetratree/python/query.h"

#include <string>

namespace py = pybind11;

PYBIND11_MODULE(_tetracone, module)
{
  py::register_exception<tetracone::Error>(module, "Error", PyExc_ValueError).attr("__doc__") =
      "What a caller or a file has done wrong: one line, \"what is wrong; what was expected\".";
  module.attr("__version__") = TETRACONE_VERSION;
  tetracone::python::add_body(module);
  tetracone::python::add_query(module);
}
