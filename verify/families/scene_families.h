#ifndef TETRACONE_VERIFY_FAMILIES_SCENE_FAMILIES_H
#define TETRACONE_VERIFY_FAMILIES_SCENE_FAMILIES_H

#include "verify/cases/random.h"
#include "verify/cases/scene_case.h"
#include "verify/families/named_family.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace tetracone::verify {

/// A family of scenes, whose names begin with "scene". A case has several frames, since a `Scene` keeps answers from
/// frame to frame and must drop those that no longer hold.
struct Scene_family : Named_family {
  /// Makes a scene of some frames, without its question and origin.
  Scene_case (*make)(Random& random, double parameter);

  /// Returns case `index` of the family. Its random numbers also choose the question.
  Scene_case scene_case(std::uint64_t seed, std::uint64_t index) const;
};

/// Returns all of them, in the order of their numbers.
const std::vector<Scene_family>& scene_families();

}  // namespace tetracone::verify

#endif
