#include "experiments/peers/subject_lines.h"

#include "tetracone/covering/check.h"
#include "tetracone/kernel/motion/rotation_quaternion.h"
#include "tetracone/kernel/number/number.h"
#include "verify/cases/case_numbers.h"
#include "verify/relations/convex_body.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

namespace tetracone::experiments::subject_lines {
namespace {

/// "[first,...]" of what `write` appends for each number below `count`.
template <class Write>
void list(std::string& text, std::size_t count, const Write& write)
{
  text += '[';
  for (std::size_t k = 0; k < count; ++k) {
    if (k > 0) text += ',';
    write(k);
  }
  text += ']';
}

/// A number; a fraction as a string.
std::string number_text(const std::string& number)
{
  return number.find('/') == std::string::npos ? number : '"' + number + '"';
}

std::string pose_text(const kernel::Pose& pose)
{
  std::string text;
  list(text, 12, [&](std::size_t k) {
    const int entry = int(k);
    text += number_text(pose.is_rational() ? kernel::exact_text(pose.exact(entry)) : kernel::shortest(pose[entry]));
  });
  return text;
}

/// The key and value of a pose that is rigid; nothing for another one.
std::string rigid_text(const char* key, const kernel::Pose& pose)
{
  const auto motion = rigid_motion(pose);
  if (!motion) return "";
  std::string text = std::string(",\"") + key + "\":";
  list(text, motion->size(), [&](std::size_t k) { text += kernel::shortest((*motion)[k]); });
  return text;
}

std::string vertex_text(const kernel::Vertex& v)
{
  std::string text;
  list(text, 3, [&](std::size_t k) { text += kernel::shortest(v[k]); });
  return text;
}

/// The first keys of an ask about one body, and about two.
std::string of_one(std::uint64_t ask, std::uint64_t a)
{
  return "{\"ask\":" + std::to_string(ask) + ",\"a\":" + std::to_string(a);
}
std::string of_two(std::uint64_t ask, std::uint64_t a, std::uint64_t b, const kernel::Pose& pose_a,
                   const kernel::Pose& pose_b)
{
  return of_one(ask, a) + ",\"b\":" + std::to_string(b) + ",\"pose_a\":" + pose_text(pose_a) +
         ",\"pose_b\":" + pose_text(pose_b) + rigid_text("rigid_a", pose_a) + rigid_text("rigid_b", pose_b);
}

/// The last key of an ask, its end included; before it whether the bodies are surfaces or solids.
std::string question_text(Kind kind) { return ",\"question\":\"" + std::string(to_string(kind)) + "\"}\n"; }
std::string question_text(Kind kind, kernel::Question of)
{
  return ",\"of\":\"" + std::string(kernel::to_string(of)) + "\"" + question_text(kind);
}

/// A line as messages show it.
std::string shown(const std::string& line)
{
  constexpr std::size_t enough = 80;
  const std::string start = line.substr(0, enough);
  return nlohmann::json(start + (line.size() > enough ? "..." : ""))
      .dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

/// The text of a key of a hello; `otherwise` where it is no text.
std::string text_at(const nlohmann::json& json, const char* key, const std::string& otherwise)
{
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : otherwise;
}

/// The answers of a kind, in words.
const char* form_of(Kind kind)
{
  switch (kind) {
    case Kind::relation: return "\"apart\", \"surfaces\", \"a_in_b\", \"b_in_a\" or null";
    case Kind::inside: return "-1, 0, 1 or null";
    case Kind::distance: return "a number from 0, or null";
    case Kind::ray: return "0, null, or 1 with \"t\", a number from 0";
    case Kind::first_contact: return "0, null, or 1 with \"t\", a number from 0 to 1";
    case Kind::within:
    case Kind::triangles:
    case Kind::collide: break;
  }
  return "0, 1 or null";
}

/// A finite number from `low` to `high`.
bool is_number(const nlohmann::json& json, double low, double high)
{
  return json.is_number() && json.get<double>() >= low && json.get<double>() <= high;
}

/// What an answer of this kind says; no outcome where it has not the form of one.
Reply value_of(const nlohmann::json& json, const nlohmann::json& answer, Kind kind)
{
  using verify::Outcome;
  constexpr double largest = std::numeric_limits<double>::max();
  if (answer.is_null()) return {Outcome::not_asked, "", {}};
  if (kind == Kind::distance)
    return is_number(answer, 0, largest) ? Reply{Outcome::yes, "", {}, answer.get<double>()} : Reply{};
  if (kind == Kind::relation) {
    constexpr std::array<std::string_view, 4> relations = {"apart", "surfaces", "a_in_b", "b_in_a"};
    const auto found = std::ranges::find(relations, answer.is_string() ? answer.get<std::string>() : "");
    return found == relations.end() ? Reply{} : Reply{Outcome::yes, "", {}, double(found - relations.begin())};
  }
  if (!answer.is_number_integer()) return {};
  if (kind == Kind::inside)
    return is_number(answer, -1, 1) ? Reply{Outcome::yes, "", {}, answer.get<double>()} : Reply{};
  if (answer == 0) return {Outcome::no, "", {}};
  if (answer != 1) return {};
  if (kind == Kind::within || kind == Kind::collide || kind == Kind::triangles) return {Outcome::yes, "", {}};
  const auto t = json.find("t");
  if (t == json.end() || !is_number(*t, 0, kind == Kind::first_contact ? 1 : largest)) return {};
  return {Outcome::yes, "", {}, t->get<double>()};
}

Reply reply_of(const nlohmann::json& json, const std::string& line, std::uint64_t ask, Kind kind = Kind::collide)
{
  const std::string form = "{\"ask\": " + std::to_string(ask) + ", \"answer\": " + form_of(kind) + "}";
  const auto wrong = [&](const std::string& what) { return Reply{std::nullopt, what + "; expected " + form, {}}; };
  if (!json.is_object()) return wrong("the line " + shown(line) + " is no JSON object");
  const auto number = json.find("ask"), answer = json.find("answer");
  if (number == json.end() || !number->is_number_integer() || *number != ask)
    return wrong("the line " + shown(line) + " does not name this ask");
  if (answer == json.end()) return wrong("the line " + shown(line) + " has no answer");
  Reply reply = value_of(json, *answer, kind);
  if (!reply.outcome) return wrong("the answer of " + shown(line) + " has another form");
  if (reply.outcome == verify::Outcome::not_asked) return reply;
  constexpr double longest = 1e18;  // 30 years: more is no time, and might be no integer of 64 bits
  const auto ns = json.find("ns");
  if (ns != json.end() && ns->is_number() && *ns >= 0.0 && *ns <= longest) reply.ns = std::uint64_t(ns->get<double>());
  return reply;
}

/// The largest body of which convexity is decided: the decision compares all faces with all vertices.
constexpr std::size_t most_faces_of_convex = 1000;

}  // namespace

const char* to_string(Kind kind)
{
  switch (kind) {
    case Kind::relation: return "relation";
    case Kind::within: return "within";
    case Kind::distance: return "distance";
    case Kind::inside: return "inside";
    case Kind::ray: return "ray";
    case Kind::first_contact: return "first contact";
    case Kind::triangles: return "triangles";
    case Kind::collide: break;
  }
  return "collide";
}

bool Hello::takes(Kind kind) const
{
  return kind == Kind::collide || std::ranges::find(questions, to_string(kind)) != questions.end();
}

bool Hello::takes(Kind kind, kernel::Question of) const
{
  const auto names = [this](kernel::Question question) {
    return std::ranges::find(questions, kernel::to_string(question)) != questions.end();
  };
  const bool is_open = kind == Kind::collide ? questions.empty() || takes(Kind::relation)
                                             : !names(kernel::Question::surface) && !names(kernel::Question::solid);
  return takes(kind) && (is_open || names(of));
}

bool Hello::takes(const kernel::Pose& pose) const { return !is_rigid || rigid_motion(pose); }

bool Hello::takes(const covering::Polyhedron& body) const
{
  if (bodies == "manifold") return covering::is_manifold(body);
  if (bodies == "closed") return covering::is_closed(body);
  if (bodies != "convex") return true;
  return body.face_count() <= most_faces_of_convex && covering::is_closed(body) && verify::is_convex(body);
}

std::optional<Hello> read_hello(const std::string& line)
{
  const auto json = nlohmann::json::parse(line, nullptr, false);
  if (!json.is_object() || !json.contains("hello")) return std::nullopt;
  Hello hello;
  hello.text = json.dump();
  hello.bodies = text_at(json, "bodies", hello.bodies);
  hello.is_rigid = text_at(json, "poses", "") == "rigid";
  const std::string precision = text_at(json, "precision", "");
  if (precision == "float32")
    hello.in_floats = verify::In_floats::vertices_and_poses;
  else if (text_at(json, "vertices", precision) == "float32")
    hello.in_floats = verify::In_floats::vertices;
  const auto questions = json.find("questions"), batch = json.find("batch");
  if (questions != json.end() && questions->is_array())
    for (const auto& question : *questions)
      if (question.is_string()) hello.questions.push_back(question);
  hello.takes_batches = batch != json.end() && *batch == true;
  return hello;
}

std::string flaw_of(const Hello& hello)
{
  const auto json = nlohmann::json::parse(hello.text);
  std::vector<std::string> kinds = {"surface", "solid"};
  for (const Kind kind : all_kinds)
    if (kind != Kind::collide) kinds.emplace_back(to_string(kind));
  const std::vector<std::string> precisions = {"float32", "float64", "exact"};
  const auto is_one_of = [](const nlohmann::json& value, const std::vector<std::string>& words) {
    return value.is_string() && std::ranges::find(words, value.get<std::string>()) != words.end();
  };
  const std::vector<std::pair<const char*, std::vector<std::string>>> allowed = {
      {"bodies", {"convex", "manifold", "closed", "any"}},
      {"poses", {"rigid", "affine"}},
      {"touching", {"open", "closed"}},
      {"precision", precisions},
      {"vertices", precisions}};
  const auto alternatives = [](const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : "|") + word;
    return text;
  };
  const auto flaw = [](const std::string& key, const std::string& expected) {
    return "'" + key + "' of the hello; expected " + expected;
  };
  for (const auto& [key, words] : allowed)
    if (json.contains(key) && !is_one_of(json[key], words)) return flaw(key, alternatives(words));
  if (json["hello"] != 1) return flaw("hello", "1");
  if (json.contains("batch") && !json["batch"].is_boolean()) return flaw("batch", "true or false");
  if (json.contains("questions")) {
    bool is_known = json["questions"].is_array();
    for (const auto& question : json["questions"]) is_known = is_known && is_one_of(question, kinds);
    if (!is_known) return flaw("questions", "a list of " + alternatives(kinds));
  }
  if (json.contains("sizes")) {
    const auto& sizes = json["sizes"];
    const bool is_range =
        sizes.is_array() && sizes.size() == 2 && sizes[0].is_number() && sizes[1].is_number() && sizes[0] <= sizes[1];
    if (!is_range) return flaw("sizes", "two numbers, the lower first");
  }
  return "";
}

std::optional<std::string> next_object(Command_process& process, Command_process::Deadline deadline,
                                       std::uint64_t& skipped)
{
  for (;; ++skipped) {
    auto line = process.line(deadline);
    if (!line || line->starts_with('{')) return line;
    if (std::chrono::steady_clock::now() > deadline) return std::nullopt;  // lines come without end
  }
}

std::optional<std::array<double, 7>> rigid_motion(const kernel::Pose& pose)
{
  constexpr double rigid = 1e-12;  // what some products of rounded rotations are off by
  const auto rotation = kernel::rotation_quaternion(pose);
  if (!rotation || rotation->error > rigid) return std::nullopt;
  std::array<double, 7> motion;
  for (std::size_t k = 0; k < 4; ++k) motion[k] = kernel::nearest_double(rotation->quaternion[k]);
  for (std::size_t k = 0; k < 3; ++k) motion[4 + k] = pose[int(4 * k + 3)];
  return motion;
}

std::string model(std::uint64_t number, const covering::Polyhedron& body)
{
  std::string text = "{\"model\":" + std::to_string(number) + ",\"vertices\":";
  list(text, body.vertices.size(), [&](std::size_t v) { text += vertex_text(body.vertices[v]); });
  text += ",\"faces\":";
  list(text, body.face_count(), [&](std::size_t f) {
    const auto face = covering::Index(f);
    list(text, body.loop_count(face), [&](std::size_t l) {
      const covering::Loop loop = body.loop(face, l);
      list(text, loop.size(), [&](std::size_t k) { text += std::to_string(loop[k]); });
    });
  });
  if (const auto triangles = verify::triangles_of(body)) {
    text += ",\"triangles\":";
    list(text, triangles->size(),
         [&](std::size_t t) { list(text, 3, [&](std::size_t k) { text += std::to_string((*triangles)[t][k]); }); });
  }
  return text + "}\n";
}

std::string forget(std::uint64_t number) { return "{\"forget\":" + std::to_string(number) + "}\n"; }

std::string ask(std::uint64_t ask, std::uint64_t a, std::uint64_t b, const kernel::Pose& pose_a,
                const kernel::Pose& pose_b, kernel::Question question)
{
  return of_two(ask, a, b, pose_a, pose_b) + ",\"question\":\"" + std::string(kernel::to_string(question)) + "\"}\n";
}

std::string relation(std::uint64_t ask, std::uint64_t a, std::uint64_t b, const kernel::Pose& pose_a,
                     const kernel::Pose& pose_b)
{
  return of_two(ask, a, b, pose_a, pose_b) + question_text(Kind::relation);
}

std::string distance(std::uint64_t ask, std::uint64_t a, std::uint64_t b, const kernel::Pose& pose_a,
                     const kernel::Pose& pose_b, kernel::Question of)
{
  return of_two(ask, a, b, pose_a, pose_b) + question_text(Kind::distance, of);
}

std::string within(std::uint64_t ask, std::uint64_t a, std::uint64_t b, const kernel::Pose& pose_a,
                   const kernel::Pose& pose_b, kernel::Question of, const std::string& limit)
{
  return of_two(ask, a, b, pose_a, pose_b) + ",\"limit\":" + number_text(limit) + question_text(Kind::within, of);
}

std::string first_contact(std::uint64_t ask, std::uint64_t a, std::uint64_t b,
                          const std::array<kernel::Pose, 2>& motion_a, const std::array<kernel::Pose, 2>& motion_b,
                          kernel::Question of)
{
  return of_two(ask, a, b, motion_a[0], motion_b[0]) + ",\"end_a\":" + pose_text(motion_a[1]) +
         ",\"end_b\":" + pose_text(motion_b[1]) + rigid_text("rigid_end_a", motion_a[1]) +
         rigid_text("rigid_end_b", motion_b[1]) + question_text(Kind::first_contact, of);
}

std::string inside(std::uint64_t ask, std::uint64_t a, const kernel::Vertex& point)
{
  return of_one(ask, a) + ",\"point\":" + vertex_text(point) + question_text(Kind::inside);
}

std::string ray(std::uint64_t ask, std::uint64_t a, const kernel::Vertex& origin, const kernel::Vertex& direction)
{
  return of_one(ask, a) + ",\"origin\":" + vertex_text(origin) + ",\"direction\":" + vertex_text(direction) +
         question_text(Kind::ray);
}

std::string triangles(std::uint64_t ask, const verify::Predicate_case& c)
{
  std::string text = "{\"ask\":" + std::to_string(ask);
  const auto pair = verify::placed_triangles(c);
  for (const char body : {'a', 'b'}) {
    text += std::string(",\"triangle_") + body + "\":";
    list(text, 3, [&](std::size_t corner) {
      list(text, 3, [&](std::size_t k) { text += number_text(kernel::exact_text(pair[body - 'a'][corner][k])); });
    });
  }
  return text + question_text(Kind::triangles);
}

std::string batch(const std::vector<std::string>& asks)
{
  std::string text = "{\"asks\":";
  list(text, asks.size(), [&](std::size_t k) { text += asks[k].substr(0, asks[k].find('\n')); });
  return text + "}\n";
}

Reply read(const std::string& line, std::uint64_t ask, Kind kind)
{
  return reply_of(nlohmann::json::parse(line, nullptr, false), line, ask, kind);
}

std::vector<Reply> read_batch(const std::string& line, std::uint64_t first, std::size_t count)
{
  const auto json = nlohmann::json::parse(line, nullptr, false);
  if (!json.is_object() || !json.contains("answers") || !json["answers"].is_array() || json["answers"].size() != count)
    return {{std::nullopt,
             "the line " + shown(line) + " does not answer the batch; expected {\"answers\": [" +
                 std::to_string(count) + " answers]}",
             {}}};
  std::vector<Reply> replies;
  for (const auto& answer : json["answers"]) replies.push_back(reply_of(answer, answer.dump(), first + replies.size()));
  return replies;
}

}  // namespace tetracone::experiments::subject_lines
