#ifndef TETRACONE_VERIFY_TEST_SUPPORT_FORGED_BODY_H
#define TETRACONE_VERIFY_TEST_SUPPORT_FORGED_BODY_H

#include "tetracone/tetratree/door/body_file.h"
#include "tetracone/tetratree/door/checksum.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <sstream>
#include <string>

namespace tetracone::verify {

/// Returns the bytes of a changed saved body with the checksum that is right for them.
inline std::string forged(std::string bytes)
{
  constexpr std::size_t at = tetracone::detail::place_of_checksum;
  if (bytes.size() < at + sizeof(std::uint64_t)) return bytes;
  std::memset(&bytes[at], 0, sizeof(std::uint64_t));
  tetracone::detail::Checksum sum;
  sum.add(std::as_bytes(std::span(bytes)));
  const std::uint64_t value = sum.value();
  std::memcpy(&bytes[at], &value, sizeof value);
  return bytes;
}

/// Returns the body's answers about poses, points and rays, as a text. Bodies of equal vertices and faces give equal
/// texts.
inline std::string answers(const Body& body)
{
  static const Body probe = [] {
    Polyhedron tetrahedron;
    tetrahedron.vertices = {{0.25, 0.25, 0.25}, {2, 0.5, 0.25}, {0.5, 2, 0.75}, {0.25, 0.75, 2}};
    for (const auto& face : {std::array{0u, 2u, 1u}, {0u, 1u, 3u}, {1u, 2u, 3u}, {0u, 3u, 2u}})
      tetrahedron.add_polygon(face);
    return Body(tetrahedron);
  }();
  static const tetracone::Pose poses[] = {tetracone::Pose(), tetracone::Pose::translation(0.75, 0, 0),
                                          tetracone::Pose::translation(-1, 1.5, 0.125),
                                          tetracone::Pose({0.8, -0.6, 0, 0.1, 0.6, 0.8, 0, -0.3, 0, 0, 1, 0.4})};
  std::ostringstream text;
  text.precision(17);
  const auto told = [&](const auto& what) {
    try {
      text << what();
    } catch (const Error& error) {
      text << error.what();
    }
    text << ' ';
  };
  text << body.is_closed() << '\n';
  for (const Question question : {Question::surface, Question::solid}) {
    if (question == Question::solid && !body.is_closed()) continue;
    Query first(body, probe, question), second(probe, body, question);
    for (const tetracone::Pose& pose : poses) {
      told([&] { return int(first.collide(tetracone::Pose(), pose).relation()); });
      told([&] { return int(second.collide(pose, tetracone::Pose()).relation()); });
      told([&] { return first.distance(tetracone::Pose(), pose); });
      told([&] { return first.within(tetracone::Pose(), pose, 0.25); });
      told([&] { return first.features(tetracone::Pose(), pose).size(); });
      told([&] { return first.contacts(tetracone::Pose(), pose).size(); });
    }
  }
  for (const double x : {0.0, 0.125, 0.5, 0.9, 1.0}) {
    const std::array<double, 3> point{x, 0.5 * x + 0.25, 0.375};
    if (body.is_closed()) told([&] { return int(body.inside(point)); });
    for (const auto& hit : body.hits({{x, -3, 0.25}, {0.01, 1, x}})) text << hit.face << ':' << hit.t << ' ';
  }
  return text.str();
}

}  // namespace tetracone::verify

#endif
