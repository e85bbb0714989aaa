#ifndef TETRACONE_TETRATREE_PYTHON_CONTACTS_H
#define TETRACONE_TETRATREE_PYTHON_CONTACTS_H

#include <pybind11/pybind11.h>

namespace tetracone::python {

/// Adds `Contacts`, which queries return, to the module.
void add_contacts(pybind11::module_& module);

}  // namespace tetracone::python

#endif
