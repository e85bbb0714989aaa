#ifndef TETRACONE_TETRATREE_PYTHON_TEXTS_H
#define TETRACONE_TETRATREE_PYTHON_TEXTS_H

#include "tetracone/tetratree/door/tetracone.h"

#include <pybind11/pybind11.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

/// Python's texts converted for the door, and the door's for Python.
namespace tetracone::python {

/// Returns a str in UTF-8. A character without UTF-8, such as a lone surrogate, is escaped.
std::string text_of(const pybind11::handle& text);

/// Returns the name of the value's type.
std::string type_of(const pybind11::handle& value);

/// Returns the decimal digits of an integer of any length. Throws Python's error for anything else.
std::string digits_of(const pybind11::handle& integer);

/// A word in an array of numpy's fixed-length texts, of the type "U" and this length. Requires ASCII that is no longer.
template <std::size_t length>
struct Word {
  std::array<char32_t, length> letters{};

  Word& operator=(std::string_view word)
  {
    letters = {};
    std::copy(word.begin(), word.end(), letters.begin());
    return *this;
  }
};
static_assert(sizeof(Word<8>) == 4 * 8);

/// Makes Python's fractions.Fraction of texts "n/d" and "n", which may have any number of digits.
class Python_fraction {
 public:
  /// Returns the fraction of a text.
  pybind11::object operator()(const std::string& text) const;

 private:
  pybind11::object make_ = pybind11::module_::import("fractions").attr("Fraction");
};

/// Returns the text that the door reads as exactly this number. A text stays as it is, a float becomes its shortest
/// decimal, and any other number "n/d". The denominator 1 is written too, since a decimal would be rounded. Another
/// type's nan or infinity becomes its own text, which the door refuses. A value that is no number becomes "a TYPE", for
/// messages.
std::string exact_text(const pybind11::handle& value);

/// Returns a file's name from str, bytes or os.PathLike, of any bytes except 0. Throws Error for a text that names no
/// file. Raises Python's TypeError for other types.
std::filesystem::path path_of(const pybind11::handle& name);

/// Sets Python's error of this class. It is one line, whatever bytes of files and texts it quotes.
void set_error(const pybind11::handle& of_class, const Error& error);

}  // namespace tetracone::python

#endif
