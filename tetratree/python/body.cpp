#include "tetracone/tetratree/python/body.h"

#include "tetracone/tetratree/python/arrays.h"
#include "tetracone/tetratree/python/texts.h"
#include "tetracone/tetratree/python/unlocked.h"

#include <pybind11/numpy.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace tetracone::python {

namespace py = pybind11;

namespace {

std::shared_ptr<Shared_body> made(const py::handle& vertices, const py::handle& faces)
{
  Polyhedron polyhedron = polyhedron_of(vertices, faces);
  const py::gil_scoped_release unlocked;
  return std::make_shared<Shared_body>(Body(std::move(polyhedron)));
}

std::shared_ptr<Shared_body> read(const py::object& path)
{
  const std::filesystem::path name = path_of(path);
  const py::gil_scoped_release unlocked;
  return std::make_shared<Shared_body>(read_body(name));
}

Location located(Point_query& query, const Numbers& points, bool is_one, std::size_t k)
{
  const auto all = [&](auto&& value) {
    return is_one ? std::array{value(std::size_t(0)), value(std::size_t(1)), value(std::size_t(2))}
                  : std::array{value(k, std::size_t(0)), value(k, std::size_t(1)), value(k, std::size_t(2))};
  };
  try {
    if (points.is_exact_text())
      return query.locate_text(all([&](auto... i) -> std::string { return points.text(i...); }));
    return query.locate(all([&](auto... i) { return points.number(i...); }));
  } catch (const Error& error) {
    throw renamed(error, "point:", is_one ? "points:" : "points[" + std::to_string(k) + "]:");
  }
}

py::object inside(Shared_body& self, const py::object& values)
{
  const Numbers points(values, "points");
  const std::size_t dimensions = points.dimensions();
  if ((dimensions != 1 && dimensions != 2) || points.extent(dimensions - 1) != 3)
    throw Error("points: an array of shape " + points.shape() + "; expected (n, 3), or one point (3,)");
  const bool is_one = dimensions == 1;
  const std::size_t count = is_one ? 1 : points.extent(0);
  py::array_t<std::int8_t> answers(static_cast<py::ssize_t>(count));
  std::int8_t* const answer = answers.mutable_data();
  {
    const py::gil_scoped_release unlocked;
    const std::lock_guard alone(self.lock);
    if (!self.points) self.points.emplace(self.body);
  }
  for_each_unlocked(count, self.lock,
                    [&](std::size_t k) { answer[k] = std::int8_t(located(*self.points, points, is_one, k)); });
  if (is_one) return py::int_(int(answer[0]));
  return answers;
}

}  // namespace

void add_body(py::module_& module)
{
  py::class_<Shared_body, std::shared_ptr<Shared_body>>(module, "Body", R"(Body(vertices, faces)

A polyhedron that queries can be asked about. Immutable, and shared by any number of threads.

vertices: array (n, 3) of doubles, taken exactly; of texts, a decimal is the double nearest to it.
faces: array (m, k) of vertex numbers, or a sequence of faces, each a sequence of numbers, or of loops of numbers: the
outer boundary first, then holes, which run the other way round.

Open and closed surfaces, several shells, cavities and degenerate elements are legal. Faces of more than three corners
must be exactly planar. Raises Error for what is no polyhedron.

>>> import tetracone
>>> body = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> body
Body(4 vertices, 4 faces, closed)
)")
      .def(py::init(&made), py::arg("vertices"), py::arg("faces"))
      .def("inside", &inside, py::arg("points"), R"(inside(points)

Where points are: 1 inside the solid, 0 on its surface, -1 outside. Exact.

points: array (n, 3) of doubles or fractions -> array (n,) of int8; one point (3,) -> int.
Raises Error for an open surface, and for a number that is not finite, which it names.

>>> import tetracone
>>> body = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> body.inside([[0.25, 0.25, 0.25], [0, 0.5, 0.5], [1, 1, 1]])
array([ 1,  0, -1], dtype=int8)
>>> body.inside(["1/3", "1/3", "1/3"])
0
)")
      .def(
          "make_all", [](const Shared_body& self) { self.body.make_all(); }, py::call_guard<py::gil_scoped_release>(),
          R"(make_all()

Makes now what queries of the method `tree` would make when they first need it.

>>> import tetracone
>>> tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]).make_all()
)")
      .def_property_readonly(
          "is_closed", [](const Shared_body& self) { return self.body.is_closed(); },
          "True when every directed edge occurs as often as its reverse: then the body bounds a solid.")
      .def_property_readonly(
          "vertices",
          [](const py::object& self) { return vertices_of(self.cast<const Shared_body&>().body.polyhedron(), self); },
          "The vertices: array (n, 3) of doubles, a read-only view.")
      .def_property_readonly(
          "faces", [](const Shared_body& self) { return faces_of(self.body.polyhedron()); },
          "The faces: a list of faces, each a list of loops, each a tuple of vertex numbers.")
      .def("__repr__",
           [](const Shared_body& self) {
             const Polyhedron& p = self.body.polyhedron();
             return "Body(" + std::to_string(p.vertices.size()) + " vertices, " + std::to_string(p.face_count()) +
                    " faces, " + (self.body.is_closed() ? "closed)" : "open)");
           })
      .def(py::pickle([](const py::object& self) { return py::make_tuple(self.attr("vertices"), self.attr("faces")); },
                      [](const py::tuple& state) { return made(state[0], state[1]); }));

  module.def("read", &read, py::arg("path"), R"(read(path)

The body of a file: OFF, OBJ, PLY, STL or TetGen .poly, by the suffix. Raises Error, "file:line: what is wrong; what was
expected", for a file that is none, and as Body does.

>>> import tetracone, tempfile, pathlib
>>> with tempfile.TemporaryDirectory() as folder:
...     file = pathlib.Path(folder, "triangle.off")
...     _ = file.write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
...     tetracone.read(file)
Body(3 vertices, 1 faces, open)
)");
}

}  // namespace tetracone::python
