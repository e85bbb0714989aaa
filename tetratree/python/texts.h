#ifndef TETRACONE_TETRATREE_PYTHON_TEXTS_H
#define TETRACONE_TETRATREE_PYTHON_TEXTS_H

#include "tetracone/tetratree/door/tetracone.h"

#include <pybind11/pybind11.h>

#include <filesystem>
#include <string>

/// Texts of Python as the door takes them, and the door's as Python takes them.
namespace tetracone::python {

/// A str in UTF-8; what has none, as a lone surrogate, is escaped.
std::string text_of(const pybind11::handle& text);

/// The name of the value's type.
std::string type_of(const pybind11::handle& value);

/// The decimal digits of an integer of any length. Throws what Python throws for what is none.
std::string digits_of(const pybind11::handle& integer);

/// What the door takes for exactly this number: a text itself, of a float its shortest decimal, else "n/d", with the
/// denominator 1 too, since a decimal would be rounded. Of what is no number, what messages call it.
std::string exact_text(const pybind11::handle& value);

/// A file's name: str, bytes or os.PathLike, of any bytes but 0. Throws Error for a text that names no file.
std::filesystem::path path_of(const pybind11::handle& name);

/// Sets Python's error of this class: one line, whatever bytes of files and texts it quotes.
void set_error(const pybind11::handle& of_class, const Error& error);

}  // namespace tetracone::python

#endif
