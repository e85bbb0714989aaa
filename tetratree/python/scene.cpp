#include "tetracone/tetratree/python/scene.h"

#include "tetracone/tetratree/python/arrays.h"
#include "tetracone/tetratree/python/body.h"
#include "tetracone/tetratree/python/motions.h"
#include "tetracone/tetratree/python/query.h"
#include "tetracone/tetratree/python/texts.h"
#include "tetracone/tetratree/python/unlocked.h"
#include "tetracone/tetratree/scene/scene.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace tetracone::python {

namespace py = pybind11;

namespace {

using Bodies = std::vector<std::shared_ptr<Python_body>>;

/// A scene, its lock, and the Python bodies that are its models.
class Locked_scene {
 public:
  explicit Locked_scene(const Scene_options& options) : scene_(options) {}

  /// Throws Error, as `Python_body::operator new`.
  static void* operator new(std::size_t) { throw Error("scene: not made; expected Scene(bodies)"); }

  /// Returns what(scene), called without the interpreter's lock.
  template <class What>
  auto alone(const What& what)
  {
    const py::gil_scoped_release unlocked;
    const std::lock_guard lock(lock_);
    return what(scene_);
  }

  std::size_t add(const std::shared_ptr<Python_body>& body)
  {
    return alone([&](Scene& scene) {
      const std::size_t number = scene.add_body(model_of(scene, body));
      ++count_;
      return number;
    });
  }
  void remove(std::size_t number)
  {
    alone([&](Scene& scene) {
      scene.remove_body(number);
      --count_;
    });
  }
  void replace(std::size_t number, const std::shared_ptr<Python_body>& body)
  {
    alone([&](Scene& scene) { scene.set_model(number, model_of(scene, body)); });
  }

  std::size_t count() const { return count_; }

 private:
  std::size_t model_of(Scene& scene, const std::shared_ptr<Python_body>& body)
  {
    const auto [known, is_new] = models_.try_emplace(body, 0);
    if (is_new) known->second = scene.add_model(body->body);
    return known->second;
  }

  Scene scene_;
  std::map<std::shared_ptr<Python_body>, std::size_t> models_;
  std::atomic<std::size_t> count_ = 0;  // read without the lock
  std::mutex lock_;                     // never waited for with the interpreter's lock
};

std::shared_ptr<Locked_scene> made_scene(const Bodies& bodies, const py::str& of_question, const py::str& of_kernel,
                                         std::size_t threads, double budget)
{
  const std::string question = text_of(of_question), kernel = text_of(of_kernel);
  const auto asked = kernel::parse_question(question);
  if (!asked) throw Error("scene: question '" + question + "'; expected solid or surface");
  const auto query = parse_kernel(kernel);
  if (!query) throw Error("scene: kernel '" + kernel + "'; expected " + kernel_names());
  if (!(budget >= 0 && budget <= 1e9)) throw Error("scene: budget; expected seconds from 0 to 10^9, 0 for no limit");
  if (threads > 1024) throw Error("scene: " + std::to_string(threads) + " threads; expected 1 to 1024, or 0 for all");
  // The budget is rounded up to whole nanoseconds, since 0 would be no limit.
  const auto scene = std::make_shared<Locked_scene>(
      Scene_options{.question = *asked,
                    .query = *query,
                    .threads = threads,
                    .budget = std::chrono::nanoseconds(static_cast<std::int64_t>(std::ceil(budget * 1e9)))});
  for (const auto& body : bodies) {
    if (!body) throw Error("scene: None among the bodies; expected bodies");
    scene->add(body);
  }
  return scene;
}

/// Returns an array (m, 2) of the bodies' numbers. `pair_of` is a member or a function of an element.
template <class Pairs, class Pair_of = std::identity>
py::array pairs_of(const Pairs& pairs, const Pair_of& pair_of = {})
{
  py::array_t<std::uint32_t> rows({pairs.size(), std::size_t(2)});
  std::uint32_t* row = rows.mutable_data();
  for (const auto& each : pairs) {
    const Scene_pair pair = std::invoke(pair_of, each);
    *row++ = std::uint32_t(pair.a);
    *row++ = std::uint32_t(pair.b);
  }
  return rows;
}

py::array pairs(Locked_scene& self)
{
  return pairs_of(self.alone([](Scene& scene) { return scene.pairs(); }));
}

py::tuple pairs_within(Locked_scene& self, const py::object& limit)
{
  const std::string most = exact_text(limit);
  const std::vector<Scene_distance> found = self.alone([&](Scene& scene) { return scene.pairs_within(most); });
  py::array_t<double> distances(static_cast<py::ssize_t>(found.size()));
  std::ranges::transform(found, distances.mutable_data(), &Scene_distance::distance);
  return py::make_tuple(pairs_of(found, &Scene_distance::pair), distances);
}

py::array frame(Locked_scene& self, const py::object& of_poses)
{
  const Poses poses(of_poses, "poses");
  std::size_t placed = 0;
  const auto ask = [&](Scene& scene) {
    std::vector<Pose> all;
    all.reserve(poses.count());
    for (; placed < poses.count(); ++placed) all.push_back(poses(placed));
    return scene.frame(all);
  };
  try {
    return pairs_of(self.alone(ask));
  } catch (const Error&) {
    if (placed < poses.count()) poses.require(placed);
    throw;
  }
}

/// Returns the pairs that meet, and their times.
py::tuple first_contacts(Locked_scene& self, const py::object& poses_1, const py::args& more, const py::object& poses_0,
                         const py::str& of_kind)
{
  if (!more.empty())
    throw py::type_error(
        "scene: poses at both times by position, whose order was misread; expected first_contacts(poses_0=..., "
        "poses_1=...)");
  const std::string kind = text_of(of_kind);
  std::vector<Scene_contact> found;
  if (poses_0.is_none() && kind == "linear") {
    const Poses poses(poses_1, "poses_1");
    std::vector<Pose> to;
    for (std::size_t k = 0; k < poses.count(); ++k) {
      poses.require(k);
      to.push_back(poses(k));
    }
    found = self.alone([&](Scene& scene) { return scene.first_contacts(to); });
  } else {
    const Motions moving(poses_0, poses_1, kind, "");
    std::vector<Motion> motions;
    for (std::size_t k = 0; k < moving.count(); ++k) motions.push_back(moving(k));
    found = self.alone([&](Scene& scene) { return scene.first_contacts(motions); });
  }
  py::array_t<double> times({found.size(), std::size_t(2)});
  double* time = times.mutable_data();
  for (const Scene_contact& contact : found) {
    *time++ = contact.first.lo;
    *time++ = contact.first.hi;
  }
  return py::make_tuple(pairs_of(found, &Scene_contact::pair), times);
}

void place(Locked_scene& self, std::size_t body, const py::object& of_pose)
{
  const Poses poses(of_pose, "pose");
  if (!poses.is_one()) throw Error("pose: several poses; expected one, (3, 4) or (4, 4)");
  poses.require(0);
  self.alone([&](Scene& scene) { scene.place(body, poses(0)); });
}

/// Returns the method that asks the scene about two bodies, as `Locked_scene::alone` does.
template <class Answer>
auto of_pair(Answer (Scene::*ask)(std::size_t, std::size_t))
{
  return [ask](Locked_scene& self, std::size_t first, std::size_t second) {
    return self.alone([&](Scene& scene) { return (scene.*ask)(first, second); });
  };
}

py::tuple undecided(Locked_scene& self)
{
  const std::vector<Undecided_pair> left = self.alone([](Scene& scene) { return scene.undecided(); });
  py::array_t<double> farthest(static_cast<py::ssize_t>(left.size()));
  std::ranges::transform(left, farthest.mutable_data(), &Undecided_pair::farthest);
  return py::make_tuple(pairs_of(left, &Undecided_pair::pair), farthest);
}

py::dict scene_statistics(Locked_scene& self)
{
  const Frame_statistics done = self.alone([](Scene& scene) { return scene.statistics(); });
  py::dict counts;
  for (const auto& [name, count] : {std::pair("moved", done.moved),
                                    {"kept", done.kept},
                                    {"candidates", done.candidates},
                                    {"queries", done.queries},
                                    {"nodes_made", done.nodes_made},
                                    {"bytes", done.bytes}})
    counts[name] = count;
  return counts;
}

using Scene_class = py::class_<Locked_scene, std::shared_ptr<Locked_scene>>;

/// Adds which bodies there are, and where.
void add_bodies(Scene_class& scene)
{
  scene.def("__len__", &Locked_scene::count)
      .def("add", &Locked_scene::add, py::arg("body").none(false), "add(body)\n\nOne more body; returns its number.")
      .def("remove", &Locked_scene::remove, py::arg("number"),
           "remove(number)\n\nTakes a body out; its number is not used again. Raises Error for a body that is "
           "not there.")
      .def("replace", &Locked_scene::replace, py::arg("number"), py::arg("body").none(false),
           "replace(number, body)\n\nPuts another `Body` in its place. Raises Error for a body that is not there.")
      .def(
          "ignore", of_pair(&Scene::ignore), py::arg("a"), py::arg("b"),
          "ignore(a, b)\n\nLeaves this pair out of all answers about pairs. Raises Error for a body that is not there, "
          "and for a body with itself.")
      .def("place", &place, py::arg("number"), py::arg("pose"),
           "place(number, pose)\n\nPlaces a body from now on: (3, 4) or (4, 4), as `Query` says. Raises Error for a "
           "body that is not there, for several poses, and for a pose that is none.");
}

/// Adds what is asked of all bodies.
void add_frames(Scene_class& scene)
{
  scene
      .def("pairs", &pairs,
           "pairs()\n\nThe pairs of placed bodies that collide now: (m, 2) uint32, in order. Raises Error where there "
           "are bodies and none is placed, and where an open surface is asked for its solid.")
      .def("pairs_within", &pairs_within, py::arg("limit"), R"(pairs_within(limit)

The pairs of placed bodies that are at most `limit` apart, and how far: pairs (m, 2) uint32 and distances (m,) float.
The pairs are in order, and a distance is 0 where they collide. The limit is a number, a fractions.Fraction or a text
"n/d", decided exactly. Raises Error as `pairs` and as `Query.within`.

>>> import numpy as np, tetracone
>>> a = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> scene = tetracone.Scene([a] * 3)
>>> poses = np.tile(np.eye(3, 4), (3, 1, 1))
>>> poses[:, 0, 3] = [0, 1, 2.25]
>>> _ = scene.frame(poses)
>>> pairs, distances = scene.pairs_within("1/4")
>>> pairs.tolist(), distances.tolist()
([[0, 1], [1, 2]], [0.0, 0.25])
)")
      .def("frame", &frame, py::arg("poses"),
           R"(frame(poses)

Places all bodies, (n, 3, 4) or (n, 4, 4) in the order of their numbers, and returns the pairs that collide: (m, 2)
uint32, in order. Raises Error for another number of poses, and for a pose that is none.)")
      .def("first_contacts", &first_contacts, py::arg("poses_1"), py::arg("poses_0") = py::none(),
           py::arg("kind") = "linear",
           R"(first_contacts(poses_1, *, poses_0=None, kind="linear")

Which bodies meet while all of them move, and when first, exactly: pairs (m, 2) uint32 and times (m, 2). Times are
doubles lo <= t <= hi of t in [0, 1] as `Query.first_contact` has them. The order is that of (lo, hi, pair). It is the
order of the exact times, except among times between two neighbouring doubles. The bodies stay where they stood.

poses_1: the poses of all bodies at t = 1, in the order of their numbers.
poses_0: those at t = 0, by keyword; None: where the bodies stand, of a linear motion; of a rigid one the identity.
kind: "linear", of poses as `frame` takes them, or "rigid". A rigid motion takes arrays (n, 7), a quaternion and a
translation, or matrices that are rotations, as `Query.first_contact` says.

Raises Error for another number of poses, for a body that stands nowhere, and as `Query.first_contact`.

>>> import numpy as np, tetracone
>>> a = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> scene = tetracone.Scene([a] * 3)
>>> poses = np.tile(np.eye(3, 4), (3, 1, 1))
>>> poses[:, 0, 3] = [0, 3, 9]
>>> scene.frame(poses).tolist()
[]
>>> poses[:, 0, 3] = [0, -1, 1]
>>> pairs, times = scene.first_contacts(poses)
>>> pairs.tolist(), times.tolist()
([[0, 1], [0, 2]], [[0.5, 0.5], [1.0, 1.0]])
)")
      .def_property_readonly("undecided", &undecided,
                             "Pairs that the budget left undecided in the last frame: (m, 2) uint32; and (m,) float, "
                             "an upper bound of the distance between any point of one body and any point of the "
                             "other.");
}

/// Adds how two bodies stand to each other.
void add_pair_relations(Scene_class& scene)
{
  const auto a = py::arg("a"), b = py::arg("b");
  scene
      .def(
          "relation",
          [](Locked_scene& self, std::size_t first, std::size_t second) {
            return std::string(to_string(self.alone([&](Scene& scene) { return scene.relation(first, second); })));
          },
          a, b,
          "relation(a, b)\n\nThe relation of two placed bodies, as `Query.relation`. Raises Error for a body that is "
          "not there or not placed, and as `Query`.")
      .def(
          "solid_relation",
          [](Locked_scene& self, std::size_t first, std::size_t second) {
            const Solid_contact contact = self.alone([&](Scene& scene) { return scene.solid_relation(first, second); });
            return std::pair(std::string(to_string(contact.relation)), contact.dimension);
          },
          a, b,
          "solid_relation(a, b)\n\nWhich of the eight relations of solids holds for two placed bodies, as "
          "`Query.solid_relation`. Raises Error as `relation`, and as that method.")
      .def(
          "overlap",
          [](Locked_scene& self, std::size_t first, std::size_t second) {
            const Overlap found = self.alone([&](Scene& scene) { return scene.overlap(first, second); });
            return overlap_columns({&found, 1}, true);
          },
          a, b,
          "overlap(a, b)\n\nHow much two placed bodies overlap and touch: as `Query.overlap` says of one pose of each. "
          "Raises Error as `relation`, and as that method.")
      .def(
          "exits",
          [](Locked_scene& self, const py::object& direction, std::size_t first, std::size_t second) {
            const std::array<std::string, 3> along = direction_of(direction);
            const Exits found = self.alone([&](Scene& scene) { return scene.exits(first, second, along); });
            return exit_columns({&found, 1}, true);
          },
          py::arg("direction"), a, b,
          "exits(direction, a, b)\n\nHow far a placed body must be moved along a direction for it and another to part: "
          "as `Query.exits` says of one pose of each. Raises Error as `relation`, and as that method.")
      .def(
          "depth",
          [](Locked_scene& self, std::size_t first, std::size_t second, double relative, std::size_t budget) {
            const Depth found = self.alone([&](Scene& scene) {
              return scene.depth(first, second, {relative, budget});
            });
            return depth_columns({&found, 1}, true);
          },
          a, b, py::kw_only(), py::arg("relative") = 1e-9, py::arg("budget") = 100000,
          "depth(a, b, *, relative=1e-9, budget=100000)\n\nThe least translation of a placed body for it and another "
          "to part: as `Query.depth` says of one pose of each. Raises Error as `relation`, and as that method.");
}

/// Adds where two bodies meet, and how far apart they are.
void add_pair_distances(Scene_class& scene)
{
  const auto a = py::arg("a"), b = py::arg("b");
  scene
      .def(
          "contacts", of_pair(&Scene::contacts), a, b,
          "contacts(a, b)\n\nThe `Contacts` of two placed bodies. Raises Error as `relation`, and as `Query.contacts`.")
      .def("distance", of_pair(&Scene::distance), a, b,
           "distance(a, b)\n\nThe distance of two placed bodies, as `Query.distance`. Raises Error as `relation`, and "
           "as that method.")
      .def(
          "within",
          [](Locked_scene& self, const py::object& limit, std::size_t first, std::size_t second) {
            const std::string most = exact_text(limit);
            return self.alone([&](Scene& scene) { return scene.within(first, second, most); });
          },
          py::arg("limit"), a, b,
          "within(limit, a, b)\n\nWhether that is at most `limit`: a number, a fractions.Fraction or a text \"n/d\", "
          "decided exactly. Raises Error as `relation`, and as `Query.within`.");
}

}  // namespace

void add_scene(py::module_& module)
{
  Scene_class scene(module, "Scene",
                    R"(Scene(bodies=(), question="solid", kernel="adaptive", threads=1, budget=0)

Many bodies, and exactly the pairs of them that collide, frame after frame. Bodies of one `Body` share all that is made
of it. A pair that was apart is not asked again before the motion since can have used up the gap. The interpreter's lock
is released while it answers.

bodies: a sequence of `Body`; their numbers are 0, 1, ...
question, kernel: as of `Query`.
threads: number of threads that share the pairs of a frame; 0: all cores.
budget: seconds for a frame; pairs that are not decided then are `undecided`. 0: no limit.

>>> import numpy as np, tetracone
>>> a = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> scene = tetracone.Scene([a] * 4)
>>> poses = np.tile(np.eye(3, 4), (4, 1, 1))
>>> poses[:, 0, 3] = [0, 1, 2, 3.5]
>>> scene.frame(poses).tolist()
[[0, 1], [1, 2]]
)");
  scene.def(py::init(&made_scene), py::arg("bodies") = py::tuple(), py::arg("question") = "solid",
            py::arg("kernel") = "adaptive", py::arg("threads") = 1, py::arg("budget") = 0.0);
  add_bodies(scene);
  add_frames(scene);
  add_pair_relations(scene);
  add_pair_distances(scene);
  scene.def_property_readonly("statistics", &scene_statistics,
                              "What the last frame, or the last first contacts, have cost: a dict of moved, kept, "
                              "candidates, queries, nodes_made, bytes.");
}

}  // namespace tetracone::python
