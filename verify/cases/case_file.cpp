#include "verify/cases/case_file.h"

#include "tetracone/covering/edge_uses.h"
#include "tetracone/covering/io/text_lines.h"
#include "tetracone/covering/planarity.h"
#include "verify/cases/json_field.h"
#include "verify/cases/json_pose.h"

#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace tetracone::verify {
namespace {

using covering::Index;
using covering::Polyhedron;
using kernel::Pose;
using kernel::Question;
using kernel::Vertex;

/// The version of the file's form, not of the program.
constexpr int format = 1;

/// The text for an infinite parameter: JSON has no number for it.
constexpr const char* infinite = "infinite";

template <class Named, std::size_t N>
Named named(const Json_field& field, const std::array<Named, N>& all)
{
  std::string names;
  for (const Named each : all) {
    if (std::string(to_string(each)) == field.text()) return each;
    names += (names.empty() ? "" : ", ") + std::string(to_string(each));
  }
  field.fail("is unknown", "expected one of " + names);
}

Vertex read_vertex(const Json_field& field)
{
  const auto items = field.exactly(3, "x, y and z");
  return {items[0].number(), items[1].number(), items[2].number()};
}

void read_face(const Json_field& field, Polyhedron& polyhedron)
{
  std::vector<std::vector<Index>> loops;
  for (const Json_field& loop : field.items(1, "the loops of a face")) {
    loops.emplace_back();
    for (const Json_field& corner : loop.items(1, "the corners of a loop")) {
      const auto v = corner.unsigned_integer(std::numeric_limits<Index>::max());
      if (v >= polyhedron.vertices.size())
        corner.fail("is vertex " + std::to_string(v),
                    "expected one of " + std::to_string(polyhedron.vertices.size()) + " vertices, from 0");
      loops.back().push_back(Index(v));
    }
  }
  polyhedron.add_face(loops);
  if (covering::planarity(polyhedron, Index(polyhedron.face_count() - 1)) == covering::Planarity::off_plane)
    field.fail("is not exactly planar", "expected planar faces");
}

std::shared_ptr<const Polyhedron> read_body(const Json_field& field, bool must_be_closed)
{
  field.only({"vertices", "faces"});
  const auto polyhedron = std::make_shared<Polyhedron>();
  for (const Json_field& vertex : field.member("vertices").items(1, "vertices"))
    polyhedron->vertices.push_back(read_vertex(vertex));
  for (const Json_field& face : field.member("faces").items(1, "faces")) read_face(face, *polyhedron);
  if (must_be_closed && !covering::is_closed(*polyhedron))
    field.fail("is open: it has no solid", "expected a closed polyhedron, or no truth of the question 'solid'");
  return polyhedron;
}

Origin read_origin(const Json_field& field)
{
  field.only({"family", "seed", "index", "parameter"});
  constexpr auto largest = std::numeric_limits<std::uint64_t>::max();
  Origin origin{field.member("family").text(), field.member("seed").unsigned_integer(largest),
                field.member("index").unsigned_integer(largest), 0};
  const Json_field parameter = field.member("parameter");
  const bool is_infinite = parameter.is_string() && parameter.text() == infinite;
  origin.parameter = is_infinite ? std::numeric_limits<double>::infinity() : parameter.number();
  return origin;
}

Wrong read_wrong(const Json_field& field)
{
  field.only({"subject", "answer"});
  Wrong wrong{field.member("subject").text(), std::nullopt};
  const Json_field answer = field.member("answer");
  if (!answer.is_string())
    wrong.answer = answer.integer(-1, 1);
  else if (answer.text() != "failed")
    answer.fail("is unknown", "expected -1, 0, 1 or \"failed\"");
  return wrong;
}

void read_object(const Json_field& root, Case_file& file)
{
  Object_case& c = file.object.emplace();
  file.question = named(root.member("question"), std::array{Question::solid, Question::surface});
  const Json_field truth = root.member("truth");
  truth.only({"surface", "solid"});
  if (truth.has("surface")) c.surface = truth.member("surface").integer(0, 1) == 1;
  if (truth.has("solid")) c.solid = truth.member("solid").integer(0, 1) == 1;
  file.truth = truth.member(std::string(to_string(file.question))).integer(0, 1);
  c.a = read_body(root.member("a"), c.solid.has_value());
  c.b = read_body(root.member("b"), c.solid.has_value());
  c.pose_a = pose_of_rows(root.member("pose_a"));
  c.pose_b = pose_of_rows(root.member("pose_b"));
  c.origin = read_origin(root.member("origin"));
}

void read_predicate(const Json_field& root, Case_file& file)
{
  Predicate_case& c = file.points.emplace();
  file.predicate = named(root.member("predicate"), all_predicates);
  const bool is_sign = file.predicate == Predicate::orientation || file.predicate == Predicate::solid;
  file.truth = root.member("truth").integer(is_sign ? -1 : 0, 1);
  const Json_field points = root.member("points");
  points.only({"v0", "v1", "v2", "v3", "p", "q", "r"});
  for (int k = 0; k < 4; ++k) c.v[k] = read_vertex(points.member("v" + std::to_string(k)));
  c.p = read_vertex(points.member("p"));
  c.q = read_vertex(points.member("q"));
  c.r = read_vertex(points.member("r"));
  c.pose_a = pose_of_rows(root.member("pose_a"));
  c.pose_b = pose_of_rows(root.member("pose_b"));
  c.origin = read_origin(root.member("origin"));
}

// ---------------------------------------------------------------------------------------------------------------------
// Written by hand: the library's own layout has a number a line.

std::string text_of(double value)
{
  // An integer would lose its sign.
  return value == 0 && std::signbit(value) ? "-0.0" : kernel::shortest(value);
}

std::string text_of(const kernel::Rational& value)
{
  const std::string text = kernel::exact_text(value);
  return text.find('/') == std::string::npos ? text : "\"" + text + "\"";
}

std::string in_json(const std::string& text)
{
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Returns "[x, y, z]" with the results of `text(k)`.
template <class Text>
std::string list(std::size_t count, Text&& text, const std::string& open = "[", const std::string& separator = ", ",
                 const std::string& close = "]")
{
  std::string result = open;
  for (std::size_t k = 0; k < count; ++k) result += (k == 0 ? "" : separator) + text(k);
  return result + close;
}

/// Returns such a list with one element per line.
template <class Text>
std::string lines(std::size_t count, const std::string& indent, Text&& text)
{
  return list(count, text, "[\n" + indent + "  ", ",\n" + indent + "  ", "\n" + indent + "]");
}

std::string text_of(const Vertex& v)
{
  return list(3, [&](std::size_t k) { return text_of(v[k]); });
}

std::string text_of(const Pose& pose)
{
  return lines(3, "  ", [&](std::size_t row) {
    return list(4, [&](std::size_t column) {
      const int k = int(4 * row + column);
      return pose.is_rational() ? text_of(pose.exact(k)) : text_of(pose[k]);
    });
  });
}

std::string text_of(const Polyhedron& polyhedron)
{
  const std::string vertices =
      lines(polyhedron.vertices.size(), "    ", [&](std::size_t v) { return text_of(polyhedron.vertices[v]); });
  const std::string faces = lines(polyhedron.face_count(), "    ", [&](std::size_t f) {
    return list(polyhedron.loop_count(Index(f)), [&](std::size_t k) {
      const covering::Loop loop = polyhedron.loop(Index(f), k);
      return list(loop.size(), [&](std::size_t i) { return std::to_string(loop[i]); });
    });
  });
  return "{\n    \"vertices\": " + vertices + ",\n    \"faces\": " + faces + "\n  }";
}

std::string text_of(const Origin& origin)
{
  return "{\"family\": " + in_json(origin.family) + ", \"seed\": " + std::to_string(origin.seed) +
         ", \"index\": " + std::to_string(origin.index) +
         ", \"parameter\": " + (std::isinf(origin.parameter) ? in_json(infinite) : text_of(origin.parameter)) + "}";
}

std::string text_of(const std::vector<Wrong>& wrong)
{
  if (wrong.empty()) return "[]";
  std::string text = "[\n    ";
  std::size_t width = 0;
  for (const Wrong& each : wrong) {
    const std::string entry = "{\"subject\": " + in_json(each.subject) +
                              ", \"answer\": " + (each.answer ? std::to_string(*each.answer) : in_json("failed")) + "}";
    // The list is long where every subject is wrong: each line is filled.
    if (width > 0) text += width + entry.size() > 120 ? (width = 0, ",\n    ") : ", ";
    text += entry;
    width += entry.size();
  }
  return text + "\n  ]";
}

using Members = std::vector<std::pair<std::string, std::string>>;

void add_object(const Case_file& file, Members& members)
{
  const Object_case& c = *file.object;
  std::string truth;
  for (const Question question : {Question::surface, Question::solid}) {
    const std::optional<int> answer = question == file.question ? file.truth : c.known(question);
    if (answer)
      truth += (truth.empty() ? "" : ", ") + in_json(std::string(to_string(question))) + ": " + std::to_string(*answer);
  }
  members.insert(members.end(), {{"question", in_json(std::string(to_string(file.question)))},
                                 {"truth", "{" + truth + "}"},
                                 {"wrong", text_of(file.wrong)},
                                 {"a", text_of(*c.a)},
                                 {"pose_a", text_of(c.pose_a)},
                                 {"b", text_of(*c.b)},
                                 {"pose_b", text_of(c.pose_b)}});
}

void add_predicate(const Case_file& file, Members& members)
{
  const Predicate_case& c = *file.points;
  std::string points;
  for (int k = 0; k < 4; ++k) points += "    \"v" + std::to_string(k) + "\": " + text_of(c.v[k]) + ",\n";
  points += "    \"p\": " + text_of(c.p) + ",\n    \"q\": " + text_of(c.q) + ",\n    \"r\": " + text_of(c.r);
  members.insert(members.end(), {{"predicate", in_json(to_string(*file.predicate))},
                                 {"truth", std::to_string(file.truth)},
                                 {"wrong", text_of(file.wrong)},
                                 {"points", "{\n" + points + "\n  }"},
                                 {"pose_a", text_of(c.pose_a)},
                                 {"pose_b", text_of(c.pose_b)}});
}

}  // namespace

bool is_case_name(const std::filesystem::path& path) { return path.native().ends_with(".case.json"); }

Case_file parse_case(const std::string& text, const std::string& name)
{
  const Json_text json(text, name, "a case file");
  const Json_field root(json);
  if (root.member("format").unsigned_integer(std::numeric_limits<std::uint64_t>::max()) != std::uint64_t(format))
    root.member("format").fail("is unknown", "expected " + std::to_string(format));
  Case_file file;
  file.level = named(root.member("level"), std::array{Case_kind::predicate, Case_kind::object});
  file.cause = root.member("cause").text();
  file.version = root.member("version").text();
  for (const Json_field& wrong : root.member("wrong").items(0, "wrong subjects"))
    file.wrong.push_back(read_wrong(wrong));
  if (file.level == Case_kind::object) {
    root.only(
        {"format", "version", "level", "cause", "origin", "question", "truth", "wrong", "a", "pose_a", "b", "pose_b"});
    read_object(root, file);
  } else {
    root.only(
        {"format", "version", "level", "cause", "origin", "predicate", "truth", "wrong", "points", "pose_a", "pose_b"});
    read_predicate(root, file);
  }
  return file;
}

Case_file read_case(const std::filesystem::path& path) { return parse_case(covering::read_text(path), path.native()); }

std::string to_json(const Case_file& file)
{
  assert(file.level == Case_kind::object ? file.object.has_value() : file.points && file.predicate);
  Members members = {{"format", std::to_string(format)},
                     {"version", in_json(file.version)},
                     {"level", in_json(to_string(file.level))},
                     {"cause", in_json(file.cause)},
                     {"origin", text_of(file.origin())}};
  if (file.level == Case_kind::object)
    add_object(file, members);
  else
    add_predicate(file, members);
  return list(
      members.size(), [&](std::size_t k) { return in_json(members[k].first) + ": " + members[k].second; }, "{\n  ",
      ",\n  ", "\n}\n");
}

}  // namespace tetracone::verify
