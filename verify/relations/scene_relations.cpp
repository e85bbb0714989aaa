#include "tetracone/kernel/number/number.h"
#include "verify/cases/exact_motion.h"
#include "verify/relations/changed_bodies.h"
#include "verify/relations/relations.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace tetracone::verify {
namespace {

using kernel::Question;
using kernel::Rational;

Verdict same_pairs(const Scene_level::Trial& t, const Frames_of_pairs& expected, const Scene_case& twin)
{
  return verdict(t.subject(twin), [&](const Frames_of_pairs& told) { return told == expected; });
}

Verdict reordered_bodies(const Scene_level::Trial& t)
{
  if (t.c.frames.empty()) return Verdict::not_applicable;
  std::vector<std::size_t> place(t.c.frames[0].bodies.size());
  std::iota(place.begin(), place.end(), std::size_t(0));
  shuffle(place, t.random);
  const auto renumbered = [&place](std::vector<Body_pair> pairs) {
    for (Body_pair& pair : pairs) {
      const auto [a, b] = std::minmax(place[pair[0]], place[pair[1]]);
      pair = {a, b};
    }
    std::ranges::sort(pairs);
    return pairs;
  };
  Scene_case twin = t.c;
  Frames_of_pairs expected;
  for (std::size_t f = 0; f < t.c.frames.size(); ++f) {
    for (std::size_t k = 0; k < place.size(); ++k) twin.frames[f].bodies[place[k]] = t.c.frames[f].bodies[k];
    twin.frames[f].ignored = renumbered(t.c.frames[f].ignored);
    expected.push_back(renumbered(t.given[f]));
  }
  return same_pairs(t, expected, twin);
}

Verdict moved_bodies(const Scene_level::Trial& t)
{
  const auto p = Signed_permutation::any(t.random);
  std::array<Rational, 3> shift;
  for (Rational& x : shift) x = Rational(int(one_of(t.random, 41)) - 20) / 7;
  Scene_case twin = t.c;
  for (Scene_case::Frame& frame : twin.frames)
    for (auto& body : frame.bodies) {
      if (!body) continue;
      Entries entries = entries_of(turned(p, body->pose));
      for (std::size_t k = 0; k < 3; ++k) entries[4 * k + 3] += shift[k];
      const auto pose = exact_pose(entries, true);
      if (!pose) return Verdict::not_applicable;
      body->pose = *pose;
    }
  return same_pairs(t, t.given, twin);
}

Verdict begun_later(const Scene_level::Trial& t)
{
  const auto first = std::ptrdiff_t(one_of(t.random, t.c.frames.size()));
  Scene_case twin = t.c;
  twin.frames.erase(twin.frames.begin(), twin.frames.begin() + first);
  return same_pairs(t, Frames_of_pairs(t.given.begin() + first, t.given.end()), twin);
}

/// The last frame first: what is ignored for good keeps it to scenes that ignore nothing.
Verdict frames_backwards(const Scene_level::Trial& t)
{
  Scene_case twin = t.c;
  for (const Scene_case::Frame& frame : t.c.frames)
    if (!frame.ignored.empty()) return Verdict::not_applicable;
  std::ranges::reverse(twin.frames);
  return same_pairs(t, Frames_of_pairs(t.given.rbegin(), t.given.rend()), twin);
}

Verdict each_frame_twice(const Scene_level::Trial& t)
{
  Scene_case twin = t.c;
  twin.frames.clear();
  Frames_of_pairs expected;
  for (std::size_t f = 0; f < t.c.frames.size(); ++f) {
    twin.frames.insert(twin.frames.end(), 2, t.c.frames[f]);
    expected.insert(expected.end(), 2, t.given[f]);
  }
  return same_pairs(t, expected, twin);
}

Verdict surfaces_among_solids(const Scene_level::Trial& t)
{
  Scene_case twin = t.c;
  twin.question = t.c.question == Question::surface ? Question::solid : Question::surface;
  const auto told = t.subject(twin);
  if (told.outcome != Outcome::yes) return Verdict::not_applicable;
  const bool is_solid = t.c.question == Question::solid;
  for (std::size_t f = 0; f < t.given.size(); ++f)
    if (!std::ranges::includes(is_solid ? t.given[f] : told.answer[f], is_solid ? told.answer[f] : t.given[f]))
      return Verdict::violated;
  return Verdict::holds;
}

constexpr std::array of_scenes = std::to_array<Scene_level::Relation>({
    {"S1 order", "bodies in another order collide as the same bodies", reordered_bodies},
    {"S2 common motion", "all bodies under one more isometry collide as before", moved_bodies},
    {"S3 later", "a scene that begins at a frame has the pairs of that frame and those after it", begun_later},
    {"S4 backwards", "frames in the other order have the same pairs", frames_backwards},
    {"S5 twice", "a frame that is asked twice has the same pairs twice", each_frame_twice},
    {"S6 question", "bodies whose surfaces meet are among those whose solids do", surfaces_among_solids},
});

}  // namespace

std::span<const Scene_level::Relation> scene_relations() { return of_scenes; }

}  // namespace tetracone::verify
