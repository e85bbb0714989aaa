#ifndef TETRACONE_VERIFY_SUBJECTS_SCENE_SUBJECT_H
#define TETRACONE_VERIFY_SUBJECTS_SCENE_SUBJECT_H

#include "verify/cases/scene_case.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tetracone::verify {

/// The pairs that collide, sorted, of each frame.
using Frames_of_pairs = std::vector<std::vector<Body_pair>>;

/// A subject that is asked about scenes, in one thread.
class Running_scene {
 public:
  virtual ~Running_scene() = default;

  /// Nothing for an answer: it failed.
  virtual std::optional<Frames_of_pairs> play(const Scene_case& c) = 0;
};

/// Something that says which of many bodies collide.
struct Scene_subject {
  std::string name;  ///< "adaptive scene", "adaptive scene threads"
  bool is_exact = false;
  std::function<std::unique_ptr<Running_scene>()> make;
};

/// The library's `Scene`: alone, by two threads, with as little memory as will do, under a budget until nothing is
/// undecided, and in double; and a `Query` for each pair of bodies, which remembers.
std::vector<Scene_subject> scene_subjects();

}  // namespace tetracone::verify

#endif
