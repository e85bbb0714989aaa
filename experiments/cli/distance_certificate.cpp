#include "experiments/cli/distance_certificate.h"

#include "tetracone/covering/repair/repair.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "tetracone/tetratree/query/distance_cover.h"

#include <nlohmann/json.hpp>

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace tetracone::experiments {
namespace {

using Json = nlohmann::ordered_json;
using covering::Index;
using kernel::Rational;

/// A body and its triangles, by their numbers in the certificate.
struct Certified_body {
  std::vector<covering::Face_triangle> triangles;
  tetratree::Bvh8 tree;
  std::map<std::pair<Index, std::array<Index, 3>>, std::size_t> number;

  explicit Certified_body(const covering::Polyhedron& polyhedron)
      : triangles(covering::triangulate_faces(polyhedron)), tree(polyhedron, triangles)
  {}
};

std::string text(double x) { return kernel::to_string(Rational(x)); }

/// The elements of the tree: triangles, and faces on a line by their corners.
Json pieces_of(Certified_body& body, const covering::Polyhedron& polyhedron)
{
  std::vector<bool> has_triangles(polyhedron.face_count(), false);
  Json pieces = Json::array();
  const auto add = [&](Index f, const std::array<Index, 3>& key, std::vector<Index> corners) {
    body.number[{f, key}] = pieces.size();
    Json piece = {{"face", f}, {"corners", corners}};
    pieces.push_back(std::move(piece));
  };
  for (const auto& t : body.triangles) {
    has_triangles[t.face] = true;
    add(t.face, t.corner, {t.corner.begin(), t.corner.end()});
  }
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    if (has_triangles[f]) continue;
    const auto loop = polyhedron.loop(f, 0);
    const auto& covering = body.tree.model().covering();
    if (!covering.plane_basis(f)) {
      const auto from = covering.from(f);
      add(f, {covering::none, covering::none, covering::none}, {from.begin(), from.end()});
    } else if (polyhedron.is_triangle(f)) {
      add(f, {loop[0], loop[1], loop[2]}, {loop.begin(), loop.end()});
    } else {
      throw Error("certificate: face " + std::to_string(f) +
                  " cannot be triangulated without new vertices; expected loops that don't cross");
    }
  }
  return pieces;
}

Json body_as_json(Certified_body& body, const covering::Polyhedron& polyhedron)
{
  Json vertices = Json::array(), faces = Json::array();
  for (const auto& v : polyhedron.vertices) vertices.push_back({text(v[0]), text(v[1]), text(v[2])});
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    Json loops = Json::array();
    for (std::size_t k = 0; k < polyhedron.loop_count(f); ++k) {
      const auto loop = polyhedron.loop(f, k);
      loops.push_back(std::vector<Index>(loop.begin(), loop.end()));
    }
    faces.push_back(std::move(loops));
  }
  return {{"vertices", vertices}, {"faces", faces}, {"pieces", pieces_of(body, polyhedron)}};
}

Json pose_as_json(const kernel::Pose& pose)
{
  Json rows = Json::array();
  for (int k = 0; k < 12; ++k) rows.push_back(kernel::to_string(pose.exact(k)));
  return rows;
}

/// A direction of integers without a common factor.
Json axis_of(const kernel::Exact_vector& m)
{
  std::array<Rational, 3> r;
  mpz_class common = 1, factor = 0;
  for (int k = 0; k < 3; ++k) {
    r[k] = Rational(m[k]);
    common = lcm(common, r[k].get_den());
  }
  for (int k = 0; k < 3; ++k) {
    r[k] *= common;
    factor = gcd(factor, r[k].get_num());
  }
  Json axis = Json::array();
  for (int k = 0; k < 3; ++k) axis.push_back(mpz_class(r[k].get_num() / factor).get_str());
  return axis;
}

Json cover_as_json(const Certified_body& a, const Certified_body& b, const kernel::Pose& pose_a,
                   const kernel::Pose& pose_b, const Nearest& nearest)
{
  // The direction times a common denominator, and the square in the coordinates of exact vertices.
  std::array<Rational, 3> way;
  mpz_class common = 1;
  for (int k = 0; k < 3; ++k) {
    way[k] = Rational(nearest.point[1][k]) - Rational(nearest.point[0][k]);
    common = lcm(common, way[k].get_den());
  }
  const auto exact = [](const mpz_class& x) {
    kernel::Exact_number value = 0;
    const std::string digits = mpz_class(abs(x)).get_str(16);
    for (const char digit : digits)
      value = value * kernel::Exact_number(16) + kernel::Exact_number(digit <= '9' ? digit - '0' : digit - 'a' + 10);
    return sgn(x) < 0 ? kernel::Exact_number(-value) : value;
  };
  kernel::Exact_vector direction;
  for (int k = 0; k < 3; ++k) direction[k] = exact(mpz_class(Rational(way[k] * common).get_num()));
  const Rational square(nearest.squared);
  const kernel::Exact_number weight = pose_a.weight() * pose_b.weight();
  const tetratree::Distance_cover cover(a.tree, pose_a, b.tree, pose_b, direction,
                                        exact(square.get_num()) * weight * weight, exact(square.get_den()));
  Json parts = Json::array();
  for (const auto& part : cover.parts()) {
    std::array<std::vector<std::size_t>, 2> numbers;
    for (int body = 0; body < 2; ++body)
      for (const auto& element : part.elements[body])
        numbers[body].push_back((body == 0 ? a : b).number.at({element.face, element.corner}));
    parts.push_back({{"a", numbers[0]}, {"b", numbers[1]}, {"axis", axis_of(part.direction)}});
  }
  return parts;
}

}  // namespace

std::string distance_certificate(const covering::Polyhedron& a, const covering::Polyhedron& b, const Pose_pairs& poses,
                                 kernel::Question question)
{
  Certified_body of_a(a), of_b(b);
  Json certificate = {{"question", std::string(kernel::to_string(question))},
                      {"a", body_as_json(of_a, a)},
                      {"b", body_as_json(of_b, b)}};
  Json answers = Json::array();
  Query query(Body(a, of_a.triangles), Body(b, of_b.triangles), question);
  for (std::size_t k = 0; k < poses.count(); ++k) {
    const Nearest nearest = query.nearest(poses.of_a(k), poses.of_b(k));
    answers.push_back(
        {{"pose_a", pose_as_json(poses.of_a(k))},
         {"pose_b", pose_as_json(poses.of_b(k))},
         {"squared_distance", nearest.squared},
         {"points", {nearest.point[0], nearest.point[1]}},
         {"holders", {nearest.holder[0].text(), nearest.holder[1].text()}},
         {"cover",
          nearest.squared == "0" ? Json::array() : cover_as_json(of_a, of_b, poses.of_a(k), poses.of_b(k), nearest)}});
  }
  certificate["answers"] = std::move(answers);
  return certificate.dump() + "\n";
}

}  // namespace tetracone::experiments
