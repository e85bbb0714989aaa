#ifndef TETRACONE_KERNEL_MOTION_CONTROL_POSES_H
#define TETRACONE_KERNEL_MOTION_CONTROL_POSES_H

#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace tetracone::kernel {

/// Adds the poses of one span of time, or of parts of it. Returns false where more nested halvings would be needed, and
/// where an entry is beyond all doubles. Requires forms of one degree.
inline bool add_control_poses(const Body_motion::Forms& forms, int halvings, std::vector<Pose>& poses)
{
  const auto is_near = [&](std::size_t i) {
    const Integer largest = 2 * forms.weight[i];
    if (sgn(largest) <= 0) return false;
    for (int k = 0; k < 12; ++k)
      if (k % 4 != 3 && cmp(abs(forms.entry[k][i]), largest) > 0) return false;
    return true;
  };
  std::size_t near = 0;
  while (near < forms.weight.size() && is_near(near)) ++near;
  if (near < forms.weight.size()) {
    if (halvings == 0) return false;
    Body_motion::Forms first, second;
    for (int k = 0; k < 12; ++k) {
      first.entry[k] = forms.entry[k].first_half();
      second.entry[k] = forms.entry[k].second_half();
    }
    first.weight = forms.weight.first_half();
    second.weight = forms.weight.second_half();
    return add_control_poses(first, halvings - 1, poses) && add_control_poses(second, halvings - 1, poses);
  }
  for (std::size_t i = 0; i < forms.weight.size(); ++i) {
    std::array<Rational, 12> entries;
    for (int k = 0; k < 12; ++k) {
      entries[k] = Rational(forms.entry[k][i], forms.weight[i]);
      entries[k].canonicalize();
      if (!std::isfinite(nearest_double(entries[k]))) return false;
    }
    poses.emplace_back(entries);
  }
  return true;
}

/// Returns poses whose images hold a moving body. At every time in [0, 1], each point of it is in the hull of the
/// point's images under these. The body need not take these poses, and det M may be 0.
///
/// For a linear motion they are both ends. For a rigid one they are the coefficients of M and v over w's, in
/// Bernstein's basis. Where the coefficients of w are positive, the place at any time is a weighted mean of such
/// images. The time is halved until they are positive, and until no M has an entry above 2. (A rotation has none above
/// 1.) Returns nothing where 24 nested halvings do not suffice, and where an entry is beyond all doubles.
inline std::optional<std::vector<Pose>> control_poses(const Body_motion& motion)
{
  if (const auto& ends = motion.ends()) return std::vector<Pose>(ends->begin(), ends->end());
  Body_motion::Forms forms = motion.forms();
  std::size_t size = forms.weight.size();
  for (const Integer_form& entry : forms.entry) size = maximum(size, entry.size());
  for (Integer_form& entry : forms.entry) entry = entry.raised_to(size);
  forms.weight = forms.weight.raised_to(size);
  std::vector<Pose> poses;
  if (!add_control_poses(forms, 24, poses)) return std::nullopt;
  return poses;
}

}  // namespace tetracone::kernel

#endif
