#include "experiments/support/motion_options.h"

#include "experiments/support/output_file.h"
#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/read_poses.h"
#include "tetracone/covering/io/read_rigid_poses.h"
#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/kernel/motion/rotation_quaternion.h"
#include "tetracone/kernel/number/number.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <utility>

namespace tetracone::experiments {
namespace {

using covering::Input_error;
using covering::Rigid_pose_line;
using kernel::Body_motion;

/// The poses of A, which rests, and those at both ends of the segments of B's path.
template <class Pose, class Read>
std::array<std::vector<Pose>, 4> read_path(const Motion_names& names, const Read& read)
{
  for (const auto& [k, name] : {std::pair(1, "--pose-a1"), {2, "--pose-b0"}, {3, "--pose-b1"}})
    if (!names.poses[std::size_t(k)].empty())
      throw CLI::ValidationError(name, "expected without --path: B takes the path, A rests at --pose-a0");
  std::vector<Pose> of_a = {Pose()}, path = read(names.path);
  if (!names.poses[0].empty()) of_a = read(names.poses[0]);
  if (of_a.size() != 1)
    throw Input_error(names.poses[0], 0, std::to_string(of_a.size()) + " poses", "expected one: A rests");
  if (path.size() < 2) throw Input_error(names.path, 0, "holds one pose", "expected two or more: a path");
  return {of_a, of_a, std::vector<Pose>(path.begin(), path.end() - 1), std::vector<Pose>(path.begin() + 1, path.end())};
}

/// Reads the poses of all files; the identity for a missing one.
template <class Pose, class Read>
std::array<std::vector<Pose>, 4> read_all(const Motion_names& names, const Read& read)
{
  if (!names.path.empty()) return read_path<Pose>(names, read);
  const std::array<std::string, 4>& files = names.poses;
  std::array<std::vector<Pose>, 4> poses;
  std::size_t longest = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    if (files[k].empty())
      poses[k] = {Pose()};
    else
      poses[k] = read(files[k]);
    if (poses[k].size() > poses[longest].size()) longest = k;
  }
  for (std::size_t k = 0; k < 4; ++k)
    if (poses[k].size() != 1 && poses[k].size() != poses[longest].size())
      throw Input_error(
          files[k], 0, std::to_string(poses[k].size()) + " poses",
          "expected " + std::to_string(poses[longest].size()) + " as in " + files[longest] + ", or one pose");
  return poses;
}

template <class Pose, class Make>
Motion_pairs pairs_of(const std::array<std::vector<Pose>, 4>& poses, const Make& make)
{
  std::size_t count = 1;
  for (const auto& of_file : poses) count = std::max(count, of_file.size());
  const auto at = [&](std::size_t file, std::size_t k) -> const Pose& {
    return poses[file][poses[file].size() == 1 ? 0 : k];
  };
  Motion_pairs pairs;
  for (std::size_t k = 0; k < count; ++k) {
    pairs.a.push_back(Motion(make(at(0, k), at(1, k), 1)));
    pairs.b.push_back(Motion(make(at(2, k), at(3, k), 3)));
  }
  return pairs;
}

/// Reads rigid poses. A line on stderr reports matrices that are only nearly rotations.
std::vector<Rigid_pose_line> read_rigid(const std::string& file)
{
  std::vector<Rigid_pose_line> poses = covering::read_rigid_poses(file);
  std::size_t near = 0;
  double error = 0;
  for (const Rigid_pose_line& pose : poses) {
    near += pose.matrix_error.value_or(0) > 0;
    error = std::max(error, pose.matrix_error.value_or(0));
  }
  if (near > 0)
    std::cerr << file << ": " << near << (near == 1 ? " matrix is" : " matrices are")
              << " no rotation exactly; the motion is that of quaternions whose rotations differ by at most "
              << kernel::shortest(error) << " in an entry\n";
  return poses;
}

}  // namespace

void Motion_names::add_options_to(CLI::App& command)
{
  command.add_option("--pose-a0", poses[0],
                     "Poses of A at t = 0, as the poses of collide; with --motion rigid also 7 numbers, a quaternion w "
                     "x y z and a translation; '-': standard input; default: the identity");
  command.add_option("--pose-a1", poses[1], "Poses of A at t = 1; one pose in a file serves all of the others");
  command.add_option("--pose-b0", poses[2], "Poses of B at t = 0");
  command.add_option("--pose-b1", poses[3], "Poses of B at t = 1");
  command
      .add_option("--motion", kind,
                  "linear: every point on a line, M(t) = (1-t) M0 + t M1; rigid: a rotation at every t, by the "
                  "quaternion (1-t) q0 + t q1, not normalised. A matrix that is a rotation, exactly or to 1e-5 in each "
                  "entry, stands for its quaternion of length 1, which takes the short way")
      ->capture_default_str();
}

void Motion_names::refuse_as_output(const std::filesystem::path& output) const
{
  Scene_names names{a, b, poses[0], poses[1], models};
  names.refuse_as_output(output);
  names.poses_a = poses[2];
  names.poses_b = poses[3];
  names.refuse_as_output(output);
  names.poses_b = path;
  names.refuse_as_output(output);
}

Motion_pairs read_motion_pairs(const Motion_names& names)
{
  if (names.kind == "linear")
    return pairs_of(
        read_all<kernel::Pose>(names, [](const std::string& f) { return covering::read_poses(f); }),
        [](const kernel::Pose& from, const kernel::Pose& to, std::size_t) { return Body_motion::linear(from, to); });
  if (names.kind != "rigid") throw CLI::ValidationError("--motion " + names.kind, "expected linear or rigid");
  return pairs_of(read_all<Rigid_pose_line>(names, read_rigid),
                  [&](const Rigid_pose_line& from, Rigid_pose_line to, std::size_t file) {
                    if (from.matrix_error || to.matrix_error) kernel::take_short_way(from.pose, to.pose);
                    auto motion = Body_motion::rigid(from.pose, to.pose);
                    if (motion) return std::move(*motion);
                    const bool in_first = names.path.empty() && names.poses[file].empty();
                    throw Input_error(!names.path.empty() ? names.path : names.poses[in_first ? file - 1 : file],
                                      in_first ? from.line : to.line,
                                      "the quaternion is against that at the other end: one between them is 0",
                                      "expected q0 and q1 of which no (1-t) q0 + t q1 is 0");
                  });
}

}  // namespace tetracone::experiments
