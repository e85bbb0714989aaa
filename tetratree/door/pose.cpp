#include "tetracone/kernel/number/pose.h"

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <CGAL/enum.h>

#include <cmath>
#include <cstddef>
#include <new>
#include <string>

namespace tetracone {
namespace {

std::string entry(std::size_t k) { return "pose: entry " + std::to_string(k + 1) + " of 12"; }

const kernel::Pose& not_flat(const kernel::Pose& pose)
{
  if (pose.determinant_sign() == CGAL::ZERO)
    throw Error("pose: the 3x3 part has determinant 0; expected a matrix that flattens nothing");
  return pose;
}

kernel::Pose checked(const std::array<double, 12>& rows)
{
  kernel::require_sound_floating_point();
  for (std::size_t k = 0; k < 12; ++k)
    if (!std::isfinite(rows[k]))
      throw Error(entry(k) + " is " + kernel::shortest(rows[k]) + "; expected a finite number");
  return not_flat(kernel::Pose(rows));
}

kernel::Pose checked(const std::array<std::string, 12>& rows)
{
  std::array<kernel::Rational, 12> exact;
  for (std::size_t k = 0; k < 12; ++k) exact[k] = kernel::required_number(rows[k], entry(k) + " is ");
  return not_flat(kernel::Pose(exact));
}

}  // namespace

static_assert(sizeof(kernel::Pose) == sizeof(Pose) && alignof(kernel::Pose) == alignof(Pose));

Pose::Pose() { new (storage_) kernel::Pose(); }
Pose::Pose(const std::array<double, 12>& rows) { new (storage_) kernel::Pose(checked(rows)); }
Pose::Pose(const Pose& other) { new (storage_) kernel::Pose(other.exact()); }
Pose& Pose::operator=(const Pose& other)
{
  *std::launder(reinterpret_cast<kernel::Pose*>(storage_)) = other.exact();
  return *this;
}
Pose::~Pose() { std::launder(reinterpret_cast<kernel::Pose*>(storage_))->~Pose(); }

Pose Pose::from_text(const std::array<std::string, 12>& rows)
{
  Pose pose;
  *std::launder(reinterpret_cast<kernel::Pose*>(pose.storage_)) = checked(rows);
  return pose;
}

Pose Pose::translation(double x, double y, double z)
{
  return Pose(std::array<double, 12>{1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z});
}

const std::array<double, 12>& Pose::rows() const { return exact().entries(); }

}  // namespace tetracone
