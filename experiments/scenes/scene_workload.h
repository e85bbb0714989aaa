#ifndef TETRACONE_EXPERIMENTS_SCENES_SCENE_WORKLOAD_H
#define TETRACONE_EXPERIMENTS_SCENES_SCENE_WORKLOAD_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/pose.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tetracone::experiments {

/// Many moving bodies, made from a seed: the kinds of scenes of Broadmark (Serpa and Rodrigues, "Broadmark: A Testing
/// Framework for Broad-Phase Collision Detection Algorithms", 2020), and two more.
///  - brownian: each body takes a random step and turns slightly in each frame;
///  - fall: bodies fall freely, each from its own height, and begin again at the top;
///  - gravity: bodies are drawn to the middle, and go through it;
///  - thin: long thin bodies turn in place;
///  - resting: one body in a hundred moves as in brownian, the others rest.
struct Scene_workload {
  std::string kind, model;
  std::vector<covering::Polyhedron> models;  ///< triangles
  std::vector<std::size_t> model_of;         ///< of each body
  std::vector<std::vector<kernel::Pose>> frames;
};

/// Makes a workload. `model` is convex (80 triangles), blob (760, star-shaped) or large (7000); thin scenes have their
/// own models. Bodies fill about a tenth of the space. Poses are rotations and translations, rounded. In a scene of
/// another kind all bodies rest.
Scene_workload scene_workload(const std::string& kind, const std::string& model, std::size_t bodies, std::size_t frames,
                              std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
