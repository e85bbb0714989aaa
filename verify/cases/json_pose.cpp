#include "verify/cases/json_pose.h"

#include "tetracone/kernel/number/number.h"

#include <array>
#include <vector>

namespace tetracone::verify {
namespace {

using kernel::Pose;

Pose pose_of(const std::vector<Json_field>& items)
{
  std::array<double, 12> nearest;
  std::array<kernel::Rational, 12> entries;
  bool all_doubles = true;
  for (int k = 0; k < 12; ++k) {
    all_doubles = all_doubles && items[k].is_number();
    entries[k] = items[k].rational();
    nearest[k] = items[k].is_number() ? items[k].number() : kernel::nearest_double(entries[k]);
  }
  return all_doubles ? Pose(nearest) : Pose(entries);
}

Pose checked(const Pose& pose, const Json_field& field)
{
  if (pose.determinant_sign() == CGAL::ZERO)
    field.fail("has a 3x3 part of determinant 0", "expected a matrix that flattens nothing");
  return pose;
}

}  // namespace

Pose pose_of_rows(const Json_field& field)
{
  std::vector<Json_field> items;
  for (const Json_field& row : field.exactly(3, "the rows of a 3x4 matrix"))
    for (const Json_field& item : row.exactly(4, "a row of a 3x4 matrix")) items.push_back(item);
  return checked(pose_of(items), field);
}

Pose pose_of_numbers(const Json_field& field)
{
  if (const auto plain = field.plain_numbers<12>()) return checked(Pose(*plain), field);
  return checked(pose_of(field.exactly(12, "the rows of a 3x4 matrix")), field);
}

}  // namespace tetracone::verify
