#include "experiments/accuracy/dataset.h"

#include "experiments/support/csv_row.h"
#include "experiments/support/output_file.h"
#include "experiments/support/progress.h"
#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/write.h"
#include "tetracone/covering/repair/repair.h"
#include "tetracone/kernel/number/number.h"
#include "verify/cases/families.h"
#include "verify/truth/cgal_truth.h"
#include "verify/truth/distance_to_degeneracy.h"
#include "verify/truth/integer_truth.h"
#include "verify/truth/predicate_truth.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tetracone::experiments {
namespace {

using kernel::Question;
using Json = nlohmann::ordered_json;

constexpr const char* readme = R"(# Collisions with exact truth

Configurations of two polyhedra under two poses, and of seven points, most of them degenerate or nearly so, each with its true answer. Made
by `tetracone experiment dataset`; every truth was computed twice, in rational and in integer arithmetic that share no code.

All numbers are exact. A decimal stands for the double nearest to it, a fraction n/d for itself. In JSON decimals are numbers, `surface` and
`solid` true or false, and fractions, `inf` and `-inf` strings. A pose is x -> M x + t, row-major 3x4, and is
taken exactly: M is a true rotation only where its entries are fractions.

- `cases.csv`, `cases.json`: one row a case. `id`; `family`, `index`, `parameter`, `seed`: what made it; `mesh_a`, `mesh_b`: files in `meshes/` (OFF, closed, triangles,
  outward unless the family is about that; `meshes` of one case are exact copies of polyhedra whose larger faces were triangulated without new
  vertices); `a00` .. `a23`, `b00` .. `b23`: the poses; `surface`: 1 when the two surfaces share a point; `solid`: 1 when the two solids do (touching counts, in a single
  point too; one inside the other collides, one inside the other's cavity does not); `log2_rho`, `log2_ulps`: how far from degenerate (-inf: exactly; inf: nothing near).
- `predicates.csv`: one row a predicate and case. Points v0 v1 v2 v3 under pose a, p q r under pose b. `truth` by `predicate`: orientation: sign of
  det[v1-p, v2-p, v3-p]; tetra-cone: p in the closed cone from v0 through v1 v2 v3; tetrahedron: p in the closed tetrahedron v0 v1 v2 v3; segment-triangle:
  the segment p q meets the triangle v1 v2 v3; solid: p inside (1), on (0) or outside (-1) the tetrahedron; classification: the triangle p q r meets the
  closed cone from v0 through v1 v2 v3.
- `example.py`: reads the cases and counts the wrong answers of a function. Put your library in its place.
)";

constexpr const char* example = R"(#!/usr/bin/env python3
"""Counts the wrong answers of `collide` on the cases. Put your library in its place."""
import json
import os
from collections import Counter
from fractions import Fraction

folder = os.path.dirname(os.path.abspath(__file__))


def read_off(name):
    with open(os.path.join(folder, "meshes", name)) as file:
        words = iter(file.read().split())
    assert next(words) == "OFF"
    vertices, faces, _ = int(next(words)), int(next(words)), next(words)
    points = [tuple(float(next(words)) for _ in range(3)) for _ in range(vertices)]
    return points, [tuple(int(next(words)) for _ in range(int(next(words)))) for _ in range(faces)]


def placed(points, row, body):
    pose = [float(Fraction(row[f"{body}{i}{j}"])) for i in range(3) for j in range(4)]
    return [tuple(sum(pose[4 * i + k] * p[k] for k in range(3)) + pose[4 * i + 3] for i in range(3)) for p in points]


def collide(a, faces_a, b, faces_b):
    """A toy: whether the boxes of the two bodies meet."""
    return all(min(p[i] for p in a) <= max(p[i] for p in b) and min(p[i] for p in b) <= max(p[i] for p in a) for i in range(3))


meshes, count = {}, Counter()
with open(os.path.join(folder, "cases.json")) as file:
    for row in json.load(file):
        for name in (row["mesh_a"], row["mesh_b"]):
            if name not in meshes:
                meshes[name] = read_off(name)
        (a, faces_a), (b, faces_b) = meshes[row["mesh_a"]], meshes[row["mesh_b"]]
        answer = collide(placed(a, row, "a"), faces_a, placed(b, row, "b"), faces_b)
        count[row["family"], "cases"] += 1
        count[row["family"], "wrong"] += answer != row["solid"]
for family in dict.fromkeys(family for family, _ in count):
    print(f"{family}: {count[family, 'wrong']} wrong of {count[family, 'cases']}")
)";

/// A double is a number, any other rational a string n/d.
Json number(const kernel::Pose& pose, int k)
{
  if (!pose.is_rational()) return pose[k];
  const std::string text = kernel::exact_text(pose.exact(k));
  return text.find('/') == std::string::npos ? Json(pose[k]) : Json(text);
}

/// JSON has no number for an infinite one.
Json finite_or_text(double x)
{
  if (std::isinf(x)) return x < 0 ? "-inf" : "inf";
  return x;
}

Json of_distance(double log2) { return finite_or_text(std::round(16 * log2) / 16); }

/// The polyhedron as triangles, without new vertices.
covering::Polyhedron as_triangles(const covering::Polyhedron& polyhedron)
{
  covering::Polyhedron triangles;
  triangles.vertices = polyhedron.vertices;
  for (covering::Index f = 0; f < polyhedron.face_count(); ++f) {
    if (polyhedron.is_triangle(f)) {
      triangles.add_polygon(polyhedron.loop(f, 0));
      continue;
    }
    const auto parts = covering::repair::constrained_delaunay(polyhedron, f);
    for (const auto& triangle : parts ? *parts : covering::repair::fan(polyhedron, f)) triangles.add_polygon(triangle);
  }
  return triangles;
}

/// Rows of a table, as CSV and as JSON.
class Rows {
 public:
  /// A value as JSON has it; CSV knows no strings, and 1 and 0 for true and false.
  void add(const std::string& column, const Json& value)
  {
    csv_row_.add(column, csv_of(value));
    json_row_[column] = value;
  }
  void end()
  {
    csv_.add(std::exchange(csv_row_, {}));
    json_.push_back(std::exchange(json_row_, Json::object()));
  }
  const std::string& csv() const { return csv_.text(); }
  std::string json() const { return json_.dump(0) + "\n"; }

 private:
  static std::string csv_of(const Json& value)
  {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_boolean()) return value.get<bool>() ? "1" : "0";
    return value.is_number_float() ? kernel::shortest(value.get<double>()) : value.dump();
  }

  Csv_row csv_row_;
  Csv_table csv_;
  Json json_row_ = Json::object(), json_ = Json::array();
};

void add_pose(Rows& rows, char body, const kernel::Pose& pose)
{
  for (int k = 0; k < 12; ++k) rows.add(body + std::to_string(k / 4) + std::to_string(k % 4), number(pose, k));
}

void add_origin(Rows& rows, const verify::Origin& origin)
{
  rows.add("id", origin.family + "-" + std::to_string(origin.index));
  rows.add("family", origin.family);
  rows.add("index", origin.index);
  rows.add("parameter", finite_or_text(origin.parameter));
  rows.add("seed", origin.seed);
}

void agree(bool same)
{
  if (!same) throw std::runtime_error("the two truths disagree; tetracone verify says where");
}

/// The meshes by their text: one file for all cases that share a polyhedron.
class Meshes {
 public:
  explicit Meshes(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::string name_of(const covering::Polyhedron& polyhedron)
  {
    const std::string text = covering::write_off(polyhedron);
    const auto [found, is_new] = names_.try_emplace(text, "m" + std::to_string(names_.size()) + ".off");
    if (is_new) write_whole(folder_ / found->second, text);
    return found->second;
  }

 private:
  std::filesystem::path folder_;
  std::map<std::string, std::string> names_;
};

}  // namespace

void export_dataset(const std::filesystem::path& out, std::uint64_t cases, std::uint64_t seed)
{
  const std::filesystem::path folder = out / "dataset";
  make_folder(folder / "meshes");
  Meshes meshes(folder / "meshes");
  Rows objects, predicates;
  Progress progress("cases", 2 * cases * verify::families().size());
  for (const verify::Family& family : verify::families())
    for (std::uint64_t k = 0; k < cases; ++k) {
      verify::Object_case c = family.object_case(seed, k);
      c.a = std::make_shared<const covering::Polyhedron>(as_triangles(*c.a));
      c.b = std::make_shared<const covering::Polyhedron>(as_triangles(*c.b));
      const verify::Brute_body a(*c.a), b(*c.b);
      add_origin(objects, c.origin);
      objects.add("mesh_a", meshes.name_of(*c.a));
      objects.add("mesh_b", meshes.name_of(*c.b));
      for (const Question question : {Question::surface, Question::solid}) {
        const bool truth = verify::collide(a, c.pose_a, b, c.pose_b, question);
        agree(truth == verify::integer_truth::collide(c, question));
        objects.add(question == Question::solid ? "solid" : "surface", truth);
      }
      const verify::Distance away = verify::distance(c);
      objects.add("log2_rho", of_distance(away.log2_rho));
      objects.add("log2_ulps", of_distance(away.log2_ulps));
      add_pose(objects, 'a', c.pose_a);
      add_pose(objects, 'b', c.pose_b);
      objects.end();
      progress.step();

      const verify::Predicate_case p = family.predicate_case(seed, k);
      for (const verify::Predicate predicate : verify::all_predicates) {
        const auto truth = verify::true_answer(predicate, p);
        agree(truth == verify::integer_truth::answer(predicate, p));
        if (!truth) continue;
        add_origin(predicates, p.origin);
        predicates.add("predicate", verify::to_string(predicate));
        predicates.add("truth", *truth);
        const verify::Distance from = verify::distance(predicate, p);
        predicates.add("log2_rho", of_distance(from.log2_rho));
        predicates.add("log2_ulps", of_distance(from.log2_ulps));
        const std::pair<const char*, const kernel::Vertex*> points[] = {
            {"v0", &p.v[0]}, {"v1", &p.v[1]}, {"v2", &p.v[2]}, {"v3", &p.v[3]}, {"p", &p.p}, {"q", &p.q}, {"r", &p.r}};
        for (const auto& [name, point] : points)
          for (int i = 0; i < 3; ++i) predicates.add(name + std::string(1, "xyz"[i]), (*point)[i]);
        add_pose(predicates, 'a', p.pose_a);
        add_pose(predicates, 'b', p.pose_b);
        predicates.end();
      }
      progress.step();
    }
  write_whole(folder / "cases.csv", objects.csv());
  write_whole(folder / "cases.json", objects.json());
  write_whole(folder / "predicates.csv", predicates.csv());
  write_whole(folder / "README.md", readme);
  write_whole(folder / "example.py", example);
}

}  // namespace tetracone::experiments
