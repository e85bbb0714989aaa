#include "tetracone/tetratree/python/arrays.h"

#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/python/texts.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace tetracone::python {

namespace py = pybind11;

bool is_sequence(const py::handle& value)
{
  if (py::isinstance<py::str>(value) || py::isinstance<py::bytes>(value)) return false;
  return py::isinstance<py::sequence>(value) || py::isinstance<py::array>(value);
}

namespace {

/// True when an array, or one within lists of lists, has masked entries. They are refused, since numpy drops their
/// mask.
bool has_masked(const py::handle& values, int depth = 3)
{
  static const py::handle module = py::module_::import("numpy.ma").release();
  static const py::handle masked_array = py::object(module.attr("MaskedArray")).release();
  if (PyObject_TypeCheck(values.ptr(), reinterpret_cast<PyTypeObject*>(masked_array.ptr())))
    return py::bool_(module.attr("is_masked")(values));
  if (depth == 0 || !(py::isinstance<py::list>(values) || py::isinstance<py::tuple>(values))) return false;
  for (const py::handle value : values)
    if (has_masked(value, depth - 1)) return true;
  return false;
}

/// True for an integer that is no double.
bool is_wide_integer(const py::handle& value)
{
  const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  if (!number) {
    PyErr_Clear();
    return false;
  }
  const auto nearest = py::reinterpret_steal<py::object>(PyNumber_Float(number.ptr()));
  if (!nearest) PyErr_Clear();  // beyond all doubles
  return !nearest || !nearest.equal(number);
}

/// True when numpy may have rounded values to make them an array. It makes doubles of floats with integers, and texts
/// of texts with numbers.
bool may_be_rounded(const py::array& array)
{
  const char kind = array.dtype().kind();
  if (kind == 'U' || kind == 'S') return true;
  if (kind != 'f' || array.itemsize() > 8) return false;
  const py::array_t<double, py::array::forcecast | py::array::c_style> doubles(array);
  return std::any_of(doubles.data(), doubles.data() + doubles.size(),
                     [](double x) { return std::abs(x) >= 1LL << std::numeric_limits<double>::digits; });
}

py::array as_array(const py::handle& values, const std::string& name)
{
  if (has_masked(values)) throw Error(name + ": an array with masked entries; expected numbers");
  try {
    py::array array(py::reinterpret_borrow<py::object>(values));
    if (py::isinstance<py::array>(values) || !may_be_rounded(array)) return array;
    py::array objects = py::module_::import("numpy").attr("array")(values, "object");
    if (array.dtype().kind() != 'f') return objects;
    const py::object all = objects.attr("ravel")();
    for (const py::handle value : all)
      if (is_wide_integer(value)) return objects;
    return array;
  } catch (py::error_already_set& e) {
    if (!e.matches(PyExc_ValueError) && !e.matches(PyExc_TypeError) && !e.matches(PyExc_OverflowError)) throw;
    throw Error(name + ": rows of different lengths; expected an array of numbers");
  }
}

/// True when all integers are doubles.
bool are_doubles(const py::array& integers)
{
  if (integers.itemsize() <= 4 || integers.size() == 0) return true;
  const py::int_ largest(1LL << std::numeric_limits<double>::digits);
  return integers.attr("max")() <= largest && integers.attr("min")() >= -largest;
}

[[noreturn]] void no_vertex(const std::string& number, std::size_t face, std::size_t vertex_count)
{
  throw Error("body: face " + std::to_string(face) + " names vertex " + number.substr(0, 40) + " of " +
              std::to_string(vertex_count) + " vertices; expected numbers from 0 to " + std::to_string(vertex_count) +
              ", the last excluded");
}

template <std::integral Integer>
std::uint32_t vertex_number(Integer number, std::size_t face, std::size_t vertex_count)
{
  if (std::cmp_less(number, 0) || std::cmp_greater_equal(number, vertex_count))
    no_vertex(std::to_string(number), face, vertex_count);
  return std::uint32_t(number);
}

/// True for a truth value of Python or numpy: both claim to be integers.
bool is_truth_value(const py::handle& value)
{
  static const py::handle numpy_bool = py::object(py::dtype::of<bool>().attr("type")).release();
  return py::isinstance<py::bool_>(value) || py::isinstance(value, numpy_bool);
}

std::uint32_t vertex_number(const py::handle& corner, std::size_t face, std::size_t vertex_count)
{
  const auto number =
      is_truth_value(corner) ? py::object() : py::reinterpret_steal<py::object>(PyNumber_Index(corner.ptr()));
  if (!number) {
    if (PyErr_Occurred() != nullptr && !PyErr_ExceptionMatches(PyExc_TypeError)) throw py::error_already_set();
    PyErr_Clear();
    throw Error("body: face " + std::to_string(face) + " has a corner of type " + type_of(corner) +
                "; expected vertex numbers, or loops of them");
  }
  int overflow = 0;
  const long long value = PyLong_AsLongLongAndOverflow(number.ptr(), &overflow);
  if (overflow != 0) no_vertex(digits_of(number), face, vertex_count);
  return vertex_number(value, face, vertex_count);
}

/// Returns the double that the door's reader of numbers makes of a text. Returns nothing if it makes none, or a
/// fraction that is no double.
std::optional<double> double_of(const std::string& text)
{
  const auto number = kernel::parse_number(text);
  if (!number) return std::nullopt;
  const double nearest = kernel::nearest_double(*number);
  return kernel::Rational(nearest) == *number ? std::optional(nearest) : std::nullopt;
}

std::vector<std::uint32_t> loop_of(const py::handle& corners, std::size_t face, std::size_t vertex_count)
{
  std::vector<std::uint32_t> loop;
  for (const py::handle corner : corners) loop.push_back(vertex_number(corner, face, vertex_count));
  if (loop.empty()) throw Error("body: face " + std::to_string(face) + " has an empty loop; expected vertex numbers");
  return loop;
}

std::vector<std::vector<std::uint32_t>> loops_of(const py::handle& face, std::size_t f, std::size_t vertex_count)
{
  if (!is_sequence(face))
    throw Error("body: face " + std::to_string(f) + " is of type " + type_of(face) +
                "; expected a sequence of vertex numbers, or of loops of them");
  if (py::len(face) == 0) throw Error("body: face " + std::to_string(f) + " is empty; expected vertex numbers");
  const auto first = py::reinterpret_borrow<py::object>(*py::iter(face));
  if (!is_sequence(first)) return {loop_of(face, f, vertex_count)};
  std::vector<std::vector<std::uint32_t>> loops;
  for (const py::handle loop : face) {
    if (!is_sequence(loop))
      throw Error("body: face " + std::to_string(f) + " has a loop of type " + type_of(loop) +
                  "; expected sequences of vertex numbers");
    loops.push_back(loop_of(loop, f, vertex_count));
  }
  return loops;
}

/// Adds the rows of an array of integers, each as a polygon.
template <std::integral Integer>
void add_polygons(Polyhedron& polyhedron, const py::array& faces)
{
  const py::array_t<Integer, py::array::forcecast> numbers(faces);
  const auto number = numbers.template unchecked<2>();
  std::vector<std::uint32_t> loop(number.shape(1));
  for (py::ssize_t f = 0; f < number.shape(0); ++f) {
    for (py::ssize_t k = 0; k < number.shape(1); ++k)
      loop[k] = vertex_number(number(f, k), f, polyhedron.vertices.size());
    polyhedron.add_polygon(loop);
  }
}

}  // namespace

Error renamed(const Error& error, std::string_view from, const std::string& to)
{
  const std::string_view what = error.what();
  return what.starts_with(from) ? Error(to + std::string(what.substr(from.size()))) : error;
}

std::size_t common_count(const std::string& about, std::size_t n, const std::string& first, std::size_t m,
                         const std::string& second)
{
  if (n != m && n != 1 && m != 1)
    throw Error(about + ": " + std::to_string(n) + first + " and " + std::to_string(m) + second +
                "; expected as many, or one of either");
  return n == 1 ? m : n;
}

Numbers::Numbers(const py::handle& values, std::string name) : name_(std::move(name)), array_(as_array(values, name_))
{
  const char kind = array_.dtype().kind();
  const auto width = array_.itemsize();
  shape_.assign(array_.shape(), array_.shape() + array_.ndim());
  if (kind == 'b' || (kind == 'f' && width <= 8) || ((kind == 'i' || kind == 'u') && are_doubles(array_))) {
    // Doubles in this machine's order of bytes are taken as they are.
    if (!array_.dtype().is(py::dtype::of<double>())) array_ = py::array_t<double, py::array::forcecast>(array_);
    data_ = static_cast<const char*>(array_.data());
    strides_.assign(array_.strides(), array_.strides() + array_.ndim());
    return;
  }
  if (kind == 'c' || kind == 'M' || kind == 'm' || kind == 'V')
    throw Error(name_ + ": an array of " + text_of(py::str(array_.dtype())) + "; expected numbers");
  exact_ = true;
  const py::object objects = array_.attr("astype")("object").attr("ravel")();
  for (const py::handle value : objects) texts_.push_back(exact_text(value));
  text_strides_.assign(shape_.size(), 1);
  for (std::size_t k = shape_.size(); k-- > 1;) text_strides_[k - 1] = text_strides_[k] * std::ptrdiff_t(shape_[k]);
}

std::string Numbers::shape() const
{
  std::string text;
  for (const std::size_t n : shape_) text += (text.empty() ? "(" : ", ") + std::to_string(n);
  return text.empty() ? "()" : text + (shape_.size() == 1 ? ",)" : ")");
}

Poses::Poses(const py::object& values, const std::string& name) : name_(name)
{
  if (values.is_none()) return;
  numbers_ = std::make_unique<Numbers>(values, name);
  const std::size_t dimensions = numbers_->dimensions();
  const bool fits = (dimensions == 2 || dimensions == 3) && numbers_->extent(dimensions - 1) == 4 &&
                    (numbers_->extent(dimensions - 2) == 3 || numbers_->extent(dimensions - 2) == 4);
  if (!fits)
    throw Error(name + ": an array of shape " + numbers_->shape() +
                "; expected (n, 3, 4) or (n, 4, 4), or one pose (3, 4) or (4, 4)");
  is_one_ = dimensions == 2;
  count_ = is_one_ ? 1 : numbers_->extent(0);
  rows_ = numbers_->extent(dimensions - 2);
  if (numbers_->is_exact_text() || rows_ == 4) return;
  if (numbers_->stride(dimensions - 1) == sizeof(double) && numbers_->stride(dimensions - 2) == 4 * sizeof(double)) {
    packed_ = numbers_->data();
    stride_ = is_one_ ? 0 : numbers_->stride(0);
  }
}

void Poses::require(std::size_t k) const
{
  try {
    (*this)(k);
  } catch (const Error& error) {
    throw renamed(error, "pose:", name(k) + ":");
  }
}

std::string Poses::name(std::size_t k) const { return is_one_ ? name_ : name_ + "[" + std::to_string(k) + "]"; }

Pose Poses::made(std::size_t k) const
{
  const auto at = [&](auto&& value, std::size_t row, std::size_t column) {
    return is_one_ ? value(row, column) : value(k, row, column);
  };
  const auto number = [&](auto... i) { return numbers_->number(i...); };
  const auto text = [&](auto... i) { return numbers_->text(i...); };
  const auto refuse = [](std::size_t column, const std::string& is) {
    throw Error("pose: entry " + std::to_string(column + 1) + " of the last row is " + is + "; expected 0 0 0 1");
  };
  if (numbers_->is_exact_text()) {
    std::array<std::string, 12> rows;
    for (std::size_t i = 0; i < 12; ++i) rows[i] = at(text, i / 4, i % 4);
    for (std::size_t column = 0; rows_ == 4 && column < 4; ++column) {
      const std::string last = at(text, 3, column);
      if (kernel::parse_number(last) != kernel::Rational(column == 3 ? 1 : 0)) refuse(column, last.substr(0, 40));
    }
    return Pose::from_text(rows);
  }
  std::array<double, 16> rows{};
  for (std::size_t i = 0; i < 4 * rows_; ++i) rows[i] = at(number, i / 4, i % 4);
  for (std::size_t column = 0; rows_ == 4 && column < 4; ++column)
    if (rows[12 + column] != (column == 3 ? 1 : 0)) refuse(column, kernel::shortest(rows[12 + column]));
  std::array<double, 12> upper;
  std::copy_n(rows.begin(), 12, upper.begin());
  return Pose(upper);
}

Polyhedron polyhedron_of(const py::handle& vertices, const py::handle& faces)
{
  const Numbers numbers(vertices, "vertices");
  if (numbers.dimensions() != 2 || numbers.extent(1) != 3)
    throw Error("vertices: an array of shape " + numbers.shape() + "; expected (n, 3)");
  Polyhedron polyhedron;
  polyhedron.vertices.resize(numbers.extent(0));
  for (std::size_t v = 0; v < polyhedron.vertices.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k) {
      double& x = polyhedron.vertices[v][k];
      if (!numbers.is_exact_text()) {
        x = numbers.number(v, k);
        continue;
      }
      const auto number = double_of(numbers.text(v, k));
      if (!number)
        throw Error("vertices[" + std::to_string(v) + "]: '" + numbers.text(v, k).substr(0, 40) +
                    "' is no double; expected doubles");
      x = *number;
    }
  if (has_masked(faces)) throw Error("faces: an array with masked entries; expected vertex numbers");
  if (py::isinstance<py::array>(faces)) {
    const auto array = py::reinterpret_borrow<py::array>(faces);
    const char kind = array.dtype().kind();
    if (array.ndim() == 2 && (kind == 'i' || kind == 'u')) {
      if (array.shape(1) == 0) throw Error("faces: an array of 0 columns; expected vertex numbers");
      if (kind == 'u')
        add_polygons<std::uint64_t>(polyhedron, array);
      else
        add_polygons<std::int64_t>(polyhedron, array);
      return polyhedron;
    }
  }
  if (!is_sequence(faces))
    throw Error("faces: of type " + type_of(faces) + "; expected an array (m, k) of integers, or a sequence of faces");
  std::size_t f = 0;
  for (const py::handle face : faces) polyhedron.add_face(loops_of(face, f++, polyhedron.vertices.size()));
  return polyhedron;
}

py::list faces_of(const Polyhedron& polyhedron)
{
  py::list faces;
  for (std::uint32_t f = 0; f < polyhedron.face_count(); ++f) {
    py::list loops;
    for (std::size_t k = 0; k < polyhedron.loop_count(f); ++k) {
      const auto loop = polyhedron.loop(f, k);
      py::tuple corners(loop.size());
      for (std::size_t i = 0; i < loop.size(); ++i) corners[i] = loop[i];
      loops.append(std::move(corners));
    }
    faces.append(std::move(loops));
  }
  return faces;
}

py::array vertices_of(const Polyhedron& polyhedron, const py::handle& owner)
{
  py::array_t<double> vertices({polyhedron.vertices.size(), std::size_t(3)},
                               reinterpret_cast<const double*>(polyhedron.vertices.data()), owner);
  vertices.attr("flags").attr("writeable") = false;
  return vertices;
}

}  // namespace tetracone::python
