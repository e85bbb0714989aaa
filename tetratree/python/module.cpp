// The door in Python, the module tetracone._tetracone. Users import the package `tetracone` beside it.

#include "tetracone/tetratree/python/body.h"
#include "tetracone/tetratree/python/contacts.h"
#include "tetracone/tetratree/python/query.h"
#include "tetracone/tetratree/python/scene.h"
#include "tetracone/tetratree/python/texts.h"

#include <exception>
#include <utility>

namespace py = pybind11;

PYBIND11_MODULE(_tetracone, module)
{
  static const py::handle error = py::exception<tetracone::Error>(module, "Error", PyExc_ValueError).release();
  error.attr("__doc__") = "What a caller or a file has done wrong: one line, \"what is wrong; what was expected\".";
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(std::move(thrown));
    } catch (const tetracone::Error& e) {
      tetracone::python::set_error(error, e);
    }
  });
  module.attr("__version__") = TETRACONE_VERSION;
  tetracone::python::add_contacts(module);  // before the class whose signatures name it
  tetracone::python::add_body(module);
  tetracone::python::add_query(module);
  tetracone::python::add_scene(module);
}
