#include "tetracone/tetratree/python/body.h"

#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/python/arrays.h"
#include "tetracone/tetratree/python/texts.h"
#include "tetracone/tetratree/python/unlocked.h"

#include <pybind11/numpy.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace tetracone::python {

namespace py = pybind11;

namespace {

/// Returns the index that a double is; nothing if it is none.
std::optional<Index> index_of(double x)
{
  const bool is_index = x >= 0 && x <= double(std::numeric_limits<Index>::max()) && x == std::floor(x);
  return is_index ? std::optional(Index(x)) : std::nullopt;
}

std::shared_ptr<Python_body> made(const py::object& vertices, const py::object& faces, const py::object& triangles)
{
  std::vector<Face_triangle> of_faces;
  if (!triangles.is_none()) {
    const Rows<4> rows(triangles, "triangles", "triangle");
    for (std::size_t k = 0; k < rows.count(); ++k) {
      std::array<Index, 4> number{};
      for (std::size_t i = 0; i < 4; ++i) {
        const auto index = rows.is_exact_text() ? std::nullopt : index_of(rows.row(k)[i]);
        if (!index) throw Error(rows.name(k) + ": no number of a face or a vertex; expected a face and three vertices");
        number[i] = *index;
      }
      of_faces.push_back({number[0], {number[1], number[2], number[3]}});
    }
  }
  Polyhedron polyhedron = polyhedron_of(vertices, faces);
  const py::gil_scoped_release unlocked;
  return std::make_shared<Python_body>(Body(std::move(polyhedron), std::move(of_faces)));
}

/// Returns an array (n, 4): the face and the three vertices of each triangle.
py::array triangles_of(const Python_body& self)
{
  const std::vector<Face_triangle>& triangles = self.body.triangles();
  py::array_t<Index> rows({triangles.size(), std::size_t(4)});
  Index* row = rows.mutable_data();
  for (const Face_triangle& triangle : triangles) {
    *row++ = triangle.face;
    row = std::ranges::copy(triangle.corner, row).out;
  }
  return rows;
}

std::shared_ptr<Python_body> read(const py::object& path)
{
  const std::filesystem::path name = path_of(path);
  const py::gil_scoped_release unlocked;
  return std::make_shared<Python_body>(read_body(name));
}

void save(const Python_body& self, const py::object& path)
{
  const std::filesystem::path name = path_of(path);
  const py::gil_scoped_release unlocked;
  save_body(self.body, name);
}

using Points = Rows<3>;

/// Calls ask(k) for each point, as `for_each_unlocked`. Throws Error with the point's name.
template <class Ask>
void for_each_point(const Points& points, const Ask& ask)
{
  for_each_unlocked(points.count(), no_lock, [&](std::size_t k) {
    try {
      ask(k);
    } catch (const Error& error) {
      throw renamed(error, "point:", points.name(k) + ":");
    }
  });
}

py::object inside(const Python_body& self, const py::object& values)
{
  const Points points(values, "points", "point");
  py::array_t<std::int8_t> answers(static_cast<py::ssize_t>(points.count()));
  std::int8_t* const answer = answers.mutable_data();
  {
    const py::gil_scoped_release unlocked;
    self.body.inside(std::span<const std::array<double, 3>>());  // an open surface is refused without points too
  }
  for_each_point(points, [&](std::size_t k) {
    answer[k] =
        std::int8_t(points.is_exact_text() ? self.body.inside_text(points.text(k)) : self.body.inside(points.row(k)));
  });
  if (points.is_one()) return py::int_(int(answer[0]));
  return answers;
}

py::tuple nearest(const Python_body& self, const py::object& values)
{
  const Points points(values, "points", "point");
  std::vector<Nearest_point> answers(points.count());
  {
    const py::gil_scoped_release unlocked;
    self.body.nearest(std::span<const std::array<double, 3>>());  // an open surface is refused without points too
  }
  for_each_point(points, [&](std::size_t k) {
    answers[k] = points.is_exact_text() ? self.body.nearest_text(points.text(k)) : self.body.nearest(points.row(k));
  });
  const auto count = static_cast<py::ssize_t>(answers.size());
  py::array_t<double> distances(count), at({count, py::ssize_t(3)});
  py::array_t<bool> only(count);
  py::list holders;
  for (std::size_t k = 0; k < answers.size(); ++k) {
    distances.mutable_data()[k] = answers[k].distance;
    std::ranges::copy(answers[k].point, at.mutable_data() + 3 * k);
    only.mutable_data()[k] = answers[k].is_only;
    holders.append(answers[k].holder.text());
  }
  if (points.is_one())
    return py::make_tuple(answers[0].distance, at.attr("reshape")(3), holders[0], answers[0].is_only);
  return py::make_tuple(distances, at, py::module_::import("numpy").attr("array")(holders, "str"), only);
}

/// One number, or an array (n,) of numbers, which are doubles.
class Column {
 public:
  Column(const py::object& values, const std::string& name) : name_(name), numbers_(values, name)
  {
    if (numbers_.dimensions() > 1)
      throw Error(name + ": an array of shape " + numbers_.shape() + "; expected (n,), or one number");
    if (numbers_.is_exact_text()) throw Error(name + ": numbers that are no doubles; expected doubles");
  }

  bool is_one() const { return numbers_.dimensions() == 0; }
  std::size_t count() const { return is_one() ? 1 : numbers_.extent(0); }
  double operator()(std::size_t k) const
  {
    double value = 0;
    std::memcpy(&value, numbers_.data() + (is_one() ? 0 : numbers_.stride(0) * std::ptrdiff_t(k)), sizeof value);
    return value;
  }
  std::string name(std::size_t k) const { return is_one() ? name_ : name_ + "[" + std::to_string(k) + "]"; }

 private:
  std::string name_;
  Numbers numbers_;
};

/// Returns the ends of rays; None is no end.
Column ends_of(const py::object& end)
{
  return Column(end.is_none() ? py::float_(std::numeric_limits<double>::infinity()) : end, "end");
}

/// Numbers of faces; -1 stands for no face, as `first_hit` returns it.
class Face_numbers : public Column {
 public:
  explicit Face_numbers(const py::object& values) : Column(values, "faces") {}

  /// Returns what ask(face k) returns, and `none` for no face. Throws Error with the place of a number that is no
  /// face's.
  template <class Answer, class Ask>
  Answer answer(std::size_t k, const Answer& none, const Ask& ask) const
  {
    const double number = (*this)(k);
    if (number == -1) return none;
    const auto face = index_of(number);
    if (!face) throw Error(name(k) + ": " + kernel::shortest(number) + "; expected a face's number, or -1 for no face");
    try {
      return ask(*face);
    } catch (const Error& error) {
      throw renamed(error, "body:", name(k) + ":");
    }
  }
};

/// Rays of as many directions as origins; one of either serves all of the other. `more` has a number for each ray, or
/// one for all.
class Rays {
 public:
  Rays(const py::object& origins, const py::object& directions, const Column& more)
      : origins_(origins, "origins", "origin"), directions_(directions, "directions", "direction"), more_(more)
  {
    for (const Points* rows : {&origins_, &directions_})
      if (rows->is_exact_text()) throw Error(rows->name(0) + ": numbers that are no doubles; expected doubles");
    count_ = common_count("rays", origins_.count(), " origins", directions_.count(), " directions");
    if (!are_one() && !more.is_one() && count_ != more.count())
      throw Error("rays: " + std::to_string(count_) + " of them, and " + std::to_string(more.count()) +
                  " numbers for them; expected as many, or one of either");
  }

  bool is_one() const { return are_one() && more_.is_one(); }
  std::size_t count() const { return are_one() ? more_.count() : count_; }

  /// Returns what ask(ray k) returns. Throws Error with the ray's name.
  template <class Ask>
  auto answer(std::size_t k, const Ask& ask) const
  {
    try {
      return ask(Ray{origins_.row(origins_.count() == 1 ? 0 : k), directions_.row(directions_.count() == 1 ? 0 : k)});
    } catch (const Error& error) {
      throw renamed(error, "ray:", is_one() ? "ray:" : "rays[" + std::to_string(k) + "]:");
    }
  }

 private:
  bool are_one() const { return origins_.is_one() && directions_.is_one(); }

  Points origins_, directions_;
  std::size_t count_ = 0;
  const Column& more_;
};

py::object first_hit(const Python_body& self, const py::object& origins, const py::object& directions,
                     const py::object& end)
{
  const Column ends = ends_of(end);
  const Rays rays(origins, directions, ends);
  const auto count = static_cast<py::ssize_t>(rays.count());
  py::array_t<std::int64_t> faces(count);
  py::array_t<double> ts(count);
  std::int64_t* const face = faces.mutable_data();
  double* const t = ts.mutable_data();
  for_each_unlocked(rays.count(), no_lock, [&](std::size_t k) {
    const auto hit = rays.answer(k, [&](const Ray& ray) { return self.body.first_hit(ray, ends(k)); });
    face[k] = hit ? std::int64_t(hit->face) : -1;
    t[k] = hit ? hit->t : std::numeric_limits<double>::infinity();
  });
  if (rays.is_one()) return py::make_tuple(face[0], t[0]);
  return py::make_tuple(faces, ts);
}

py::object is_hit(const Python_body& self, const py::object& origins, const py::object& directions,
                  const py::object& end)
{
  const Column ends = ends_of(end);
  const Rays rays(origins, directions, ends);
  py::array_t<bool> answers(static_cast<py::ssize_t>(rays.count()));
  bool* const answer = answers.mutable_data();
  for_each_unlocked(rays.count(), no_lock, [&](std::size_t k) {
    answer[k] = rays.answer(k, [&](const Ray& ray) { return self.body.is_hit(ray, ends(k)); });
  });
  if (rays.is_one()) return py::bool_(answer[0]);
  return answers;
}

py::object crossings(const Python_body& self, const py::object& origins, const py::object& directions,
                     const py::object& of_faces)
{
  const Face_numbers faces(of_faces);
  const Rays rays(origins, directions, faces);
  std::vector<std::string_view> found(rays.count());
  for_each_unlocked(rays.count(), no_lock, [&](std::size_t k) {
    found[k] = rays.answer(k, [&](const Ray& ray) {
      return faces.answer(k, std::string_view(), [&](Index face) { return to_string(self.body.crossing(ray, face)); });
    });
  });
  if (rays.is_one()) return py::str(std::string(found[0]));
  py::list words;
  for (const std::string_view word : found) words.append(std::string(word));
  return py::module_::import("numpy").attr("array")(words, "U8");
}

py::object face_normals(const Python_body& self, const py::object& of_faces)
{
  const Face_numbers faces(of_faces);
  py::array_t<double> rows({static_cast<py::ssize_t>(faces.count()), py::ssize_t(3)});
  double* const row = rows.mutable_data();
  std::array<double, 3> no_normal{};
  no_normal.fill(std::numeric_limits<double>::quiet_NaN());
  for_each_unlocked(faces.count(), no_lock, [&](std::size_t k) {
    std::ranges::copy(faces.answer(k, no_normal, [&](Index face) { return self.body.normal(face); }), row + 3 * k);
  });
  return faces.is_one() ? py::object(rows.attr("reshape")(3)) : rows;
}

py::tuple hits(const Python_body& self, const py::object& origins, const py::object& directions, const py::object& end)
{
  const Column ends = ends_of(end);
  const Rays rays(origins, directions, ends);
  std::vector<std::int64_t> ray_of, faces;
  std::vector<double> ts;
  for_each_unlocked(rays.count(), no_lock, [&](std::size_t k) {
    for (const Ray_hit& hit : rays.answer(k, [&](const Ray& ray) { return self.body.hits(ray, ends(k)); })) {
      ray_of.push_back(std::int64_t(k));
      faces.push_back(std::int64_t(hit.face));
      ts.push_back(hit.t);
    }
  });
  const auto array = [](const auto& values) {
    using Value = typename std::decay_t<decltype(values)>::value_type;
    return py::array_t<Value>(static_cast<py::ssize_t>(values.size()), values.data());
  };
  return py::make_tuple(array(ray_of), array(faces), array(ts));
}

using Body_class = py::class_<Python_body, std::shared_ptr<Python_body>>;

/// Adds what is asked of points.
void add_points(Body_class& body)
{
  body.def("inside", &inside, py::arg("points"), R"(inside(points)

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
      .def("nearest", &nearest, py::arg("points"), R"(nearest(points)

The signed distances of points, negative inside the solid, and the points of the surface nearest to them: (distances,
points, holders, only). Exact: each number is the double nearest to the exact one. A holder is "vertex V", "edge V V" or
"face F". Where other points are as near, `only` is False.

points: array (n, 3) of doubles or fractions -> arrays (n,) of float64, (n, 3) of float64, (n,) of str, (n,) of bool.
One point (3,) -> a float, an array (3,), a str and a bool.
Raises Error for an open surface, and for a number that is not finite, which it names.

>>> import tetracone
>>> body = tetracone.Body([[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> body.nearest([[1, 1, -2], [-3, 0, -4], [1, 1, 0.5]])[0]
array([ 2. ,  5. , -0.5])
>>> body.nearest([-3, 0, -4])[1:]
(array([0., 0., 0.]), 'vertex 0', True)
)");
}

/// Adds what is asked of rays.
void add_rays(Body_class& body)
{
  const auto origins = py::arg("origins"), directions = py::arg("directions");
  const auto end = py::arg("end") = py::none();
  body.def("first_hit", &first_hit, origins, directions, end, R"(first_hit(origins, directions, end=None)

The first face that each ray origin + t direction, t >= 0, meets, and t: (faces, t). Exact: of least t, and of those the
face of the least number; each t is the double nearest to the exact one. Where a ray meets nothing, -1 and infinity; nor
is anything met at a t above `end`, compared exactly: 1 where a ray is the segment from its origin along its direction.

origins, directions: arrays (n, 3) of doubles, or one (3,) for all -> arrays (n,) of int64 and of float64; one ray -> an
int and a float. A direction may have any length but 0. The surface may be open.
end: a double for all rays, or an array (n,) of them; None is no end.
Raises Error for a number that is not finite, for a direction of 0 and for an end of nan, with the ray.

>>> import tetracone
>>> body = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> body.first_hit([[0.25, 0.25, -1], [2, 2, 2]], [0, 0, 3])
(array([ 0, -1]), array([0.33333333,        inf]))
>>> body.first_hit([0.25, 0.25, 9], [0, 0, -1])
(3, 8.5)
)")
      .def("is_hit", &is_hit, origins, directions, end, R"(is_hit(origins, directions, end=None)

Whether each ray meets some face at a t of at most `end`: array (n,) of bool; one ray -> a bool. It costs less than
first_hit. Arguments and errors are as of first_hit.

>>> import tetracone
>>> body = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> body.is_hit([0.25, 0.25, 9], [0, 0, -1], end=[8.5, 8])
array([ True, False])
)");
}

/// Adds how rays go through faces.
void add_crossed_faces(Body_class& body)
{
  const auto origins = py::arg("origins"), directions = py::arg("directions");
  const auto end = py::arg("end") = py::none();
  body.def("crossings", &crossings, origins, directions, py::arg("faces"), R"(crossings(origins, directions, faces)

How each ray goes through a face that it meets: array (n,) of "entering" against the face's normal, "leaving" with it,
and "along" its plane. One ray and face -> a str. For face -1, which first_hit says where there is none, it is "".

faces: an array (n,) of faces' numbers, or one for all. Raises Error for a number out of range, and as first_hit.

>>> import tetracone
>>> body = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> rays, faces, t = body.hits([0.25, 0.25, -1], [0, 0, 1])
>>> body.crossings([0.25, 0.25, -1], [0, 0, 1], faces).tolist()
['entering', 'leaving']
)")
      .def("normals", &face_normals, py::arg("faces"), R"(normals(faces)

The unit normals of faces, to the side that sees their loops counterclockwise: outward where faces are oriented outward.
Each component is the double nearest to the exact one. All are 0 for a face without area, and nan for face -1.

faces: an array (n,) of faces' numbers -> array (n, 3) of float64; one -> array (3,). Raises Error for a number out of
range.

>>> import tetracone
>>> body = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> body.normals([0, 3])
array([[ 0.        ,  0.        , -1.        ],
       [ 0.57735027,  0.57735027,  0.57735027]])
)")
      .def("hits", &hits, origins, directions, end, R"(hits(origins, directions, end=None)

Every face that each ray meets, once each, where it first does: (rays, faces, t), an entry a face, by rays, then in the
exact order of t, then of faces. A ray in a face's plane meets it where it comes to the closed face.

origins, directions, end: as first_hit -> arrays (m,) of int64, int64 and float64. Raises Error as first_hit.

>>> import tetracone
>>> body = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> body.hits([0.25, 0.25, -1], [[0, 0, 1], [0, 1, 0]])
(array([0, 0]), array([0, 3]), array([1. , 1.5]))
)");
}

/// Adds what is done with the tree.
void add_trees(Body_class& body)
{
  body.def(
          "make_all", [](const Python_body& self, std::size_t threads) { self.body.make_all(threads); },
          py::arg("threads") = 1, py::call_guard<py::gil_scoped_release>(),
          R"(make_all(threads=1)

Builds the whole tree of the method `tree` now, with `threads` threads (0: all cores), instead of on demand.

>>> import tetracone
>>> tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]).make_all()
)")
      .def("save", &save, py::arg("path"), R"(save(path)

Saves the body with its whole tree to a file *.body that `read` takes. `read` maps the file and builds nothing again.
Raises Error for another suffix, and for a file that cannot be written; then nothing is left behind.

>>> import tetracone, tempfile, pathlib
>>> with tempfile.TemporaryDirectory() as folder:
...     file = pathlib.Path(folder, "triangle.body")
...     tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]).save(file)
...     tetracone.read(file)
Body(3 vertices, 1 faces, open)
)");
}

/// Adds where the surface meets itself.
void add_self_contacts(Body_class& body)
{
  body.def(
          "self_intersections", [](const Python_body& self) { return self.body.self_intersections(); },
          py::call_guard<py::gil_scoped_release>(), R"(self_intersections()

All pairs of faces that intersect improperly, and where, exactly: Contacts, each pair once with the smaller number
first. Two faces may share the vertices and edges that both have, by coordinates, and nothing else.

>>> import tetracone
>>> body = tetracone.Body([[0, 0, 0], [4, 0, 0], [0, 4, 0], [1, 1, -1], [1, 1, 1], [9, 9, 0]], [[0, 1, 2], [3, 4, 5]])
>>> body.self_intersections().faces
array([[0, 1]], dtype=uint32)
>>> body.is_simple
False
)")
      .def_property_readonly(
          "is_simple",
          [](const Python_body& self) {
            const py::gil_scoped_release unlocked;
            return self.body.is_simple();
          },
          "True when no two faces intersect improperly, see self_intersections; decided once, exactly.");
}

/// Adds the parts of the polyhedron.
void add_parts(Body_class& body)
{
  body.def_property_readonly(
          "is_closed", [](const Python_body& self) { return self.body.is_closed(); },
          "True when every directed edge occurs as often as its reverse: then the body bounds a solid.")
      .def_property_readonly(
          "vertices",
          [](const py::object& self) { return vertices_of(self.cast<const Python_body&>().body.polyhedron(), self); },
          "The vertices: array (n, 3) of doubles, a read-only view.")
      .def_property_readonly(
          "faces", [](const Python_body& self) { return faces_of(self.body.polyhedron()); },
          "The faces: a list of faces, each a list of loops, each a tuple of vertex numbers.")
      .def("__repr__",
           [](const Python_body& self) {
             const Polyhedron& p = self.body.polyhedron();
             return "Body(" + std::to_string(p.vertices.size()) + " vertices, " + std::to_string(p.face_count()) +
                    " faces, " + (self.body.is_closed() ? "closed)" : "open)");
           })
      .def_property_readonly("triangles", &triangles_of,
                             "The triangles that stand for faces of more than three corners: array (n, 4) of uint32.")
      .def("__reduce__", [](const py::object& self) {
        return py::make_tuple(py::type::of(self),
                              py::make_tuple(self.attr("vertices"), self.attr("faces"), self.attr("triangles")));
      });
}

}  // namespace

void add_body(py::module_& module)
{
  Body_class body(module, "Body", R"(Body(vertices, faces, triangles=None)

A polyhedron that queries can be asked about. Immutable, and shared by any number of threads.

vertices: array (n, 3) of doubles, taken exactly; of texts, a decimal is the double nearest to it.
faces: array (m, k) of vertex numbers, or a sequence of faces. Each face is a sequence of numbers, or of loops of
numbers. The outer boundary is the first loop; holes follow, which run the other way round.
triangles: array (n, 4) of a face and three vertices each, which cover some faces exactly, in their direction. Any other
face of more than three corners becomes a fan if it can.

Open and closed surfaces, several shells, cavities and degenerate elements are legal. Faces of more than three corners
must be exactly planar. Raises Error for what is no polyhedron.

>>> import tetracone
>>> body = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> body
Body(4 vertices, 4 faces, closed)
)");
  body.def(py::init(&made), py::arg("vertices"), py::arg("faces"), py::arg("triangles") = py::none());
  add_points(body);
  add_rays(body);
  add_crossed_faces(body);
  add_trees(body);
  add_self_contacts(body);
  add_parts(body);
  module.def("read", &read, py::arg("path"), R"(read(path)

The body of a file: OFF, OBJ, PLY, STL or TetGen .poly, or one that was saved (.body), by the suffix. Raises Error,
"file:line: what is wrong; what was expected", for a file that is none, and as Body does.

>>> import tetracone, tempfile, pathlib
>>> with tempfile.TemporaryDirectory() as folder:
...     file = pathlib.Path(folder, "triangle.off")
...     _ = file.write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
...     tetracone.read(file)
Body(3 vertices, 1 faces, open)
)");
}

}  // namespace tetracone::python
