#include "verify/relations/scene_relations.h"

#include "tetracone/kernel/number/number.h"
#include "verify/cases/exact_motion.h"
#include "verify/relations/changed_bodies.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace tetracone::verify {
namespace {

using kernel::Question;
using kernel::Rational;

Verdict same_pairs(const Frames_of_pairs& expected, const Scene_case& twin, Running_scene& subject)
{
  const auto told = subject.play(twin);
  if (!told) return Verdict::not_applicable;
  return *told == expected ? Verdict::holds : Verdict::violated;
}

Verdict reordered_bodies(const Scene_case& c, Running_scene& subject, const Frames_of_pairs& given, Random& random)
{
  if (c.frames.empty()) return Verdict::not_applicable;
  std::vector<std::size_t> place(c.frames[0].bodies.size());
  std::iota(place.begin(), place.end(), std::size_t(0));
  shuffle(place, random);
  const auto renumbered = [&place](std::vector<Body_pair> pairs) {
    for (Body_pair& pair : pairs) {
      const auto [a, b] = std::minmax(place[pair[0]], place[pair[1]]);
      pair = {a, b};
    }
    std::ranges::sort(pairs);
    return pairs;
  };
  Scene_case twin = c;
  Frames_of_pairs expected;
  for (std::size_t f = 0; f < c.frames.size(); ++f) {
    for (std::size_t k = 0; k < place.size(); ++k) twin.frames[f].bodies[place[k]] = c.frames[f].bodies[k];
    twin.frames[f].ignored = renumbered(c.frames[f].ignored);
    expected.push_back(renumbered(given[f]));
  }
  return same_pairs(expected, twin, subject);
}

Verdict moved_bodies(const Scene_case& c, Running_scene& subject, const Frames_of_pairs& given, Random& random)
{
  const auto p = Signed_permutation::any(random);
  std::array<Rational, 3> shift;
  for (Rational& x : shift) x = Rational(int(one_of(random, 41)) - 20) / 7;
  Scene_case twin = c;
  for (Scene_case::Frame& frame : twin.frames)
    for (auto& body : frame.bodies) {
      if (!body) continue;
      Entries entries = entries_of(turned(p, body->pose));
      for (std::size_t k = 0; k < 3; ++k) entries[4 * k + 3] += shift[k];
      const auto pose = exact_pose(entries, true);
      if (!pose) return Verdict::not_applicable;
      body->pose = *pose;
    }
  return same_pairs(given, twin, subject);
}

Verdict begun_later(const Scene_case& c, Running_scene& subject, const Frames_of_pairs& given, Random& random)
{
  const auto first = std::ptrdiff_t(one_of(random, c.frames.size()));
  Scene_case twin = c;
  twin.frames.erase(twin.frames.begin(), twin.frames.begin() + first);
  return same_pairs(Frames_of_pairs(given.begin() + first, given.end()), twin, subject);
}

/// The last frame first: what is ignored for good keeps it to scenes that ignore nothing.
Verdict frames_backwards(const Scene_case& c, Running_scene& subject, const Frames_of_pairs& given, Random&)
{
  Scene_case twin = c;
  for (const Scene_case::Frame& frame : c.frames)
    if (!frame.ignored.empty()) return Verdict::not_applicable;
  std::ranges::reverse(twin.frames);
  return same_pairs(Frames_of_pairs(given.rbegin(), given.rend()), twin, subject);
}

Verdict each_frame_twice(const Scene_case& c, Running_scene& subject, const Frames_of_pairs& given, Random&)
{
  Scene_case twin = c;
  twin.frames.clear();
  Frames_of_pairs expected;
  for (std::size_t f = 0; f < c.frames.size(); ++f) {
    twin.frames.insert(twin.frames.end(), 2, c.frames[f]);
    expected.insert(expected.end(), 2, given[f]);
  }
  return same_pairs(expected, twin, subject);
}

Verdict surfaces_among_solids(const Scene_case& c, Running_scene& subject, const Frames_of_pairs& given, Random&)
{
  Scene_case twin = c;
  twin.question = c.question == Question::surface ? Question::solid : Question::surface;
  const auto told = subject.play(twin);
  if (!told) return Verdict::not_applicable;
  const bool is_solid = c.question == Question::solid;
  for (std::size_t f = 0; f < given.size(); ++f)
    if (!std::ranges::includes(is_solid ? given[f] : (*told)[f], is_solid ? (*told)[f] : given[f]))
      return Verdict::violated;
  return Verdict::holds;
}

constexpr std::array relations_of_scenes = {
    Scene_relation{"S1 order", "bodies in another order collide as the same bodies", reordered_bodies},
    Scene_relation{"S2 common motion", "all bodies under one more isometry collide as before", moved_bodies},
    Scene_relation{"S3 later", "a scene that begins at a frame has the pairs of that frame and those after it",
                   begun_later},
    Scene_relation{"S4 backwards", "frames in the other order have the same pairs", frames_backwards},
    Scene_relation{"S5 twice", "a frame that is asked twice has the same pairs twice", each_frame_twice},
    Scene_relation{"S6 question", "bodies whose surfaces meet are among those whose solids do", surfaces_among_solids},
};

}  // namespace

std::span<const Scene_relation> scene_relations() { return relations_of_scenes; }

}  // namespace tetracone::verify
