#ifndef TETRACONE_VERIFY_SUBJECTS_SCENE_SUBJECT_H
#define TETRACONE_VERIFY_SUBJECTS_SCENE_SUBJECT_H

#include "verify/cases/scene_case.h"
#include "verify/subjects/running.h"

#include <vector>

namespace tetracone::verify {

/// The sorted pairs that collide in each frame.
using Frames_of_pairs = std::vector<std::vector<Body_pair>>;

using Running_scene = Running<Scene_case, Frames_of_pairs>;
using Scene_subject = Subject_of<Running_scene>;

/// Returns the subjects for scenes. They are the library's `Scene` on one thread, on two threads, with minimal memory,
/// under a budget until nothing is undecided, and in double. A remembering `Query` for each pair of bodies is another.
std::vector<Scene_subject> scene_subjects();

}  // namespace tetracone::verify

#endif
