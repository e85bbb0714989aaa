#include "experiments/peers/subject_lines.h"

#include "experiments/peers/peer.h"
#include "tetracone/covering/check.h"
#include "tetracone/kernel/motion/rotation_quaternion.h"
#include "tetracone/kernel/number/number.h"
#include "verify/relations/convex_body.h"

#include <nlohmann/json.hpp>

#include <algorithm>

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

std::string pose_text(const kernel::Pose& pose)
{
  std::string text;
  list(text, 12, [&](std::size_t k) {
    const int entry = int(k);
    const std::string number =
        pose.is_rational() ? kernel::exact_text(pose.exact(entry)) : kernel::shortest(pose[entry]);
    text += number.find('/') == std::string::npos ? number : '"' + number + '"';
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

Reply reply_of(const nlohmann::json& json, const std::string& line, std::uint64_t ask)
{
  const std::string form = "{\"ask\": " + std::to_string(ask) + ", \"answer\": 0, 1 or null}";
  const auto wrong = [&](const std::string& what) { return Reply{std::nullopt, what + "; expected " + form, {}}; };
  if (!json.is_object()) return wrong("the line " + shown(line) + " is no JSON object");
  const auto number = json.find("ask"), answer = json.find("answer");
  if (number == json.end() || !number->is_number_integer() || *number != ask)
    return wrong("the line " + shown(line) + " does not name this ask");
  if (answer == json.end()) return wrong("the line " + shown(line) + " has no answer");
  if (answer->is_null()) return {verify::Outcome::not_asked, "", {}};
  if (!answer->is_number_integer() || (*answer != 0 && *answer != 1))
    return wrong("the answer of " + shown(line) + " is neither 0, 1 nor null");
  Reply reply{*answer == 1 ? verify::Outcome::yes : verify::Outcome::no, "", {}};
  constexpr double longest = 1e18;  // 30 years: more is no time, and might be no integer of 64 bits
  const auto ns = json.find("ns");
  if (ns != json.end() && ns->is_number() && *ns >= 0.0 && *ns <= longest) reply.ns = std::uint64_t(ns->get<double>());
  return reply;
}

/// The largest body of which convexity is decided: the decision compares all faces with all vertices.
constexpr std::size_t most_faces_of_convex = 1000;

}  // namespace

bool Hello::takes(kernel::Question question) const
{
  return questions.empty() || std::ranges::find(questions, kernel::to_string(question)) != questions.end();
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
  const auto questions = json.find("questions"), batch = json.find("batch");
  if (questions != json.end() && questions->is_array())
    for (const auto& question : *questions)
      if (question.is_string()) hello.questions.push_back(question);
  hello.takes_batches = batch != json.end() && *batch == true;
  return hello;
}

std::optional<std::string> next_object(Command_process& process, Command_process::Deadline deadline,
                                       std::uint64_t& skipped)
{
  for (;; ++skipped) {
    auto line = process.line(deadline);
    if (!line || line->starts_with('{')) return line;
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
  list(text, body.vertices.size(),
       [&](std::size_t v) { list(text, 3, [&](std::size_t k) { text += kernel::shortest(body.vertices[v][k]); }); });
  text += ",\"faces\":";
  list(text, body.face_count(), [&](std::size_t f) {
    const auto face = covering::Index(f);
    list(text, body.loop_count(face), [&](std::size_t l) {
      const covering::Loop loop = body.loop(face, l);
      list(text, loop.size(), [&](std::size_t k) { text += std::to_string(loop[k]); });
    });
  });
  if (const auto triangles = peer_triangles(body)) {
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
  return "{\"ask\":" + std::to_string(ask) + ",\"a\":" + std::to_string(a) + ",\"b\":" + std::to_string(b) +
         ",\"pose_a\":" + pose_text(pose_a) + ",\"pose_b\":" + pose_text(pose_b) + rigid_text("rigid_a", pose_a) +
         rigid_text("rigid_b", pose_b) + ",\"question\":\"" + std::string(kernel::to_string(question)) + "\"}\n";
}

std::string batch(const std::vector<std::string>& asks)
{
  std::string text = "{\"asks\":";
  list(text, asks.size(), [&](std::size_t k) { text += asks[k].substr(0, asks[k].find('\n')); });
  return text + "}\n";
}

Reply read(const std::string& line, std::uint64_t ask)
{
  return reply_of(nlohmann::json::parse(line, nullptr, false), line, ask);
}

std::vector<Reply> read_batch(const std::string& line, std::uint64_t first, std::size_t count)
{
  const auto json = nlohmann::json::parse(line, nullptr, false);
  if (!json.is_object() || !json.contains("answers") || json["answers"].size() != count)
    return {{std::nullopt,
             "the line " + shown(line) + " does not answer the batch; expected {\"answers\": [" +
                 std::to_string(count) + " answers]}",
             {}}};
  std::vector<Reply> replies;
  for (const auto& answer : json["answers"]) replies.push_back(reply_of(answer, answer.dump(), first + replies.size()));
  return replies;
}

}  // namespace tetracone::experiments::subject_lines
