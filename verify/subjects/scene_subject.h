#ifndef TETRACONE_VERIFY_SUBJECTS_SCENE_SUBJECT_H
#define TETRACONE_VERIFY_SUBJECTS_SCENE_SUBJECT_H

#include "verify/cases/scene_case.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tetracone::verify {

/// The sorted pairs that collide in each frame.
using Frames_of_pairs = std::vector<std::vector<Body_pair>>;

/// A running subject for scenes, for one thread.
class Running_scene {
 public:
  virtual ~Running_scene() = default;

  /// Returns the pairs of each frame; nothing if it failed.
  virtual std::optional<Frames_of_pairs> play(const Scene_case& c) = 0;
};

/// A method that answers which of many bodies collide.
struct Scene_subject {
  std::string name;  ///< "adaptive scene", "adaptive scene threads"
  bool is_exact = false;
  std::function<std::unique_ptr<Running_scene>()> make;
};

/// Returns the subjects for scenes: the library's `Scene` on one thread, on two threads, with minimal memory, under a
/// budget until nothing is undecided, and in double; and a remembering `Query` for each pair of bodies.
std::vector<Scene_subject> scene_subjects();

}  // namespace tetracone::verify

#endif
