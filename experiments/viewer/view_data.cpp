#include "experiments/viewer/view_data.h"

#include "experiments/support/progress.h"
#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/repair/repair.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/predicate/signs.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/door/relation_solver.h"
#include "tetracone/tetratree/paper/collision.h"
#include "verify/subjects/predicate_subject.h"
#include "verify/truth/predicate_truth.h"

#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <set>
#include <span>
#include <tuple>
#include <utility>

namespace tetracone::experiments {
namespace {

using covering::Index;
using covering::Polyhedron;
using kernel::Feature_pair;
using kernel::Pose;
using verify::Subject;
using K = kernel::Adaptive;
using Tree = tetratree::Tetra_tree<K>;
using Node = tetratree::Node<Tree::B>;
using Json = nlohmann::ordered_json;

// More pairs of features, or segments of contacts, in one pose than anybody can see make the page too long to load.
constexpr std::size_t most_features = 2000;
// Parts of overlaps in all poses: 10 MB of a page.
constexpr std::size_t most_parts = 100'000;

std::size_t triangle_count(const Polyhedron& polyhedron)
{
  std::size_t count = 0;
  for (Index f = 0; f < polyhedron.face_count(); ++f)
    for (std::size_t l = 0; l < polyhedron.loop_count(f); ++l) count += polyhedron.loop(f, l).size();
  return count - 2 * polyhedron.face_count();
}

/// The longest side of the box about the points.
double drawn_extent(std::span<const kernel::Vertex> points)
{
  double extent = 0;
  for (std::size_t k = 0; !points.empty() && k < 3; ++k) {
    const auto [low, high] = std::ranges::minmax_element(points, {}, [k](const auto& p) { return p[k]; });
    extent = std::max(extent, (*high)[k] - (*low)[k]);
  }
  return extent;
}

/// Six digits of the extent are enough to draw by: a coordinate far from 0 has more digits before them.
double short_number(double x, double extent)
{
  const double more = std::ceil(std::log10(std::abs(x) / extent));
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", 6 + (more > 0 ? int(std::min(more, 11.0)) : 0), x);
  return std::strtod(text, nullptr);
}

double short_length(double x) { return short_number(x, x); }

template <class Point>
void append(Json& numbers, const Point& p, double extent)
{
  for (int k = 0; k < 3; ++k) numbers.push_back(short_number(p[k], extent));
}

Json faces_data(const Polyhedron& polyhedron)
{
  Json faces = Json::array();
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    Json loops = Json::array();
    for (std::size_t l = 0; l < polyhedron.loop_count(f); ++l) {
      const covering::Loop loop = polyhedron.loop(f, l);
      loops.push_back(std::vector<Index>(loop.begin(), loop.end()));
    }
    faces.push_back(std::move(loops));
  }
  return faces;
}

/// Face and corners of each triangle.
Json triangles_data(const Polyhedron& polyhedron, const covering::Covering& covering)
{
  Json triangles = Json::array();
  for (const auto& t : drawn_triangles(polyhedron, covering))
    for (const Index i : {t.face, t.corner[0], t.corner[1], t.corner[2]}) triangles.push_back(i);
  return triangles;
}

Json covering_data(const covering::Model<K>& model)
{
  Json triangles = Json::array(), signs = Json::array();
  for (const auto& t : model.covering().triangles()) {
    for (const Index v : t.corner) triangles.push_back(v);
    signs.push_back(int(kernel::volume_sign<K>(model.origin(), model.point(t.corner[0]), model.point(t.corner[1]),
                                               model.point(t.corner[2]))));
  }
  return {{"origin", model.lattice().origin}, {"triangles", triangles}, {"signs", signs}};
}

Json nodes_data(const Tree& tree, double extent)
{
  Json level = Json::array(), leaf = Json::array(), tetrahedron = Json::array(), sphere = Json::array(),
       faces = Json::array();
  for (Index n = 1; n < tree.node_count(); ++n) {
    const Node& node = tree.node(n);
    level.push_back(node.level);
    leaf.push_back(int(node.is_leaf));
    for (int i = 1; i < 4; ++i) append(tetrahedron, node.tetrahedron[i], extent);
    append(sphere, node.sphere.centre, extent);
    sphere.push_back(short_length(node.sphere.radius));
    faces.push_back(Json::array());
    if (node.is_leaf)
      for (const Index face : tree.faces(node)) faces.back().push_back(face);
  }
  return {{"level", level}, {"leaf", leaf}, {"tetrahedron", tetrahedron}, {"sphere", sphere}, {"faces", faces}};
}

/// The level of the deepest leaf, and dmax, the longest edge from V0 of a leaf's bounding tetrahedron (see
/// `Tetra_tree::regular_hull`).
Json hull_data(const Tree& tree)
{
  using Hull = tetratree::Regular_hull<Tree::B, Tree::sound>;
  int level = 1;
  double longest = 0;
  for (Index n = 1; n < tree.node_count(); ++n) {
    const Node& node = tree.node(n);
    if (!node.is_leaf) continue;
    level = std::max(level, node.level);
    for (int i = 1; i < 4; ++i) {
      const auto edge = kernel::difference(node.tetrahedron[i], node.tetrahedron[0]);
      longest = std::max(longest, std::hypot(edge[0], edge[1], edge[2]));
    }
  }
  return {{"level", level}, {"dmax", level <= Hull::deepest_convex_level ? short_length(longest) : -1.0}};
}

Json body_data(const Model_file& body, const covering::Covering& covering)
{
  Json vertices = Json::array();
  for (const auto& v : body.polyhedron().vertices)
    for (const double x : v) vertices.push_back(x);
  return {{"name", std::filesystem::path(body.file).filename().string()},
          {"vertices", vertices},
          {"faces", faces_data(body.polyhedron())},
          {"source", body.source_face},
          {"triangles", triangles_data(body.polyhedron(), covering)}};
}

void add_method(Json& body, const Tree& tree, double extent)
{
  body["covering"] = covering_data(tree.model());
  body["depth"] = tree.config().depth;
  body["nodes"] = nodes_data(tree, extent);
  body["hull"] = hull_data(tree);
}

Json poses_data(const std::vector<Pose>& poses)
{
  Json rows = Json::array();
  for (const Pose& pose : poses) rows.push_back(pose.entries());
  return rows;
}

/// The exact pairs and the subject's, each once, with who found them.
Json features_data(const std::vector<Feature_pair>& exact, const std::vector<Feature_pair>& found)
{
  const auto key = [](const Feature_pair& f) { return std::tuple(f.body, f.edge_from, f.edge_to, f.face); };
  const auto without = [&](const std::vector<Feature_pair>& all, const Feature_pair& f) {
    return !std::ranges::binary_search(all, key(f), {}, key);
  };
  Json rows = Json::array();
  const auto add = [&](const Feature_pair& f, int mark) {
    if (rows.size() < most_features) rows.push_back({f.body, f.edge_from, f.edge_to, f.face, int(f.kind), mark});
  };
  // Wrong pairs come first, so that the limit does not hide them.
  for (const Feature_pair& f : found)
    if (without(exact, f)) add(f, 2);
  for (const Feature_pair& f : exact)
    if (without(found, f)) add(f, 1);
  for (const Feature_pair& f : exact)
    if (!without(found, f)) add(f, 0);
  return rows;
}

/// The pieces of all contacts as segments: of a point its own twice, of a polygon its border.
Json contacts_data(const Contacts& contacts)
{
  std::vector<kernel::Vertex> ends;  // two of each segment
  for (std::size_t k = 0; k < contacts.size() && ends.size() < 2 * most_features; ++k)
    for (const auto& loop : contacts.nearest_loops(k)) {
      const bool closed = contacts[k].kind == Piece::polygon || loop.size() == 1;
      for (std::size_t i = closed ? 0 : 1; i < loop.size(); ++i)
        ends.insert(ends.end(), {loop[i == 0 ? loop.size() - 1 : i - 1], loop[i]});
    }
  const double extent = drawn_extent(ends);
  Json segments = Json::array();
  for (std::size_t k = 0; k < ends.size(); k += 2) {
    segments.push_back(Json::array());
    append(segments.back(), ends[k], extent);
    append(segments.back(), ends[k + 1], extent);
  }
  return segments;
}

/// The number of pairs of faces of the file in contact.
std::size_t pair_count(const Contacts& self_intersections, const Model_file& body)
{
  std::set<std::pair<Index, Index>> pairs;
  for (std::size_t k = 0; k < self_intersections.size(); ++k) {
    const Index a = body.source_face[self_intersections[k].face_a], b = body.source_face[self_intersections[k].face_b];
    if (a != b) pairs.emplace(a, b);
  }
  return pairs.size();
}

/// The vector by which A leaves B, and how long it is. Requires interiors that share a point.
Json out_data(Query& query, const Pose& pose_a, const Pose& pose_b, const View_way_out& way)
{
  if (way.is_least()) {
    // A page shows six digits.
    const Depth depth = query.depth(pose_a, pose_b, {.relative = 1e-6});
    return {{"vector", depth.vector}, {"bounds", {depth.low, depth.high}}, {"exact", depth.is_exact}};
  }
  const Exits exits = query.exits(pose_a, pose_b, way.along);
  std::array<double, 3> vector{};
  for (std::size_t k = 0; k < 3; ++k)
    vector[k] = kernel::nearest_double(
        kernel::Rational(*kernel::parse_number(way.along[k]) * kernel::Rational(exits.exact_last)));
  return {{"vector", vector}, {"first", exits.first}, {"last", exits.last}};
}

/// Returns what finds the border of an overlap: the library makes no mesh of it. Requires closed bodies.
std::unique_ptr<detail::Relation_solver> overlap_solver(const Body& a, const Body& b)
{
  const auto shared = [](const Body& body) {  // the copy keeps the data
    return std::shared_ptr<const detail::Body_data>(&detail::data_of(body), [body](const detail::Body_data*) {});
  };
  return detail::relation_solver(shared(a), shared(b));
}

/// The relation of solids, and the border of their overlap, of which at most `parts_left` parts are told.
Json solids_data(Query& query, detail::Relation_solver& overlap, const Pose& pose_a, const Pose& pose_b,
                 const std::optional<View_way_out>& way, std::size_t& parts_left)
{
  const Solid_contact contact = query.solid_relation(pose_a, pose_b);
  Json row = {{"relation", to_string(contact.relation)}, {"dimension", contact.dimension}};
  if (contact.relation == Solid_relation::disjoint || contact.relation == Solid_relation::meet) return row;
  const auto [low, high] = query.overlap_bounds(pose_a, pose_b).volume;
  row["volume"] = short_length(low / 2 + high / 2);
  if (way) row["out"] = out_data(query, pose_a, pose_b, *way);
  const auto parts = overlap.overlap_border(pose_a, pose_b);
  row["parts"] = nullptr;
  if (parts.size() > parts_left) return row;
  parts_left -= parts.size();
  std::vector<kernel::Vertex> corners;
  for (const auto& part : parts)
    for (const auto& [x, y, z] : part)
      corners.push_back({kernel::nearest_double(x), kernel::nearest_double(y), kernel::nearest_double(z)});
  const double extent = drawn_extent(corners);
  row["parts"] = Json::array();
  auto corner = corners.begin();
  for (const auto& part : parts) {
    row["parts"].push_back(Json::array());
    for (std::size_t i = 0; i < part.size(); ++i) append(row["parts"].back(), *corner++, extent);
  }
  return row;
}

/// The distance, the two nearest points and what holds them.
Json nearest_data(const Nearest& nearest, const std::vector<Model_file>& bodies)
{
  Json row = Json::array({nearest.distance});
  for (const auto& point : nearest.point)
    for (const std::string& x : point) row.push_back(kernel::nearest_double(kernel::Rational(x)));
  for (std::size_t k = 0; k < 2; ++k) row.push_back(named_as_in_file(nearest.holder[k], bodies[k]).text());
  return row;
}

/// The six numbers of each ray, and the face of the file and t of each hit. Triangles of one face that share the point
/// are one hit.
Json rays_data(const Model_file& model, const std::vector<std::array<double, 6>>& rays)
{
  Json rows = Json::array();
  for (const auto& r : rays) {
    std::set<std::pair<double, Index>> met;
    for (const Ray_hit& hit : model.body.hits({{r[0], r[1], r[2]}, {r[3], r[4], r[5]}}))
      met.emplace(hit.t, model.source_face[hit.face]);
    Json hits = Json::array();
    for (const auto& [t, face] : met) {
      hits.push_back(face);
      hits.push_back(t);
    }
    rows.push_back({r, hits});
  }
  return rows;
}

/// The time of each pose, when the bodies first meet, and what meets. For each body it has the part in words, its
/// numbers, and whether it is a face.
Json motion_data(const View_motion& motion, const std::vector<Model_file>& bodies)
{
  Json row = {{"times", motion.times}};
  if (!motion.first) return row;
  row["first"] = {motion.first->lo, motion.first->hi};
  if (!motion.first->holder) return row;
  row["holders"] = Json::array();
  for (std::size_t k = 0; k < 2; ++k) {
    const Holder& holder = (*motion.first->holder)[k];
    row["holders"].push_back(
        {named_as_in_file(holder, bodies[k]).text(), holder.number, holder.kind == Holder::Kind::face});
  }
  return row;
}

/// The leaves of A and of B in the pairs that the query does not discard; nothing where there are too many pairs.
std::optional<std::array<std::set<std::size_t>, 2>> leaves_left(tetratree::Collision<K>& query, const Tree& a,
                                                                const Tree& b, const Pose& pose_a, const Pose& pose_b)
{
  std::array<std::set<std::size_t>, 2> left;
  std::size_t pairs = 0;
  const bool too_many = query.any_leaf_pair(pose_a, pose_b, [&](const Node& leaf_a, const Node& leaf_b) {
    left[0].insert(&leaf_a - &a.node(1));
    left[1].insert(&leaf_b - &b.node(1));
    return ++pairs > most_leaf_pairs;
  });
  if (too_many) return std::nullopt;
  return left;
}

/// `trees`: of both bodies, or none.
void add_answers(Json& data, const View_scene& scene, const Subject& subject, std::vector<Tree>& trees)
{
  const Polyhedron &body_a = scene.bodies[0].polyhedron(), &body_b = scene.bodies[1].polyhedron();
  const auto exact = verify::prepare(Subject(), body_a, body_b), judged = verify::prepare(subject, body_a, body_b);
  std::optional<tetratree::Collision<K>> query;
  if (!trees.empty()) query.emplace(trees[0], trees[1]);
  data["subject"] = subject.name();
  for (const char* name : {"exact", "answer"}) data[name] = Json::array();
  if (query)
    for (const char* name : {"features", "feature_counts", "left", "contacts", "nearest"}) data[name] = Json::array();
  std::size_t parts_left = most_parts;
  std::unique_ptr<detail::Relation_solver> overlap;
  if (query && scene.question == kernel::Question::solid)
    overlap = overlap_solver(scene.bodies[0].body, scene.bodies[1].body);
  Progress progress("poses", scene.poses.count());
  for (std::size_t k = 0; k < scene.poses.count(); ++k) {
    const Pose &pose_a = scene.poses.of_a(k), &pose_b = scene.poses.of_b(k);
    data["exact"].push_back(int(exact->collide(pose_a, pose_b, scene.question)));
    data["answer"].push_back(int(judged->collide(pose_a, pose_b, scene.question)));
    progress.step();
    if (!query) continue;
    data["nearest"].push_back(nearest_data(exact->query(scene.question)->nearest(pose_a, pose_b), scene.bodies));
    if (const auto leaves = leaves_left(*query, trees[0], trees[1], pose_a, pose_b)) {
      const auto pairs = exact->features(pose_a, pose_b);
      data["feature_counts"].push_back(pairs.size());
      data["features"].push_back(features_data(pairs, judged->features(pose_a, pose_b)));
      data["left"].push_back(*leaves);
      data["contacts"].push_back(contacts_data(exact->contacts(pose_a, pose_b)));
      if (overlap)
        data["solids"].push_back(
            solids_data(*exact->query(scene.question), *overlap, pose_a, pose_b, scene.way_out, parts_left));
    } else {
      if (overlap) data["solids"].push_back(nullptr);
      data["feature_counts"].push_back(nullptr);
      data["features"].push_back(Json::array());
      data["contacts"].push_back(Json::array());
      data["left"].push_back({Json::array(), Json::array()});
    }
  }
}

void add_answer_of_predicate(Json& data, const verify::Case_file& c, const std::string& kernel)
{
  const auto& subjects = verify::predicate_subjects();
  const auto subject = std::ranges::find(subjects, kernel, &verify::Predicate_subject::name);
  if (subject == subjects.end()) {
    std::string names;
    for (const auto& each : subjects) names += (names.empty() ? "" : ", ") + each.name;
    throw CLI::ValidationError("--kernel " + kernel, "expected a subject of predicates: " + names);
  }
  const auto as_json = [](const std::optional<int>& answer) { return answer ? Json(*answer) : Json(nullptr); };
  data["subject"] = subject->name;
  data["exact"] = Json::array({as_json(verify::true_answer(*c.predicate, *c.points))});
  data["answer"] = Json::array({as_json(subject->answer(*c.predicate, *c.points))});
}

Json case_data(const verify::Case_file& c)
{
  Json wrong = Json::array();
  for (const auto& each : c.wrong) wrong.push_back(each.subject);
  return {{"cause", c.cause},
          {"family", c.origin().family},
          {"seed", c.origin().seed},
          {"index", c.origin().index},
          {"wrong", wrong}};
}

}  // namespace

std::vector<covering::Face_triangle> drawn_triangles(const Polyhedron& polyhedron, const covering::Covering& covering)
{
  std::vector<covering::Face_triangle> triangles = covering::triangulate_faces(polyhedron);
  std::vector<bool> is_covered(polyhedron.face_count(), false);
  for (const auto& t : triangles) is_covered[t.face] = true;
  for (const auto& t : covering.triangles())
    if (!is_covered[t.face]) triangles.push_back({t.face, t.corner});
  return triangles;
}

std::string view_data(const View_scene& scene, const std::string& kernel, verify::Method method)
{
  const bool predicate = scene.from && scene.from->level == verify::Case_kind::predicate,
             pair = scene.bodies.size() == 2;
  const auto subject = Subject::parse(kernel, method);
  if (!subject && !predicate) throw CLI::ValidationError("--kernel " + kernel, "expected " + kernel_names());

  std::size_t triangles = 0;
  for (const Model_file& body : scene.bodies) triangles += triangle_count(body.polyhedron());
  if (triangles > most_triangles)
    throw covering::Input_error(scene.name, 0, std::to_string(triangles) + " triangles",
                                "expected at most " + std::to_string(most_triangles) + " in a page");

  // The paper's own choices: the page shows the paper's tree.
  std::vector<Tree> trees;
  if (triangles <= most_detailed)
    for (const Model_file& body : scene.bodies) trees.emplace_back(body.polyhedron(), tetratree::Config());
  else
    std::cerr << scene.name << ": " << triangles << " triangles, more than " << most_detailed
              << ": the page shows bodies and answers alone\n";
  Json data = {{"name", scene.name}, {"version", TETRACONE_VERSION}, {"bodies", Json::array()}};
  for (const Model_file& body : scene.bodies)
    data["bodies"].push_back(body_data(body, covering::Covering(body.polyhedron())));
  for (std::size_t k = 0; k < trees.size(); ++k) {
    const Model_file& body = scene.bodies[k];
    add_method(data["bodies"][k], trees[k], drawn_extent(body.polyhedron().vertices));
    const Contacts own = body.body.self_intersections();
    data["bodies"][k]["self"] = contacts_data(own);
    data["bodies"][k]["self_pairs"] = pair_count(own, body);
  }
  data["poses"] = {poses_data(scene.poses.a), poses_data(scene.poses.b)};
  const char* const question = scene.question == kernel::Question::solid ? "solid" : "surface";
  if (pair) data["question"] = predicate ? verify::to_string(*scene.from->predicate) : question;
  if (predicate)
    add_answer_of_predicate(data, *scene.from, kernel);
  else if (pair)
    add_answers(data, scene, *subject, trees);
  if (!scene.rays.empty()) data["rays"] = rays_data(scene.bodies[0], scene.rays);
  if (scene.motion) data["motion"] = motion_data(*scene.motion, scene.bodies);
  if (scene.from) data["case"] = case_data(*scene.from);
  // A file's name may be no UTF-8.
  return data.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tetracone::experiments
