#include "experiments/peers/subject_lines.h"

#include "tetracone/kernel/number/number.h"

#include <nlohmann/json.hpp>

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

/// A line as messages show it.
std::string shown(const std::string& line)
{
  constexpr std::size_t enough = 80;
  const std::string start = line.substr(0, enough);
  return nlohmann::json(start + (line.size() > enough ? "..." : ""))
      .dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

}  // namespace

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
  return text + "}\n";
}

std::string forget(std::uint64_t number) { return "{\"forget\":" + std::to_string(number) + "}\n"; }

std::string ask(std::uint64_t ask, std::uint64_t a, std::uint64_t b, const kernel::Pose& pose_a,
                const kernel::Pose& pose_b, kernel::Question question)
{
  return "{\"ask\":" + std::to_string(ask) + ",\"a\":" + std::to_string(a) + ",\"b\":" + std::to_string(b) +
         ",\"pose_a\":" + pose_text(pose_a) + ",\"pose_b\":" + pose_text(pose_b) + ",\"question\":\"" +
         std::string(kernel::to_string(question)) + "\"}\n";
}

Reply read(const std::string& line, std::uint64_t ask)
{
  const std::string form = "{\"ask\": " + std::to_string(ask) + ", \"answer\": 0, 1 or null}";
  const auto wrong = [&](const std::string& what) { return Reply{std::nullopt, what + "; expected " + form, {}}; };
  const auto json = nlohmann::json::parse(line, nullptr, false);
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

}  // namespace tetracone::experiments::subject_lines
