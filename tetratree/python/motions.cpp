#include "tetracone/tetratree/python/motions.h"

#include "tetracone/kernel/motion/rotation_quaternion.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/python/arrays.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace tetracone::python {

namespace py = pybind11;

namespace {

/// Rigid poses as quaternions and translations.
class Rigid_poses {
 public:
  Rigid_poses(const py::object& values, const std::string& name) : name_(name)
  {
    if (!values.is_none()) rows_.emplace(values, name, "pose");
  }

  bool is_one() const { return !rows_ || rows_->is_one(); }
  std::size_t count() const { return rows_ ? rows_->count() : 1; }
  std::string name(std::size_t k) const { return rows_ ? rows_->name(k) : name_; }

  std::array<std::string, 7> operator()(std::size_t k) const
  {
    if (!rows_) return {"1", "0", "0", "0", "0", "0", "0"};
    if (rows_->is_exact_text()) return rows_->text(k);
    std::array<std::string, 7> pose;
    std::ranges::transform(rows_->row(k), pose.begin(), kernel::shortest);
    return pose;
  }

 private:
  std::string name_;
  std::optional<Rows<7>> rows_;  // none: the identity
};

/// Returns the motion between the quaternions of two rotations, the short way round. Throws Error for a matrix that is
/// no rotation.
Motion rigid_motion(const Pose& from, const Pose& to)
{
  std::array<kernel::Rigid_pose, 2> ends;
  for (std::size_t k = 0; k < 2; ++k) {
    const kernel::Pose& pose = (k == 0 ? from : to).exact();
    const auto rotation = kernel::rotation_quaternion(pose);
    if (!rotation)
      throw Error("motion: the 3x3 part at t = " + std::to_string(k) +
                  " is no rotation; expected one to 1e-5 in each entry, or quaternions");
    ends[k] = {rotation->quaternion, {pose.exact(3), pose.exact(7), pose.exact(11)}};
  }
  kernel::take_short_way(ends[0], ends[1]);
  return Motion(kernel::Body_motion::rigid(ends[0], ends[1]).value());
}

/// True when the values are matrices, by their shape.
bool are_matrices(const py::object& values, const std::string& name)
{
  if (values.is_none()) return false;
  const Numbers numbers(values, name);
  return numbers.dimensions() >= 2 && numbers.extent(numbers.dimensions() - 1) == 4;
}

}  // namespace

Motions::Motions(const py::object& from, const py::object& to, const std::string& kind, const std::string& body)
{
  const std::string start = "poses_" + body + "0", end = "poses_" + body + "1";
  const auto make = [&](const auto& first, const auto& last, const auto& motion) {
    is_one_ = first.is_one() && last.is_one();
    const std::size_t count =
        common_count("motion", first.count(), " poses" + (body.empty() ? "" : " of " + body) + " at t = 0",
                     last.count(), " at t = 1");
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = first.count() == 1 ? 0 : k, j = last.count() == 1 ? 0 : k;
      try {
        motions_.push_back(motion(first, i, last, j));
      } catch (const Error& error) {
        throw renamed(error, "motion:", first.name(i) + ", " + last.name(j) + ":");
      }
    }
  };
  const auto of_poses = [](const auto& motion) {
    return [&motion](const Poses& first, std::size_t i, const Poses& last, std::size_t j) {
      first.require(i);
      last.require(j);
      return motion(first(i), last(j));
    };
  };
  if (kind == "linear") {
    make(Poses(from, start), Poses(to, end), of_poses(Motion::linear));
  } else if (kind == "rigid" && (are_matrices(from, start) || are_matrices(to, end))) {
    make(Poses(from, start), Poses(to, end), of_poses(rigid_motion));
  } else if (kind == "rigid") {
    make(Rigid_poses(from, start), Rigid_poses(to, end),
         [](const Rigid_poses& first, std::size_t i, const Rigid_poses& last, std::size_t j) {
           return Motion::rigid_from_text(first(i), last(j));
         });
  } else {
    throw Error("query: motion '" + kind.substr(0, 40) + "'; expected linear or rigid");
  }
}

}  // namespace tetracone::python
