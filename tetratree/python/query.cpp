#include "tetracone/tetratree/python/query.h"

#include "tetracone/tetratree/door/certificate.h"
#include "tetracone/tetratree/python/arrays.h"
#include "tetracone/tetratree/python/body.h"
#include "tetracone/tetratree/python/motions.h"
#include "tetracone/tetratree/python/texts.h"
#include "tetracone/tetratree/python/unlocked.h"

#include <pybind11/numpy.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace tetracone::python {

namespace py = pybind11;

namespace {

/// A query with a lock, since it keeps work between poses: threads that share one wait for each other.
struct Locked_query {
  explicit Locked_query(Query q) : query(std::move(q)) {}

  /// Throws Error, as `Python_body::operator new`.
  static void* operator new(std::size_t) { throw Error("query: not made; expected Query(a, b)"); }

  Query query;
  std::mutex lock;  // never waited for with the interpreter's lock
};

struct Feature_row {
  std::int32_t body;
  std::uint32_t edge_from, edge_to, face;
  Word<16> kind;
};

py::dtype feature_type()
{
  py::list names, formats, offsets;
  for (const auto& [name, format, offset] : {std::tuple("body", "i4", offsetof(Feature_row, body)),
                                             {"edge_from", "u4", offsetof(Feature_row, edge_from)},
                                             {"edge_to", "u4", offsetof(Feature_row, edge_to)},
                                             {"face", "u4", offsetof(Feature_row, face)},
                                             {"kind", "U16", offsetof(Feature_row, kind)}}) {
    names.append(name);
    formats.append(format);
    offsets.append(offset);
  }
  return py::dtype(names, formats, offsets, sizeof(Feature_row));
}

py::array rows_of(const std::vector<Feature_pair>& features)
{
  py::array rows(feature_type(), features.size());
  auto* row = static_cast<Feature_row*>(rows.mutable_data());
  for (const Feature_pair& f : features) {
    *row = {f.body, f.edge_from, f.edge_to, f.face, {}};
    row++->kind = to_string(f.kind);
  }
  return rows;
}

/// The poses of both bodies, and the number of answers that they ask for.
struct Pose_pairs {
  Pose_pairs(const py::object& poses_b, const py::object& poses_a) : a(poses_a, "poses_a"), b(poses_b, "poses_b")
  {
    count = common_count("query", a.count(), " poses of a", b.count(), " of b");
  }
  bool is_one() const { return a.is_one() && b.is_one(); }

  Poses a, b;
  std::size_t count;
};

/// Throws TypeError for poses of both bodies by position: C++ takes the poses of A first, Python the poses of B.
void require_keywords(const py::args& more, const std::string& call)
{
  if (!more.empty())
    throw py::type_error("query: poses of both bodies by position, whose order was misread; expected " + call);
}

/// Calls answer(k, query, pose of a, pose of b) for each pair k. Throws Error with the name of a pose that is none.
template <class Answer_of>
void ask_all(Locked_query& self, const Pose_pairs& poses, const Answer_of& answer)
{
  std::size_t asked = 0;
  const auto for_all = [&](std::size_t count, const auto& ask) {
    for_each_unlocked(count, self.lock, [&](std::size_t k) {
      asked = k;
      ask(k);
    });
  };
  try {
    // A single pose of a body is made once.
    const Pose first_a = poses.a.count() == 1 ? poses.a(0) : Pose(),
               first_b = poses.b.count() == 1 ? poses.b(0) : Pose();
    if (poses.a.count() == 1 && poses.b.count() == 1)
      for_all(1, [&](std::size_t k) { answer(k, self.query, first_a, first_b); });
    else if (poses.a.count() == 1)
      for_all(poses.count, [&](std::size_t k) { answer(k, self.query, first_a, poses.b(k)); });
    else if (poses.b.count() == 1)
      for_all(poses.count, [&](std::size_t k) { answer(k, self.query, poses.a(k), first_b); });
    else
      for_all(poses.count, [&](std::size_t k) { answer(k, self.query, poses.a(k), poses.b(k)); });
  } catch (const Error&) {
    for (const Poses* of : {&poses.a, &poses.b})
      if (of->count() > 0) of->require(of->count() == 1 ? 0 : asked);
    throw;
  }
}

/// Returns answer(query, pose of a, pose of b) for all pairs, in an array of Value; for one pose of each, the value.
template <class Value, class Answer>
py::object all_of(Locked_query& self, const Pose_pairs& poses, const Answer& answer_of)
{
  if (poses.is_one()) {
    Value answer{};
    ask_all(self, poses,
            [&](std::size_t, Query& query, const Pose& a, const Pose& b) { answer = answer_of(query, a, b); });
    return py::cast(answer);
  }
  py::array_t<Value> answers(static_cast<py::ssize_t>(poses.count));
  Value* const answer = answers.mutable_data();
  ask_all(self, poses,
          [&](std::size_t k, Query& query, const Pose& a, const Pose& b) { answer[k] = answer_of(query, a, b); });
  return answers;
}

/// Returns what answer(query, pose of a, pose of b) returns, for all pairs.
template <class Answer>
auto found_for(Locked_query& self, const Pose_pairs& poses, const Answer& answer_of)
{
  std::vector<std::invoke_result_t<Answer, Query&, const Pose&, const Pose&>> found(poses.count);
  ask_all(self, poses,
          [&](std::size_t k, Query& query, const Pose& a, const Pose& b) { found[k] = answer_of(query, a, b); });
  return found;
}

/// Returns a list of what `made` makes of each; for one pose of each body, what it makes of the only one.
template <class Found, class Made>
py::object list_of(const std::vector<Found>& found, const Pose_pairs& poses, const Made& made)
{
  if (poses.is_one()) return made(found[0]);
  py::list all;
  for (const Found& each : found) all.append(made(each));
  return all;
}

py::object collide(Locked_query& self, const py::object& poses_b, const py::object& poses_a)
{
  return all_of<bool>(self, Pose_pairs(poses_b, poses_a),
                      [](Query& query, const Pose& a, const Pose& b) { return bool(query.collide(a, b)); });
}

py::object first_contact(Locked_query& self, const py::object& poses_b0, const py::object& poses_b1,
                         const py::args& more, const py::object& poses_a0, const py::object& poses_a1,
                         const std::string& kind)
{
  require_keywords(more, "first_contact(poses_a0=..., poses_a1=..., poses_b0=..., poses_b1=...)");
  const Motions of_a(poses_a0, poses_a1, kind, "a"), of_b(poses_b0, poses_b1, kind, "b");
  const std::size_t count = common_count("query", of_a.count(), " motions of a", of_b.count(), " of b");
  std::vector<std::optional<First_contact>> first(count);
  for_each_unlocked(count, self.lock, [&](std::size_t k) { first[k] = self.query.first_contact(of_a(k), of_b(k)); });
  if (of_a.is_one() && of_b.is_one()) {
    if (!first[0]) return py::none();
    return py::make_tuple(first[0]->lo, first[0]->hi);
  }
  py::array_t<double> bounds({static_cast<py::ssize_t>(count), py::ssize_t(2)});
  double* bound = bounds.mutable_data();
  for (const auto& f : first) {
    *bound++ = f ? f->lo : std::numeric_limits<double>::quiet_NaN();
    *bound++ = f ? f->hi : std::numeric_limits<double>::quiet_NaN();
  }
  return bounds;
}

py::object relation(Locked_query& self, const py::object& poses_b, const py::object& poses_a)
{
  const Pose_pairs poses(poses_b, poses_a);
  py::array answers(py::dtype("U8"), poses.count);
  auto* const answer = static_cast<Word<8>*>(answers.mutable_data());
  ask_all(self, poses, [&](std::size_t k, Query& query, const Pose& a, const Pose& b) {
    answer[k] = to_string(query.collide(a, b).relation());
  });
  if (poses.is_one()) return answers[py::int_(0)].attr("item")();
  return answers;
}

py::object distance(Locked_query& self, const py::object& poses_b, const py::object& poses_a)
{
  return all_of<double>(self, Pose_pairs(poses_b, poses_a),
                        [](Query& query, const Pose& a, const Pose& b) { return query.distance(a, b); });
}

py::object within(Locked_query& self, const py::object& limit, const py::object& poses_b, const py::args& more,
                  const py::object& poses_a)
{
  require_keywords(more, "within(limit, poses_a=..., poses_b=...)");
  const std::string most = exact_text(limit);
  return all_of<bool>(self, Pose_pairs(poses_b, poses_a),
                      [&](Query& query, const Pose& a, const Pose& b) { return query.within(a, b, most); });
}

py::object zone(Locked_query& self, const py::object& limit, const py::object& poses_b, const py::args& more,
                const py::object& poses_a)
{
  require_keywords(more, "zone(limit, poses_a=..., poses_b=...)");
  const std::string most = exact_text(limit);
  const Pose_pairs poses(poses_b, poses_a);
  const auto found =
      found_for(self, poses, [&](Query& query, const Pose& a, const Pose& b) { return query.zone(a, b, most); });
  return list_of(found, poses, [](const std::vector<std::uint32_t>& faces) {
    return py::array_t<std::uint32_t>(py::ssize_t(faces.size()), faces.data());
  });
}

py::object solid_relation(Locked_query& self, const py::object& poses_b, const py::object& poses_a)
{
  const Pose_pairs poses(poses_b, poses_a);
  py::array relations(py::dtype("U10"), poses.count);
  py::array_t<std::int8_t> dimensions(static_cast<py::ssize_t>(poses.count));
  auto* const relation = static_cast<Word<10>*>(relations.mutable_data());
  std::int8_t* const dimension = dimensions.mutable_data();
  ask_all(self, poses, [&](std::size_t k, Query& query, const Pose& a, const Pose& b) {
    const Solid_contact contact = query.solid_relation(a, b);
    relation[k] = to_string(contact.relation);
    dimension[k] = std::int8_t(contact.dimension);
  });
  if (poses.is_one()) return py::make_tuple(relations[py::int_(0)].attr("item")(), int(dimension[0]));
  return py::make_tuple(relations, dimensions);
}

/// Returns the only value of each column.
py::dict single_values(const py::dict& columns)
{
  py::dict one;
  for (const auto& [name, column] : columns) one[name] = column[py::int_(0)];
  return one;
}

py::dict overlap(Locked_query& self, const py::object& poses_b, const py::object& poses_a)
{
  const Pose_pairs poses(poses_b, poses_a);
  const auto found =
      found_for(self, poses, [](Query& query, const Pose& a, const Pose& b) { return query.overlap(a, b); });
  return overlap_columns(found, poses.is_one());
}

py::dict exits(Locked_query& self, const py::object& direction, const py::object& poses_b, const py::args& more,
               const py::object& poses_a)
{
  require_keywords(more, "exits(direction, poses_a=..., poses_b=...)");
  const std::array<std::string, 3> along = direction_of(direction);
  const Pose_pairs poses(poses_b, poses_a);
  const auto found =
      found_for(self, poses, [&](Query& query, const Pose& a, const Pose& b) { return query.exits(a, b, along); });
  return exit_columns(found, poses.is_one());
}

py::dict depth(Locked_query& self, const py::object& poses_b, double relative, std::size_t budget,
               const py::object& poses_a)
{
  const Pose_pairs poses(poses_b, poses_a);
  const auto found = found_for(self, poses, [&](Query& query, const Pose& a, const Pose& b) {
    return query.depth(a, b, {relative, budget});
  });
  return depth_columns(found, poses.is_one());
}

py::object certificate(Locked_query& self, const py::object& poses_b, const std::string& ask, const py::object& limit,
                       const py::object& direction, double relative, std::size_t budget, const py::object& poses_a)
{
  using Add = std::function<void(Certificate&, Query&, const Pose&, const Pose&)>;
  Add add;
  if (ask == "collide")
    add = [](Certificate& proofs, Query& query, const auto& a, const auto& b) { proofs.collide(query, a, b); };
  else if (ask == "distance")
    add = [](Certificate& proofs, Query& query, const auto& a, const auto& b) { proofs.distance(query, a, b); };
  else if (ask == "within")
    add = [most = exact_text(limit)](Certificate& proofs, Query& query, const auto& a, const auto& b) {
      proofs.within(query, a, b, most);
    };
  else if (ask == "relation")
    add = [](Certificate& proofs, Query& query, const auto& a, const auto& b) { proofs.relation(query, a, b); };
  else if (ask == "exits")
    add = [along = direction_of(direction)](Certificate& proofs, Query& query, const auto& a, const auto& b) {
      proofs.exits(query, a, b, along);
    };
  else if (ask == "depth")
    add = [=](Certificate& proofs, Query& query, const auto& a, const auto& b) {
      proofs.depth(query, a, b, {relative, budget});
    };
  else
    throw Error("certificate: ask '" + ask + "'; expected collide, distance, within, relation, exits or depth");
  const Pose_pairs poses(poses_b, poses_a);
  Certificate proofs(self.query);
  ask_all(self, poses, [&](std::size_t, Query& query, const Pose& a, const Pose& b) { add(proofs, query, a, b); });
  return py::module_::import("json").attr("loads")(proofs.text());
}

py::object features(Locked_query& self, const py::object& poses_b, const py::object& poses_a)
{
  const Pose_pairs poses(poses_b, poses_a);
  const auto found =
      found_for(self, poses, [](Query& query, const Pose& a, const Pose& b) { return query.features(a, b); });
  return list_of(found, poses, rows_of);
}

py::object contacts(Locked_query& self, const py::object& poses_b, const py::object& poses_a)
{
  const Pose_pairs poses(poses_b, poses_a);
  const auto found = found_for(
      self, poses, [](Query& query, const Pose& a, const Pose& b) { return std::optional(query.contacts(a, b)); });
  return list_of(found, poses, [](const std::optional<Contacts>& each) { return py::cast(*each); });
}

py::dict statistics(Locked_query& self)
{
  Query_statistics s;
  for_each_unlocked(1, self.lock, [&](std::size_t) { s = self.query.statistics(); });
  py::dict counts;
  for (const auto& [name, count] : {std::pair("queries", s.queries),
                                    {"pairs_visited", s.pairs_visited},
                                    {"hull_tests", s.hull_tests},
                                    {"discarded_by_hull", s.discarded_by_hull},
                                    {"sphere_tests", s.sphere_tests},
                                    {"discarded_by_sphere", s.discarded_by_sphere},
                                    {"tetrahedron_tests", s.tetrahedron_tests},
                                    {"discarded_by_tetrahedron", s.discarded_by_tetrahedron},
                                    {"box_tests", s.box_tests},
                                    {"leaf_pairs", s.leaf_pairs},
                                    {"discarded_by_box", s.discarded_by_box},
                                    {"edge_face_tests", s.edge_face_tests},
                                    {"triangle_tests", s.triangle_tests},
                                    {"inclusion_tests", s.inclusion_tests},
                                    {"exact_fallbacks", s.exact_fallbacks},
                                    {"bounding_tests", s.bounding_tests()},
                                    {"primitive_tests", s.primitive_tests()}})
    counts[name] = count;
  return counts;
}

/// Returns a method that calls `of` on the query while no other thread asks it.
template <class Value>
auto alone(Value (Query::*of)() const)
{
  return [of](Locked_query& self) {
    Value value{};
    for_each_unlocked(1, self.lock, [&](std::size_t) { value = (self.query.*of)(); });
    return value;
  };
}

template <class Names>
std::string listed(const Names& names)
{
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

std::vector<std::string> example_names()
{
  std::vector<std::string> names;
  for (const Kernel kernel : all_kernels) names.push_back(kernel_name(kernel, Tolerance{1e-12, 0}));
  return names;
}

std::vector<std::string_view> method_names()
{
  std::vector<std::string_view> names;
  for (const Method method : all_methods) names.push_back(to_string(method));
  return names;
}

py::tuple tuple_of(const auto& names)
{
  py::list list;
  for (const auto& name : names) list.append(py::str(std::string(name)));
  return list;
}

std::shared_ptr<Locked_query> made_query(const Python_body& a, const Python_body& b, const py::str& of_question,
                                         const py::str& of_kernel, const py::str& of_method, bool remember)
{
  const std::string question = text_of(of_question), kernel = text_of(of_kernel), method = text_of(of_method);
  const auto asked = kernel::parse_question(question);
  if (!asked) throw Error("query: question '" + question + "'; expected solid or surface");
  auto options = parse_kernel(kernel);
  if (!options) throw Error("query: kernel '" + kernel + "'; expected " + kernel_names());
  const auto way = parse_method(method);
  if (!way) throw Error("query: method '" + method + "'; expected " + listed(method_names()));
  options->method = *way;
  options->remember = remember;
  const py::gil_scoped_release unlocked;
  return std::make_shared<Locked_query>(Query(a.body, b.body, *asked, *options));
}

}  // namespace

std::array<std::string, 3> direction_of(const py::object& direction)
{
  if (!is_sequence(direction)) throw Error("exits: a direction of type " + type_of(direction) + "; expected 3 numbers");
  const py::tuple given(direction);
  if (given.size() != 3) throw Error("exits: a direction of " + std::to_string(given.size()) + " numbers; expected 3");
  return {exact_text(given[0]), exact_text(given[1]), exact_text(given[2])};
}

namespace {

/// Returns a row of doubles for each element: `values_of` returns an array. Rows of one double have no axis of their
/// own.
template <class Found, class Values_of>
py::array_t<double> doubles(std::span<const Found> found, const Values_of& values_of)
{
  std::vector<py::ssize_t> shape = {py::ssize_t(found.size())};
  if (const auto width = values_of(Found()).size(); width != 1) shape.push_back(py::ssize_t(width));
  py::array_t<double> array(shape);
  double* at = array.mutable_data();
  for (const Found& each : found)
    for (const double x : values_of(each)) *at++ = x;
  return array;
}

/// Returns a fraction for each element, or a tuple of three. `text_of` returns one text, or three.
template <class Found, class Text_of>
py::list fractions(std::span<const Found> found, const Text_of& text_of)
{
  const Python_fraction fraction;
  py::list list;
  for (const Found& each : found) {
    const auto text = text_of(each);
    if constexpr (std::is_same_v<decltype(text), const std::string>)
      list.append(fraction(text));
    else
      list.append(py::make_tuple(fraction(text[0]), fraction(text[1]), fraction(text[2])));
  }
  return list;
}

}  // namespace

py::dict overlap_columns(std::span<const Overlap> found, bool is_one)
{
  py::dict columns;
  columns["volume"] = doubles(found, [](const Overlap& each) { return std::array{each.volume}; });
  columns["centroid"] = doubles(found, [](const Overlap& each) { return each.centroid; });
  columns["contact_area"] = doubles(found, [](const Overlap& each) { return each.contact_area; });
  columns["contact_vector"] = doubles(found, [](const Overlap& each) { return each.contact_vector; });
  columns["exact_volume"] = fractions(found, [](const Overlap& each) { return each.exact_volume(); });
  columns["exact_centroid"] = fractions(found, [](const Overlap& each) { return each.exact_centroid(); });
  columns["exact_contact_vector"] = fractions(found, [](const Overlap& each) { return each.exact_contact_vector(); });
  return is_one ? single_values(columns) : columns;
}

py::dict exit_columns(std::span<const Exits> found, bool is_one)
{
  py::dict columns;
  columns["first"] = doubles(found, [](const Exits& each) { return std::array{each.first}; });
  columns["last"] = doubles(found, [](const Exits& each) { return std::array{each.last}; });
  columns["exact_first"] = fractions(found, [](const Exits& each) { return each.exact_first; });
  columns["exact_last"] = fractions(found, [](const Exits& each) { return each.exact_last; });
  return is_one ? single_values(columns) : columns;
}

py::dict depth_columns(std::span<const Depth> found, bool is_one)
{
  py::array_t<bool> is_exact(py::ssize_t(found.size()));
  std::ranges::transform(found, is_exact.mutable_data(), &Depth::is_exact);
  py::dict columns;
  columns["bounds"] = doubles(found, [](const Depth& each) { return std::array{each.low, each.high}; });
  columns["vector"] = doubles(found, [](const Depth& each) { return each.vector; });
  columns["is_exact"] = is_exact;
  columns["exact_square"] = fractions(found, [](const Depth& each) { return each.exact_square; });
  columns["exact_vector"] = fractions(found, [](const Depth& each) { return each.exact_vector; });
  return is_one ? single_values(columns) : columns;
}

namespace {

using Query_class = py::class_<Locked_query, std::shared_ptr<Locked_query>>;

/// Adds the method `name`, which takes poses of B, and by keyword only poses of A. It calls answer(query, poses of B,
/// poses of A).
template <auto answer>
void add_of_poses(Query_class& query, const char* name, const char* doc)
{
  const auto method = [name](Locked_query& self, const py::object& poses_b, const py::args& more,
                             const py::object& poses_a) {
    require_keywords(more, std::string(name) + "(poses_a=..., poses_b=...)");
    return answer(self, poses_b, poses_a);
  };
  query.def(name, method, py::arg("poses_b"), py::arg("poses_a") = py::none(), doc);
}

/// Adds how the bodies stand to each other.
void add_relations(Query_class& query)
{
  add_of_poses<&collide>(query, "collide", R"(collide(poses_b, *, poses_a=None)

Whether the bodies collide: array (n,) of bool. For one pose of each body, a bool.

poses_b, poses_a: poses of either body as `Query` says; None is the identity. Poses of both are given by their
keywords: collide(poses_a=..., poses_b=...). TypeError for two sets by position.

>>> import tetracone
>>> a = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> tetracone.Query(a, a).collide([["1/3", 0, 0, "2/3"], [0, 1, 0, 0], [0, 0, 1, 0]])
True
)");
  add_of_poses<&relation>(query, "relation", R"(relation(poses_b, *, poses_a=None)

The relation of the bodies: array (n,) of "apart", "surfaces" where the surfaces meet, "a_in_b" or "b_in_a". For one
pose of each body, a str. Arguments as of `collide`.

>>> import tetracone
>>> a = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> tetracone.Query(a, a).relation([[0.25, 0, 0, 0.125], [0, 0.25, 0, 0.125], [0, 0, 0.25, 0.125]])
'b_in_a'
)");
  add_of_poses<&solid_relation>(query, "solid_relation", R"(solid_relation(poses_b, *, poses_a=None)

Which of the eight relations of solids holds, and the dimension of what the surfaces share: arrays (n,) of str and of
int8. The relations are "disjoint", "meet", "overlap", "equal", "inside", "contains", "covered_by" and "covers"; solids
that only touch "meet". The dimension is 0 for points, 1 for a segment, 2 for an area, -1 for nothing. For one pose of
each body, a str and an int. Arguments as of `collide`. Raises Error for question "surface", and for a kernel that is
not adaptive.

>>> import tetracone
>>> a = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> tetracone.Query(a, a).solid_relation([[1, 0, 0, 1], [0, 1, 0, 0], [0, 0, 1, 0]])
('meet', 0)
)");
}

/// Adds how deep the solids are in each other.
void add_penetrations(Query_class& query)
{
  add_of_poses<&overlap>(query, "overlap", R"(overlap(poses_b, *, poses_a=None)

How much the solids overlap and touch: a dict of arrays.

volume, centroid: (n,) and (n, 3), of the intersection of the interiors.
contact_area: (n, 2), doubles that enclose the area that faces share.
contact_vector: (n, 3), the sum of area times outward unit normal of a.
exact_volume, exact_centroid, exact_contact_vector: lists of fractions.Fraction, or of tuples of three.

Each double is the one nearest to its fraction. Lengths are in the units of the placed coordinates. For one pose of each
body, the dict holds single values instead of arrays. Arguments and errors as of `solid_relation`.

>>> import tetracone
>>> a = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> tetracone.Query(a, a).overlap([[1, 0, 0, 0.5], [0, 1, 0, 0], [0, 0, 1, 0]])["exact_volume"]
Fraction(1, 48)
)");
  query.def("exits", &exits, py::arg("direction"), py::arg("poses_b"), py::arg("poses_a") = py::none(),
            R"(exits(direction, poses_b, *, poses_a=None)

How far a must be moved along a direction for the interiors of the solids to part: a dict.

first, last: arrays (n,); where they first share no point, and from where on they never share one again.
exact_first, exact_last: the same as lists of fractions.Fraction.

All are in lengths of the direction, which is three numbers, fractions.Fraction or texts "n/d". The solids may touch.
For one pose of each body, the dict holds single values instead of arrays. Other arguments and errors as of
`solid_relation`. Raises Error also for a direction of 0.

>>> import tetracone
>>> a = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> tetracone.Query(a, a).exits([3, 0, 0], [[1, 0, 0, 0.5], [0, 1, 0, 0], [0, 0, 1, 0]])["exact_first"]
Fraction(1, 2)
)");
  query.def("depth", &depth, py::arg("poses_b"), py::kw_only(), py::arg("relative") = 1e-9, py::arg("budget") = 100000,
            py::arg("poses_a") = py::none(),
            R"(depth(poses_b, *, relative=1e-9, budget=100000, poses_a=None)

The least translation of a for the interiors of the solids to part, in a bracket that is never wrong: a dict.

bounds: array (n, 2), a lower and an upper bound of its length, in the units of the placed coordinates.
vector: array (n, 3), the doubles nearest to a translation of the upper length that parts them.
is_exact: array (n,) of bool, whether it is proved that no other is shorter.
exact_square, exact_vector: its squared length and itself, lists of fractions.Fraction and of tuples of three.

For one pose of each body, the dict holds single values instead of arrays.

relative: the search ends when the bracket's width over its upper end is at most this; in [0, 1).
budget: the search ends after this number of boxes of translations.

poses_b and poses_a are as of `collide`. Raises Error for another `relative`, and as `solid_relation`.

>>> import tetracone
>>> a = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> tetracone.Query(a, a).depth([[1, 0, 0, 0.75], [0, 1, 0, 0], [0, 0, 1, 0]])["exact_square"]
Fraction(1, 48)
)");
}

/// Adds how far apart the bodies are.
void add_distances(Query_class& query)
{
  add_of_poses<&distance>(query, "distance", R"(distance(poses_b, *, poses_a=None)

How far apart the surfaces are, or for question "solid" the solids, which are 0 apart where they collide: array (n,) of
float. Each is the double nearest to the exact distance. For one pose of each body, a float. Arguments as of `collide`.
The kernels adaptive and rational are exact; double rounds. Raises Error for others.

>>> import tetracone
>>> a = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> tetracone.Query(a, a).distance([[1, 0, 0, 1], [0, 1, 0, 1], [0, 0, 1, 0]])
0.7071067811865476
)");
  query.def("within", &within, py::arg("limit"), py::arg("poses_b"), py::arg("poses_a") = py::none(),
            R"(within(limit, poses_b, *, poses_a=None)

Whether `distance` is at most `limit`, decided exactly: array (n,) of bool. For one pose of each body, a bool. The limit
is a number, a fractions.Fraction or a text "n/d". Other arguments as of `collide`. Raises Error for a limit that is not
finite or no number, and as `distance`.

>>> import tetracone
>>> a = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> tetracone.Query(a, a).within("1/3", [[1, 0, 0, "4/3"], [0, 1, 0, 0], [0, 0, 1, 0]])
True
)");
  query.def("zone", &zone, py::arg("limit"), py::arg("poses_b"), py::arg("poses_a") = py::none(),
            R"(zone(limit, poses_b, *, poses_a=None)

The faces of a, in order, that have a point at most `limit` from b, decided exactly: a list of n arrays of uint32. For
one pose of each body, the array. The limit and the other arguments are as of `within`. Raises Error for a kernel that
is not adaptive or rational, and for a limit as `within`.

>>> import tetracone
>>> a = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> tetracone.Query(a, a).zone("1/3", [[1, 0, 0, "4/3"], [0, 1, 0, 0], [0, 0, 1, 0]])
array([0, 1, 3], dtype=uint32)
)");
}

/// Adds what is asked of moving bodies.
void add_motions(Query_class& query)
{
  const auto poses_b0 = py::arg("poses_b0"), poses_b1 = py::arg("poses_b1");
  const auto poses_a0 = py::arg("poses_a0") = py::none(), poses_a1 = py::arg("poses_a1") = py::none(),
             kind = py::arg("kind") = "linear";
  query.def("first_contact", &first_contact, poses_b0, poses_b1, poses_a0, poses_a1, kind,
            R"(first_contact(poses_b0, poses_b1, *, poses_a0=None, poses_a1=None, kind="linear")

When the moving bodies first share a point, exactly: array (n, 2) of doubles lo <= t <= hi, equal where the time is that
double, else neighbours; NaN where they never meet. For one pose at each end, a tuple (lo, hi), or None.

poses_b0, poses_b1, poses_a0, poses_a1: poses of either body at t = 0 and at t = 1; None is the identity.
kind: "linear", of poses as `Query` says: every point moves on a line, M(t) = (1-t) M0 + t M1. Or "rigid", of arrays
(n, 7), a quaternion w x y z of any length and a translation. It rotates at every t, by the quaternion (1-t) q0 + t q1.
A rigid motion may also be given by matrices that are rotations, exactly or to 1e-5 in each entry. Each stands for its
quaternion of length 1, rounded to doubles unless the matrix is a rotation exactly, and the motion takes the short way.

Raises Error for quaternions between which one is 0, for a kernel that is not adaptive, and for a face without triangles
that is not star-shaped.

>>> import tetracone
>>> a = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> query = tetracone.Query(a, a)
>>> query.first_contact([[1, 0, 0, 3], [0, 1, 0, 0.25], [0, 0, 1, 0.25]], [[1, 0, 0, -3], [0, 1, 0, 0.25], [0, 0, 1, 0.25]])
(0.41666666666666663, 0.4166666666666667)
>>> query.first_contact([[1, 0, 0, 0, 2, 0, 0]], [1, 0, 0, 1, 2, 2, 0], kind="rigid")
array([[nan, nan]])
)");
  query.def("motion", &first_contact, poses_b0, poses_b1, poses_a0, poses_a1, kind,
            R"(motion(poses_b0, poses_b1, *, poses_a0=None, poses_a1=None, kind="linear")

The old name of `first_contact`, kept for one version.
)");
}

/// Adds the answers with proofs.
void add_certificates(Query_class& query)
{
  query.def("certificate", &certificate, py::arg("poses_b"), py::kw_only(), py::arg("ask") = "collide",
            py::arg("limit") = py::none(), py::arg("direction") = py::none(), py::arg("relative") = 1e-9,
            py::arg("budget") = 100000, py::arg("poses_a") = py::none(),
            R"(certificate(poses_b, *, ask="collide", limit=None, direction=None, relative=1e-9, budget=100000,
            poses_a=None)

Answers with their proofs: a dict that experiments/certificates/check.py, a program without any code of this package,
proves when it is written as JSON. The bodies stand in it.

ask: "collide", "distance", "within" (with `limit`), "relation" (the eight of `solid_relation`), "exits" (with
`direction`) or "depth" (its bounds, with `relative` and `budget`). Answers that have no proof are left out. Other
arguments and errors as of the method of that name; "relation" is `solid_relation`.

>>> import tetracone
>>> a = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> proofs = tetracone.Query(a, a).certificate([[1, 0, 0, 2], [0, 1, 0, 0], [0, 0, 1, 0]])
>>> proofs["answers"][0]["answer"], proofs["answers"][0]["cover"]
('apart', 0)
)");
}

/// Adds the lists of what meets.
void add_lists(Query_class& query)
{
  add_of_poses<&features>(query, "features", R"(features(poses_b, *, poses_a=None)

All pairs of an edge of one body and a face of the other that share a point: a list of n structured arrays. The fields
are `body` (0 for an edge of a and a face of b, else 1), `edge_from` and `edge_to` (the edge's vertices), `face` and
`kind`. For one pose of each body, the array. Arguments as of `collide`.

>>> import tetracone
>>> a = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> found = tetracone.Query(a, a).features([[1, 0, 0, 1], [0, 1, 0, 0], [0, 0, 1, 0]])
>>> len(found), found[0].item()
(18, (0, 0, 1, 0, 'vertex-vertex'))
)");
  add_of_poses<&contacts>(query, "contacts", R"(contacts(poses_b, *, poses_a=None)

All pairs of faces that share a point, and where: a list of n `Contacts`. For one pose of each body, the `Contacts`.
Arguments as of `collide`. Raises Error for a kernel that rounds.

>>> import tetracone
>>> a = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> found = tetracone.Query(a, a).contacts([[1, 0, 0, "1/3"], [0, 1, 0, "1/3"], [0, 0, 1, "-1/3"]])
>>> len(found), found.faces[0].tolist(), str(found.kind[0]), found.held_by[0].tolist()
(4, [0, 1], 'segment', ['interior', 'interior'])
>>> found.exact_loops(0)[0][0]
(Fraction(2, 3), Fraction(1, 3), Fraction(0, 1))
)");
}

/// Adds what is counted.
void add_counts(Query_class& query)
{
  query
      .def_property_readonly("statistics", &statistics,
                             "What was done since `clear_statistics`: a dict of counts by their names.")
      .def(
          "clear_statistics",
          [](Locked_query& self) {
            for_each_unlocked(1, self.lock, [&](std::size_t) { self.query.clear_statistics(); });
          },
          "clear_statistics()\n\nSets all counts to 0.")
      .def_property_readonly("bytes", alone(&Query::bytes),
                             "Bytes of the trees of both bodies, as far as they have been made.")
      .def_property_readonly("node_count", alone(&Query::node_count),
                             "Number of these trees' nodes that have been made.");
}

}  // namespace

void add_query(py::module_& module)
{
  module.attr("kernels") = tuple_of(example_names());
  module.attr("methods") = tuple_of(method_names());

  Query_class query(module, "Query",
                    (R"(Query(a, b, question="solid", kernel="adaptive", method="tree", remember=False)

Two bodies and a question, asked for many poses. Keeps work from one pose to the next: one query per thread answers
fastest, threads that share one wait for each other. The interpreter's lock is released while it answers.

question: "solid", do the two closed solids share a point, or "surface", do the two closed surfaces. Touching counts.
kernel: the arithmetic that decides, of `tetracone.kernels`; these are exact: )" +
                     listed(exact_kernel_names()) + R"(. The tolerance
of double-eps=E, or double-eps=rel:E, is any E >= 0.
method: the way to the answer, of `tetracone.methods`.
remember: keep from pose to pose what decided the last one, for motions in small steps. Changes no answer.

A pose is the affine map x -> M x + t, row-major (3, 4), or (4, 4) with the last row 0 0 0 1; taken exactly. An array of
n poses, (n, 3, 4) or (n, 4, 4), has n answers; so has one pose of one body with n of the other. Poses of doubles are
read where they lie. Poses of fractions.Fraction, or texts "n/d", are taken exactly too: a rotation that is truly one
has rational numbers.

Raises Error when an open surface is asked for its solid, and for a pose that is none, which it names by its place.

>>> import numpy as np, tetracone
>>> a = tetracone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
>>> query = tetracone.Query(a, a)
>>> poses = np.tile(np.eye(3, 4), (3, 1, 1))
>>> poses[:, 0, 3] = [0.5, 1, np.nextafter(1, 2)]
>>> query.collide(poses)
array([ True,  True, False])
)")
                        .c_str());
  query.def(py::init(&made_query), py::arg("a"), py::arg("b"), py::arg("question") = "solid",
            py::arg("kernel") = "adaptive", py::arg("method") = "tree", py::arg("remember") = false);
  add_relations(query);
  add_penetrations(query);
  add_distances(query);
  add_motions(query);
  add_certificates(query);
  add_lists(query);
  add_counts(query);
}

}  // namespace tetracone::python
