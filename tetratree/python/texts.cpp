#include "tetracone/tetratree/python/texts.h"

#include "tetracone/kernel/number/number.h"

namespace tetracone::python {

namespace py = pybind11;

std::string text_of(const py::handle& text)
{
  const auto bytes =
      py::reinterpret_steal<py::bytes>(PyUnicode_AsEncodedString(text.ptr(), "utf-8", "backslashreplace"));
  if (!bytes) throw py::error_already_set();
  return bytes;
}

std::string type_of(const py::handle& value) { return text_of(py::type::handle_of(value).attr("__name__")); }

std::string digits_of(const py::handle& integer)
{
  const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(integer.ptr()));
  if (!number) throw py::error_already_set();
  int overflow = 0;
  const long long value = PyLong_AsLongLongAndOverflow(number.ptr(), &overflow);
  if (overflow == 0) return std::to_string(value);
  // The digits are hexadecimal, since Python refuses the decimal digits of long integers.
  std::string digits = py::str(py::reinterpret_steal<py::object>(PyNumber_ToBase(number.ptr(), 16)));
  digits.erase(digits.find("0x"), 2);
  return mpz_class(digits, 16).get_str();
}

py::object Python_fraction::operator()(const std::string& text) const
{
  const kernel::Rational x(text);
  // The digits are hexadecimal, since Python reads any number of these.
  const auto integer = [](const mpz_class& n) {
    return py::reinterpret_steal<py::object>(PyLong_FromString(n.get_str(16).c_str(), nullptr, 16));
  };
  return make_(integer(x.get_num()), integer(x.get_den()));
}

std::string exact_text(const py::handle& value)
{
  if (py::isinstance<py::str>(value)) return text_of(value);
  if (py::isinstance<py::float_>(value)) return kernel::shortest(PyFloat_AS_DOUBLE(value.ptr()));
  try {
    py::object top, bottom;
    try {
      top = value.attr("numerator");
      bottom = value.attr("denominator");
    } catch (py::error_already_set& e) {
      if (!e.matches(PyExc_AttributeError)) throw;
      const py::tuple ratio = value.attr("as_integer_ratio")();
      top = ratio[0];
      bottom = ratio[1];
    }
    return digits_of(top) + "/" + digits_of(bottom);
  } catch (py::error_already_set& e) {
    if (e.matches(PyExc_AttributeError) || e.matches(PyExc_TypeError)) return "a " + type_of(value);
    if (!e.matches(PyExc_ValueError) && !e.matches(PyExc_OverflowError)) throw;
    return text_of(py::str(value));  // nan and infinity: refused where numbers are read
  }
}

std::filesystem::path path_of(const py::handle& name)
{
  std::string bytes;
  try {
    bytes = py::bytes(py::module_::import("os").attr("fsencode")(name));
  } catch (py::error_already_set& e) {
    if (!e.matches(PyExc_UnicodeError)) throw;
    throw Error(text_of(py::str(name)) + ": no name of a file; expected one that the file system can spell");
  }
  if (bytes.find('\0') != std::string::npos)
    throw Error(bytes.substr(0, bytes.find('\0')) + "\\0: no name of a file; expected one without zero bytes");
  return bytes;
}

void set_error(const py::handle& of_class, const Error& error)
{
  constexpr std::string_view hex = "0123456789abcdef";
  std::string line;
  for (const char* c = error.what(); *c != 0; ++c) {
    const auto byte = static_cast<unsigned char>(*c);
    if (byte == '\n')
      line += "\\n";
    else if (byte < 0x20 || byte == 0x7f)
      line += std::string("\\x") + hex[byte >> 4] + hex[byte & 15];
    else
      line += *c;
  }
  const auto text = py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(line.data(), py::ssize_t(line.size()), "backslashreplace"));
  if (text) PyErr_SetObject(of_class.ptr(), text.ptr());
}

}  // namespace tetracone::python
