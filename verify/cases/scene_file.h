#ifndef TETRACONE_VERIFY_CASES_SCENE_FILE_H
#define TETRACONE_VERIFY_CASES_SCENE_FILE_H

#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/kernel/number/pose.h"
#include "verify/cases/json_field.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

/// Scene files, `*.scene.json`: many bodies over frames.
namespace tetracone::verify {

/// True when a path has the name of a scene file.
bool is_scene_name(const std::filesystem::path& path);

/// An open scene file. Its models and bodies are read at once, each frame on demand.
class Scene_file {
 public:
  /// Opens the file. Throws covering::Input_error, with the line, for:
  /// - missing or unknown members, and wrong types;
  /// - bodies without a model;
  /// - numbers out of range;
  /// - a file of frames that is no whole number of frames.
  /// A pose has 12 numbers, or 7 if `is_rigid`: a quaternion w x y z and a translation.
  explicit Scene_file(const std::filesystem::path& path, bool is_rigid = false);

  struct Model {
    std::string name;
    std::filesystem::path file;  ///< relative names are of the scene file's folder
  };
  const std::vector<Model>& models() const { return models_; }
  /// The model of each body.
  const std::vector<std::size_t>& bodies() const { return bodies_; }
  /// Pairs of bodies that are not asked for.
  const std::vector<std::array<std::size_t, 2>>& ignored() const { return ignored_; }

  std::size_t frame_count() const { return frame_count_; }
  /// Returns the poses of frame `k`, one per body. Throws Input_error for numbers that are not finite and for det M =
  /// 0. Requires poses of 12 numbers.
  std::vector<kernel::Pose> frame(std::size_t k);
  /// Returns frame `k` as rigid poses. Throws Input_error for numbers that are not finite and for a quaternion of 0.
  std::vector<kernel::Rigid_pose> rigid_frame(std::size_t k);

  /// Returns all files that it names, and itself.
  std::vector<std::filesystem::path> files() const;

 private:
  template <std::size_t N>
  std::vector<std::array<double, N>> numbers_of_file(std::size_t k);
  std::vector<kernel::Pose> frame_of_file(std::size_t k);
  [[noreturn]] void fail(std::size_t frame, std::size_t body, const std::string& wrong, const char* expected) const;

  std::filesystem::path path_, frames_path_;
  std::unique_ptr<Json_text> text_;
  std::vector<Model> models_;
  std::vector<std::size_t> bodies_;
  std::vector<std::array<std::size_t, 2>> ignored_;
  std::size_t frame_count_ = 0;
  std::vector<Json_field> frames_;  // where they are in the text
  std::ifstream frames_file_;       // where they are not
};

}  // namespace tetracone::verify

#endif
