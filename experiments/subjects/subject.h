#ifndef TETRACONE_EXPERIMENTS_SUBJECTS_SUBJECT_H
#define TETRACONE_EXPERIMENTS_SUBJECTS_SUBJECT_H

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

/// The protocol's side of the subjects in C++; README.md describes it.
namespace tetracone::subject {

using nlohmann::json;
using Point = std::array<double, 3>;

/// A body in triangles.
struct Body {
  std::vector<Point> vertices;
  std::vector<std::array<unsigned, 3>> triangles;
};

/// A question about two bodies.
struct Ask {
  std::string question;                                   ///< "surface" or "solid"
  std::array<double, 12> pose_a, pose_b;                  ///< row-major 3x4; fractions are rounded
  std::optional<std::array<double, 7>> rigid_a, rigid_b;  ///< quaternion w x y z and translation; nothing: not rigid
  json line;                                              ///< as it was asked, with poses of fractions
};

/// Returns the point's image under a row-major 3x4 matrix, rounded.
inline Point image(const std::array<double, 12>& m, const Point& p)
{
  Point x;
  for (std::size_t i = 0; i < 3; ++i) x[i] = m[4 * i] * p[0] + m[4 * i + 1] * p[1] + m[4 * i + 2] * p[2] + m[4 * i + 3];
  return x;
}

/// Returns the body's triangles, or fans of its faces if an old harness gave no triangles. Returns nothing for fans of
/// a face with a hole, and for a triangle that has a corner twice, which these libraries do not take.
inline std::optional<Body> body_of(const json& model)
{
  Body body{model["vertices"], {}};
  if (model.contains("triangles"))
    body.triangles = model["triangles"];
  else
    for (const json& face : model["faces"]) {
      if (face.size() > 1) return std::nullopt;
      for (std::size_t k = 2; k < face[0].size(); ++k)
        body.triangles.push_back({face[0][0], face[0][k - 1], face[0][k]});
    }
  for (const auto& t : body.triangles)
    if (std::set<unsigned>(t.begin(), t.end()).size() < 3) return std::nullopt;
  return body;
}

/// Returns a pose's number. Fractions are rounded; their integers may be beyond the doubles.
inline double number(const json& n)
{
  if (n.is_number()) return n;
  const std::string text = n;
  return double(std::strtold(text.c_str(), nullptr) / std::strtold(&text[text.find('/') + 1], nullptr));
}

/// Returns the question of a line that asks about two bodies.
inline Ask ask_of(const json& line)
{
  Ask ask{line["question"], {}, {}, {}, {}, line};
  for (std::size_t k = 0; k < 12; ++k) {
    ask.pose_a[k] = number(line["pose_a"][k]);
    ask.pose_b[k] = number(line["pose_b"][k]);
  }
  if (line.contains("rigid_a")) ask.rigid_a = line["rigid_a"];
  if (line.contains("rigid_b")) ask.rigid_b = line["rigid_b"];
  return ask;
}

/// Says hello and answers until the input ends; returns 0, the status of the program. prepare(body) returns a shared
/// pointer to a library's form of a body, null to decline it. collide(a, b, ask) returns nothing to decline; it alone
/// is timed. Throws what nlohmann::json throws for a line that does not follow the protocol.
template <class Prepare, class Collide>
int serve(json hello, const Prepare& prepare, const Collide& collide)
{
  hello["hello"] = 1;
  std::cout << hello << std::endl;
  std::map<std::uint64_t, decltype(prepare(Body()))> bodies;
  for (std::string line; std::getline(std::cin, line);) {
    const json m = json::parse(line);
    if (m.contains("model")) {
      const auto body = body_of(m);
      bodies[m["model"]] = body ? prepare(*body) : nullptr;
    }
    if (m.contains("forget")) bodies.erase(std::uint64_t(m["forget"]));
    if (!m.contains("ask")) continue;
    json answer = {{"ask", m["ask"]}, {"answer", nullptr}};
    const auto &a = bodies[m["a"]], &b = bodies[m["b"]];
    const Ask ask = ask_of(m);
    const auto start = std::chrono::steady_clock::now();
    if (const std::optional<bool> hit = a && b ? collide(*a, *b, ask) : std::nullopt) {
      answer["answer"] = int(*hit);
      answer["ns"] = std::chrono::nanoseconds(std::chrono::steady_clock::now() - start).count();
    }
    std::cout << answer << std::endl;
  }
  return 0;
}

}  // namespace tetracone::subject

#endif
