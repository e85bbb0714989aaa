#include "tetracone/tetratree/python/motions.h"

#include "tetracone/kernel/motion/rotation_quaternion.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/python/arrays.h"

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
    if (values.is_none()) return;
    numbers_.emplace(values, name);
    const std::size_t dimensions = numbers_->dimensions();
    if ((dimensions != 1 && dimensions != 2) || numbers_->extent(dimensions - 1) != 7)
      throw Error(name + ": an array of shape " + numbers_->shape() + "; expected (n, 7), or one pose (7,)");
    is_one_ = dimensions == 1;
    if (!is_one_) count_ = numbers_->extent(0);
  }

  bool is_one() const { return is_one_; }
  std::size_t count() const { return count_; }
  std::string name(std::size_t k) const { return is_one_ ? name_ : name_ + "[" + std::to_string(k) + "]"; }

  std::array<std::string, 7> operator()(std::size_t k) const
  {
    if (!numbers_) return {"1", "0", "0", "0", "0", "0", "0"};
    std::array<std::string, 7> pose;
    for (std::size_t i = 0; i < 7; ++i) {
      if (numbers_->is_exact_text())
        pose[i] = is_one_ ? numbers_->text(i) : numbers_->text(k, i);
      else
        pose[i] = kernel::shortest(is_one_ ? numbers_->number(i) : numbers_->number(k, i));
    }
    return pose;
  }

 private:
  std::string name_;
  std::optional<Numbers> numbers_;  // none: the identity
  bool is_one_ = true;
  std::size_t count_ = 1;
};

/// Returns the motion between the quaternions of two rotations, the short way round. Throws Error for a matrix that is
/// no rotation.
Motion rigid_motion(const kernel::Pose& from, const kernel::Pose& to)
{
  std::array<kernel::Rigid_pose, 2> ends;
  for (std::size_t k = 0; k < 2; ++k) {
    const kernel::Pose& pose = k == 0 ? from : to;
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
    for (std::size_t k = 0; k < count; ++k)
      motions_.push_back(motion(first.count() == 1 ? 0 : k, last.count() == 1 ? 0 : k));
  };
  if (kind == "linear") {
    const Poses first(from, start), last(to, end);
    make(first, last, [&](std::size_t i, std::size_t j) {
      first.require(i);
      last.require(j);
      return Motion::linear(first(i), last(j));
    });
  } else if (kind == "rigid" && (are_matrices(from, start) || are_matrices(to, end))) {
    const Poses first(from, start), last(to, end);
    make(first, last, [&](std::size_t i, std::size_t j) {
      first.require(i);
      last.require(j);
      try {
        return rigid_motion(first(i).exact(), last(j).exact());
      } catch (const Error& error) {
        throw renamed(error, "motion:", first.name(i) + ", " + last.name(j) + ":");
      }
    });
  } else if (kind == "rigid") {
    const Rigid_poses first(from, start), last(to, end);
    make(first, last, [&](std::size_t i, std::size_t j) {
      try {
        return Motion::rigid_from_text(first(i), last(j));
      } catch (const Error& error) {
        throw renamed(error, "motion:", first.name(i) + ", " + last.name(j) + ":");
      }
    });
  } else {
    throw Error("query: motion '" + kind.substr(0, 40) + "'; expected linear or rigid");
  }
}

}  // namespace tetracone::python
