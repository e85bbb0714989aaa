#ifndef TETRACONE_VERIFY_CASES_SCENE_CASE_H
#define TETRACONE_VERIFY_CASES_SCENE_CASE_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/question.h"
#include "verify/cases/case.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace tetracone::verify {

/// Two bodies of a scene by their numbers, the lesser first.
using Body_pair = std::array<std::size_t, 2>;

/// Many bodies over frames, complete in itself.
struct Scene_case {
  struct Standing {
    std::size_t model;
    kernel::Pose pose;

    friend bool operator==(const Standing&, const Standing&) = default;
  };
  struct Frame {
    /// By number, equally many in every frame; nothing for an absent body.
    std::vector<std::optional<Standing>> bodies;
    /// All pairs that are not asked for in this frame; each frame repeats those of the frames before.
    std::vector<Body_pair> ignored;
  };

  std::vector<std::shared_ptr<const covering::Polyhedron>> models;
  kernel::Question question;
  std::vector<Frame> frames;
  Origin origin;
};

}  // namespace tetracone::verify

#endif
