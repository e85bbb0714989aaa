#ifndef TETRACONE_VERIFY_RELATIONS_SCENE_RELATIONS_H
#define TETRACONE_VERIFY_RELATIONS_SCENE_RELATIONS_H

#include "verify/relations/metamorphic_relations.h"
#include "verify/subjects/scene_subject.h"

#include <span>
#include <string_view>

namespace tetracone::verify {

/// A relation between a subject's answers for a scene, which are given, and its answers for twins that were made
/// without rounding.
struct Scene_relation {
  using Check = Verdict(const Scene_case& c, Running_scene& subject, const Frames_of_pairs& given, Random& random);

  std::string_view name, what;
  Check* check;
};

/// Returns all of them.
std::span<const Scene_relation> scene_relations();

}  // namespace tetracone::verify

#endif
