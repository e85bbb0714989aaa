#ifndef TETRACONE_VERIFY_FAMILIES_SCENE_FAMILIES_H
#define TETRACONE_VERIFY_FAMILIES_SCENE_FAMILIES_H

#include "verify/cases/random.h"
#include "verify/cases/scene_case.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace tetracone::verify {

/// A named generator of scenes: (seed, index) -> case. A scene keeps the common part of consecutive frames, and must
/// forget the rest.
struct Scene_family {
  int number;                  ///< from 1
  std::string_view name;       ///< of lower-case words joined by '-'; the first is scene
  std::string_view what;       ///< what its cases have in common, in a line
  std::string_view parameter;  ///< what the parameter means
  std::vector<double> sweep;   ///< the values that the parameter takes in turn

  /// Makes a scene of some frames, without its question and origin.
  Scene_case (*make)(Random& random, double parameter);

  /// Case `index` of the family, for either question. The case is equal on every machine and in any order of calls.
  Scene_case scene_case(std::uint64_t seed, std::uint64_t index) const;
};

/// Returns all of them, in the order of their numbers.
const std::vector<Scene_family>& scene_families();

/// Returns the family of this name; null when there is none.
const Scene_family* find_scene_family(std::string_view name);

}  // namespace tetracone::verify

#endif
