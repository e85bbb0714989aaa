#include "experiments/support/scene_options.h"

#include "experiments/support/output_file.h"
#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/read_poses.h"

#include <CLI/CLI.hpp>

#include <utility>

namespace tetracone::experiments {

using kernel::Pose;

void Scene_names::add_options_to(CLI::App& command)
{
  command.add_option("--pose-a", poses_a,
                     "Poses of A: a line each, 12 numbers, row-major 3x4, or 16 or four lines of four, 4x4; decimals "
                     "or fractions n/d, blanks or commas between them; '-': standard input");
  command.add_option("--pose-b", poses_b, "Poses of B; one pose in either file serves all of the other");
  models.add_to(command);
}

void Scene_names::refuse_all_but_case() const
{
  for (const auto& [given, name] : {std::pair(!b.empty(), "B"),
                                    {!poses_a.empty(), "--pose-a"},
                                    {!poses_b.empty(), "--pose-b"},
                                    {models.strict, "--strict"},
                                    {models.merge, "--merge"},
                                    {models.orient, "--orient"}})
    if (given) throw CLI::ValidationError(name, "expected without a case file: " + a + " holds both bodies and poses");
}

void Scene_names::refuse_as_output(const std::filesystem::path& output) const
{
  std::vector<std::filesystem::path> inputs = {a, b, poses_a, poses_b};
  // The vertices of TetGen's A.poly may be in A.node.
  for (std::filesystem::path model : {a, b})
    if (model.extension() == ".poly") inputs.push_back(model.replace_extension(".node"));
  refuse_input(output, inputs);
}

Pose_pairs read_pose_pairs(const Scene_names& names)
{
  const auto read = [](const std::string& file) {
    return file.empty() ? std::vector<Pose>{Pose()} : covering::read_poses(file);
  };
  Pose_pairs poses{read(names.poses_a), read(names.poses_b)};
  if (poses.a.size() != poses.b.size() && poses.a.size() != 1 && poses.b.size() != 1)
    throw covering::Input_error(
        names.poses_b, 0, std::to_string(poses.b.size()) + " poses",
        "expected " + std::to_string(poses.a.size()) + " as in " + names.poses_a + ", or one pose in either file");
  return poses;
}

}  // namespace tetracone::experiments
