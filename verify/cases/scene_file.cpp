#include "verify/cases/scene_file.h"

#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/text_lines.h"
#include "tetracone/kernel/number/number.h"
#include "verify/cases/json_pose.h"

#include <cmath>
#include <map>
#include <system_error>

namespace tetracone::verify {
namespace {

using covering::Input_error;
namespace fs = std::filesystem;

bool is_zero(const kernel::Rigid_pose& pose)
{
  for (const kernel::Rational& x : pose.quaternion)
    if (sgn(x) != 0) return false;
  return true;
}

/// A rigid pose from seven numbers, given as `number(k)`.
template <class Number>
kernel::Rigid_pose rigid_pose(const Number& number)
{
  return {{number(0), number(1), number(2), number(3)}, {number(4), number(5), number(6)}};
}

}  // namespace

bool is_scene_name(const fs::path& path) { return path.native().ends_with(".scene.json"); }

Scene_file::Scene_file(const fs::path& path, bool is_rigid)
    : path_(path), text_(std::make_unique<Json_text>(covering::read_text(path), path.native(), "a scene file"))
{
  const Json_field root(*text_);
  root.only({"models", "bodies", "frames", "frames_file", "ignore"});
  std::map<std::string, std::size_t> number_of;
  for (const auto& [name, file] : root.member("models").members("models by their names")) {
    number_of.emplace(name, models_.size());
    models_.push_back({name, path.parent_path() / file.text()});
  }
  for (const Json_field& body : root.member("bodies").items(1, "bodies")) {
    body.only({"model"});
    const Json_field model = body.member("model");
    const auto found = number_of.find(model.text());
    if (found == number_of.end())
      model.fail(covering::in_quotes(model.text()) + " is no model", "expected a name of 'models'");
    bodies_.push_back(found->second);
  }
  if (root.has("ignore"))
    for (const Json_field& pair : root.member("ignore").items(0, "pairs of bodies")) {
      const auto both = pair.exactly(2, "numbers of bodies");
      const std::array<std::size_t, 2> ignored = {both[0].unsigned_integer(bodies_.size() - 1),
                                                  both[1].unsigned_integer(bodies_.size() - 1)};
      if (ignored[0] == ignored[1]) pair.fail("is one body twice", "expected two bodies");
      ignored_.push_back(ignored);
    }
  if (root.has("frames") == root.has("frames_file"))
    root.fail(root.has("frames") ? "has 'frames' and 'frames_file'" : "has no 'frames'",
              "expected either 'frames' or 'frames_file'");
  if (root.has("frames")) {
    frames_ = root.member("frames").items(0, "frames");
    frame_count_ = frames_.size();
    return;
  }
  const Json_field name = root.member("frames_file");
  frames_path_ = path.parent_path() / name.text();
  std::error_code error;
  const auto bytes = fs::file_size(frames_path_, error);
  frames_file_.open(frames_path_, std::ios::binary);
  if (error || !frames_file_)
    throw Input_error(frames_path_.native(), 0,
                      "cannot be read: " + (error ? error : std::error_code(errno, std::generic_category())).message(),
                      "expected the frames as doubles");
  const std::size_t numbers = is_rigid ? 7 : 12, bytes_of_frame = bodies_.size() * numbers * sizeof(double);
  if (bytes % bytes_of_frame != 0)
    throw Input_error(frames_path_.native(), 0, "has " + std::to_string(bytes) + " bytes",
                      "expected a multiple of " + std::to_string(bytes_of_frame) + ", " + std::to_string(numbers) +
                          " doubles a body and frame");
  frame_count_ = bytes / bytes_of_frame;
}

std::vector<kernel::Pose> Scene_file::frame(std::size_t k)
{
  if (frames_.empty()) return frame_of_file(k);
  std::vector<kernel::Pose> poses;
  for (const Json_field& pose : frames_[k].exactly(bodies_.size(), "a pose a body"))
    poses.push_back(pose_of_numbers(pose));
  return poses;
}

std::vector<kernel::Rigid_pose> Scene_file::rigid_frame(std::size_t k)
{
  const auto expected = "expected a quaternion that is not 0";
  std::vector<kernel::Rigid_pose> poses;
  if (frames_.empty()) {
    for (const auto& numbers : numbers_of_file<7>(k)) {
      poses.push_back(rigid_pose([&](std::size_t i) { return kernel::Rational(numbers[i]); }));
      if (is_zero(poses.back())) fail(k, poses.size() - 1, "the quaternion is 0", expected);
    }
    return poses;
  }
  for (const Json_field& pose : frames_[k].exactly(bodies_.size(), "a pose a body")) {
    const auto items = pose.exactly(7, "a quaternion w x y z and a translation");
    poses.push_back(rigid_pose([&](std::size_t i) { return items[i].rational(); }));
    if (is_zero(poses.back())) pose.fail("has the quaternion 0", expected);
  }
  return poses;
}

void Scene_file::fail(std::size_t frame, std::size_t body, const std::string& wrong, const char* expected) const
{
  throw Input_error(frames_path_.native(), 0,
                    "frame " + std::to_string(frame) + ", body " + std::to_string(body) + ": " + wrong, expected);
}

template <std::size_t N>
std::vector<std::array<double, N>> Scene_file::numbers_of_file(std::size_t k)
{
  static_assert(std::endian::native == std::endian::little, "the file's numbers are");
  constexpr std::size_t bytes_of_pose = N * sizeof(double);
  std::vector<std::array<double, N>> numbers(bodies_.size());
  frames_file_.seekg(std::streamoff(k * numbers.size() * bytes_of_pose));
  frames_file_.read(reinterpret_cast<char*>(numbers.data()), std::streamsize(numbers.size() * bytes_of_pose));
  if (!frames_file_)
    throw Input_error(frames_path_.native(), 0, "ends within frame " + std::to_string(k),
                      "expected it as it was opened");
  for (std::size_t body = 0; body < numbers.size(); ++body)
    for (const double x : numbers[body])
      if (!std::isfinite(x)) fail(k, body, kernel::shortest(x), "expected finite numbers");
  return numbers;
}

std::vector<kernel::Pose> Scene_file::frame_of_file(std::size_t k)
{
  std::vector<kernel::Pose> poses;
  for (const auto& numbers : numbers_of_file<12>(k)) {
    poses.emplace_back(numbers);
    if (poses.back().determinant_sign() == CGAL::ZERO)
      fail(k, poses.size() - 1, "the 3x3 part has determinant 0", "expected a matrix that flattens nothing");
  }
  return poses;
}

std::vector<fs::path> Scene_file::files() const
{
  std::vector<fs::path> files = {path_};
  if (!frames_path_.empty()) files.push_back(frames_path_);
  for (const Model& model : models_) files.push_back(model.file);
  return files;
}

}  // namespace tetracone::verify
