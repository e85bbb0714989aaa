#include "tetracone/tetratree/python/contacts.h"

#include "tetracone/tetratree/door/tetracone.h"
#include "tetracone/tetratree/python/texts.h"

#include <pybind11/numpy.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tetracone::python {

namespace py = pybind11;

namespace {

/// Returns an array of `what(k, side)` for each piece: (n,) if `sides` is 1, else (n, 2).
template <class What>
py::array piece_words(const Contacts& contacts, std::size_t sides, const What& what)
{
  std::vector<std::size_t> shape = {contacts.size()};
  if (sides > 1) shape.push_back(sides);
  py::array words(py::dtype("U8"), shape);
  auto* const word = static_cast<Word<8>*>(words.mutable_data());
  for (std::size_t k = 0; k < contacts.size() * sides; ++k) word[k] = what(k / sides, k % sides);
  return words;
}

py::array faces(const Contacts& contacts)
{
  py::array_t<std::uint32_t> faces({contacts.size(), std::size_t(2)});
  std::uint32_t* row = faces.mutable_data();
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    *row++ = contacts[k].face_a;
    *row++ = contacts[k].face_b;
  }
  return faces;
}

py::array points(const std::vector<std::array<double, 3>>& of)
{
  return py::array_t<double>({of.size(), std::size_t(3)}, reinterpret_cast<const double*>(of.data()));
}

/// Returns the number of piece k; a negative k counts from the end.
std::size_t piece_number(const Contacts& contacts, std::ptrdiff_t k)
{
  const auto n = std::ptrdiff_t(contacts.size());
  if (k < -n || k >= n) throw py::index_error("piece " + std::to_string(k) + " of " + std::to_string(n));
  return std::size_t(k < 0 ? k + n : k);
}

py::list loops(const Contacts& contacts, std::ptrdiff_t k)
{
  py::list loops;
  for (const auto& loop : contacts.nearest_loops(piece_number(contacts, k))) loops.append(points(loop));
  return loops;
}

/// Writes the lower bounds, then the upper ones; returns the place behind them.
double* copy_bounds(const Enclosure& point, double* at)
{
  for (const auto* bound : {&point.lower, &point.upper}) at = std::copy(bound->begin(), bound->end(), at);
  return at;
}

py::list enclosures(const Contacts& contacts, std::ptrdiff_t k)
{
  py::list enclosures;
  for (const auto& loop : contacts.loops(piece_number(contacts, k))) {
    py::array_t<double> bounds({loop.size(), std::size_t(2), std::size_t(3)});
    double* at = bounds.mutable_data();
    for (const Enclosure& point : loop) at = copy_bounds(point, at);
    enclosures.append(bounds);
  }
  return enclosures;
}

py::array normals(const Contacts& contacts)
{
  py::array_t<double> all({contacts.size(), std::size_t(2), std::size_t(2), std::size_t(3)});
  double* at = all.mutable_data();
  for (std::size_t k = 0; k < contacts.size(); ++k)
    for (const Enclosure& normal : contact_normals(contacts, k)) at = copy_bounds(normal, at);
  return all;
}

py::list exact_loops(const Contacts& contacts, std::ptrdiff_t k)
{
  const Python_fraction fraction;
  py::list loops;
  for (const auto& loop : contacts.exact_loops(piece_number(contacts, k))) {
    py::list points;
    for (const auto& x : loop) points.append(py::make_tuple(fraction(x[0]), fraction(x[1]), fraction(x[2])));
    loops.append(points);
  }
  return loops;
}

py::list curves(const Contacts& contacts)
{
  py::list curves;
  for (const Contacts::Curve& curve : contacts.curves())
    curves.append(py::make_tuple(curve.closed, points(curve.points)));
  return curves;
}

}  // namespace

void add_contacts(py::module_& module)
{
  py::class_<Contacts>(module, "Contacts", R"(Contacts: all pairs of faces of two placed bodies that meet

`Query.contacts` makes them, and `Body.self_intersections` for one body. A pair of faces has a piece for each maximal
point, segment and polygon that they share. len() is the number of pieces, which are in the order of their faces. The
place of a piece is computed when it is asked for.

faces: (n, 2) uint32, the face of a and the face of b of each piece.
kind: (n,) "point", "segment", or "coplanar": a polygon of two faces in one plane.
held_by: (n, 2) "vertex", "edge" or "interior": what of the face of a, and of b, holds the piece.
)")
      .def("__len__", &Contacts::size)
      .def_property_readonly("faces", &faces, "(n, 2) uint32: the face of a and the face of b of each piece.")
      .def_property_readonly(
          "kind",
          [](const Contacts& contacts) {
            return piece_words(contacts, 1, [&](std::size_t k, std::size_t) { return to_string(contacts[k].kind); });
          },
          "(n,) str: point, segment or coplanar.")
      .def_property_readonly(
          "held_by",
          [](const Contacts& contacts) {
            return piece_words(contacts, 2, [&](std::size_t k, std::size_t side) {
              return to_string(side == 0 ? contacts[k].in_a : contacts[k].in_b);
            });
          },
          "(n, 2) str: what of either face holds the piece: vertex, edge or interior.")
      .def("loops", &loops, py::arg("k"), R"(loops(k)

Where piece k is, as the doubles nearest to it. A point is a list of one array (1, 3), a segment of one array (2, 3) of
its ends. A polygon is a list of arrays (m, 3): its outer loop and its holes, in no order.)")
      .def("enclosures", &enclosures, py::arg("k"), R"(enclosures(k)

As `loops`, each point as doubles below and above it: arrays (m, 2, 3).)")
      .def("normals", &normals, R"(normals()

The unit normals of the placed faces of all pieces: array (n, 2, 2, 3). For the face of a, then of b, it holds doubles
below and above each coordinate, which are equal or neighbours. The normals are outward where faces are oriented
outward, and 0 for a face without area.)")
      .def("exact_loops", &exact_loops, py::arg("k"), R"(exact_loops(k)

As `loops`, exactly: lists of tuples of three fractions.Fraction.)")
      .def("curves", &curves, R"(curves()

The curves of the pieces that are segments: a list of (closed, array (m, 3)). Each segment counts once, and segments of
one line that hang together are one. Curves join where exactly two segments end in one point, compared exactly.)");
  // pybind11 asks for memory only for an object of `Contacts.__new__`: queries return contacts that are made.
  py::detail::get_type_info(typeid(Contacts))->operator_new = [](std::size_t) -> void* {
    throw Error("contacts: not made; expected Query.contacts");
  };
}

}  // namespace tetracone::python
