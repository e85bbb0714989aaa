#ifndef TETRACONE_EXPERIMENTS_VIEWER_VIEW_SCENE_H
#define TETRACONE_EXPERIMENTS_VIEWER_VIEW_SCENE_H

#include "experiments/support/motion_options.h"
#include "tetracone/kernel/predicate/question.h"
#include "verify/cases/case_file.h"

#include <optional>

namespace tetracone::experiments {

/// Two bodies in motion until they first meet, or to the end; the scene's poses are at these times, at most 61.
struct View_motion {
  std::vector<double> times;
  std::optional<First_contact> first;
};

/// How A is moved out of B.
struct View_way_out {
  std::array<std::string, 3> along;  ///< the direction, in decimals or fractions; all empty: by the least translation
  bool is_least() const { return along[0].empty(); }
};

/// One or two bodies under poses.
struct View_scene {
  std::string name;                ///< the names of the files without their folders
  std::vector<Model_file> bodies;  ///< one or two
  Pose_pairs poses;
  kernel::Question question = kernel::Question::solid;
  std::optional<verify::Case_file> from;    ///< the case file, if it is one's
  std::vector<std::array<double, 6>> rays;  ///< of one body, in its own coordinates: origin and direction
  std::optional<View_motion> motion;
  std::optional<View_way_out> way_out;  ///< of two solids
};

/// Reads a scene. The bodies of a predicate's case are the points, segments, triangles and tetrahedra of the predicate.
/// `question` is the question of two bodies; nothing means solid, or the case file's own. Throws covering::Input_error
/// for bad input and CLI::ValidationError for names that exclude each other.
View_scene read_view_scene(const Scene_names& names, std::optional<kernel::Question> question);

/// Reads a scene of one motion of two models, and follows it to the first contact. Times at which a linear motion is
/// flat are left out. Throws as `read_view_scene`, and CLI::ValidationError for more than one motion.
View_scene read_view_motion(const Motion_names& names, kernel::Question question);

}  // namespace tetracone::experiments

#endif
