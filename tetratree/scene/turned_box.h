#ifndef TETRACONE_TETRATREE_SCENE_TURNED_BOX_H
#define TETRACONE_TETRATREE_SCENE_TURNED_BOX_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/bound/obb8_gap.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/vertex.h"
#include "tetracone/tetratree/scene/body_extent.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace tetracone::tetratree {

/// Upper bounds of relative errors of a turned box (verify/proofs/scene_proofs.h).
///
/// - `turned_radius_rounding`: of the distance of the farthest point from the centre, a sum of extents.
/// - `turned_extent_rounding`: of an extent that is rounded to float.
/// - `turned_reach_rounding`: of a box's reach in float, which is a centre's distance plus the extents in float.
inline constexpr double turned_radius_rounding = 0x1p-20, turned_extent_rounding = 0x1p-22,
                        turned_reach_rounding = 0x1p-20;

/// A model's box, turned with a body; it bounds a long thin body better than a box along the world's axes.
///
/// The placed body lies in {c + sum_j s_j a_j, |s_j| <= e_j}. The axes have length 1 and are pairwise at right angles
/// up to 2^-23. Nothing is known under a pose whose columns are not at right angles, and near the ends of doubles.
struct Turned_box {
  kernel::Vertex centre{};
  std::array<kernel::Vertex, 3> axis{};
  kernel::Vertex extent{};
  bool is_known = false;

  /// Returns an upper bound of the distance of any point of the box from its centre.
  double radius() const { return (extent[0] + extent[1] + extent[2]) * (1 + turned_radius_rounding); }
};

/// Upper bounds of errors of axes and centres (verify/proofs/scene_proofs.h).
///
/// - `turned_rounding`: error of an extent as a fraction of the sum of extents. Axes are not quite at right angles and
///   are rounded to float.
/// - `turned_centre_rounding`: relative error of a centre in float.
/// - `most_skewed`: upper bound of the cosine between two columns of a pose.
inline constexpr double turned_rounding = 0x1p-20, turned_centre_rounding = 0x1p-22, most_skewed = 0x1p-24;

/// Returns the turned box of a body under a pose; unknown unless the columns of the pose are pairwise at right angles.
///
/// The image of c + sum_j s_j half_j e_j is M c + t + sum_j s_j half_j m_j, where m_j are the columns of M. The extents
/// are therefore half_j |m_j|. The centre has an error of `placed_rounding` times its terms in each coordinate, and of
/// less than twice that along an axis. This error includes the rounding of a fraction's entries. Columns are longer
/// than 2^-101, so an absolute error of 2^-1075 in their entries is far below `turned_rounding` times them.
inline Turned_box turned_box(const Body_extent& extent, const kernel::Pose& pose)
{
  Turned_box box;
  double most = 0, sum = 0;
  for (int i = 0; i < 3; ++i) {
    const Placed_coordinate<double> x = placed_coordinate(extent, pose, i);
    box.centre[i] = x.at;
    most = kernel::maximum(most, x.terms);
  }
  for (int j = 0; j < 3; ++j) {
    const kernel::Vertex column = {pose[j], pose[4 + j], pose[8 + j]};
    const double square = kernel::dot(column, column), length = std::sqrt(square);
    if (!(square >= 0x1p-200 && square <= 0x1p200)) return {};
    for (int i = 0; i < 3; ++i) box.axis[j][i] = column[i] / length;
    box.extent[j] = extent.half[j] * length;
    sum += box.extent[j];
  }
  for (int j = 0; j < 3; ++j) {
    const double skewed = kernel::dot(box.axis[j], box.axis[(j + 1) % 3]);
    if (!(std::abs(skewed) <= most_skewed)) return {};
    box.extent[j] += turned_rounding * sum + 4 * placed_rounding * most + extent.underflow;
  }
  box.is_known = most <= 0x1p200;
  return box;
}

/// Returns, for up to eight boxes, a lower bound of the distance from `one`, in world units; 0 where nothing is known.
///
/// All are compared in float about the centre of `one`, in a unit above four times the sum of `one`'s radius and the
/// others' largest. A box whose bounding box along the world's axes meets that of `one` is within 1. If one of the
/// others reaches beyond 2, nothing is known of any. A centre has a relative error of 2^-24 in each coordinate, and of
/// less than twice that along an axis.
inline std::array<double, kernel::lanes> turned_gaps(const Turned_box& one, std::span<const Turned_box> others)
{
  double radius = 0;
  for (const Turned_box& other : others) radius = kernel::maximum(radius, other.radius());
  std::array<double, kernel::lanes> apart{};
  const double reach = 4 * (one.radius() + radius);
  if (!(reach >= 0x1p-300 && reach <= 0x1p300)) return apart;
  const double unit = std::ldexp(1.0, std::ilogb(reach) + 1), per_unit = 1 / unit;

  const auto set = [&](kernel::Obb8& boxes, int lane, const Turned_box& box) {
    double off = 0, square = 0, sum = 0;
    for (int k = 0; k < 3; ++k) {
      const double c = (box.centre[k] - one.centre[k]) * per_unit;
      boxes.centre[k][lane] = kernel::to_float(c);
      off += std::abs(c);
      square += c * c;
    }
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) boxes.axis[j][k][lane] = kernel::to_float(box.axis[j][k]);
      boxes.extent[j][lane] =
          kernel::to_float((box.extent[j] * per_unit + turned_centre_rounding * off) * (1 + turned_extent_rounding));
      sum += boxes.extent[j][lane];
    }
    boxes.reach = kernel::maximum(boxes.reach, float((std::sqrt(square) + sum) * (1 + turned_reach_rounding)));
  };
  kernel::Obb8 boxes{}, alone{};
  set(alone, 0, one);
  for (std::size_t k = 0; k < others.size(); ++k) set(boxes, int(k), others[k]);
  boxes.lane_count = int(others.size());
  static const kernel::Box_map in_place{kernel::Pose{}, kernel::Local_scale{}, kernel::Pose{}, kernel::Local_scale{}};
  kernel::Certified_gaps gaps;
  kernel::certified_gaps(boxes, in_place, alone, 0, kernel::no_apex, gaps);
  for (std::size_t k = 0; k < others.size(); ++k)
    if (one.is_known && others[k].is_known && boxes.reach <= 2) apart[k] = double(gaps.gap[k]) * unit;
  return apart;
}

}  // namespace tetracone::tetratree

#endif
