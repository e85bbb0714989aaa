#ifndef TETRACONE_TETRATREE_FAST_BVH8_LANE_H
#define TETRACONE_TETRATREE_FAST_BVH8_LANE_H

#include "tetracone/kernel/bound/oriented_box.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/tetratree/fast/bvh8_elements.h"
#include "tetracone/tetratree/fast/bvh8_node.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>

namespace tetracone::tetratree {

/// Number of rounds by which a box's axes are fitted to the points.
inline constexpr int fitting_rounds = 6;

/// A part of a body that becomes a lane of a node: elements first .. last, and a box that holds their corners.
struct Bvh8_lane {
  Index first, last;
  bool is_leaf, is_triangle;  // is_triangle: a leaf with these corners
  kernel::Lane_box box;
  std::array<kernel::Vector, 3> corners;

  /// Makes a lane from `points`, the corners of all its elements.
  Bvh8_lane(Index begin, Index end, bool leaf, std::span<const kernel::Vector> points)
      : Bvh8_lane(begin, end, leaf, axes_for(leaf, points), points[0])
  {
    for (const kernel::Vector& p : points) box.add(p);
    is_triangle = leaf && points.size() == 3;
    if (is_triangle) corners = {points[0], points[1], points[2]};
  }

  /// Makes a lane with an empty box of these axes; the points to be added lie near `about`.
  Bvh8_lane(Index begin, Index end, bool leaf, const kernel::Matrix& axes, const kernel::Vector& about)
      : first(begin), last(end), is_leaf(leaf), is_triangle(false), box(axes, about)
  {}

 private:
  static kernel::Matrix axes_for(bool leaf, std::span<const kernel::Vector> points)
  {
    return leaf && points.size() == 3 ? kernel::triangle_axes(points.first<3>())
                                      : kernel::fitted_axes(points, fitting_rounds);
  }
};

/// Returns a node of one to eight lanes, without children.
inline Bvh8_node node_of(std::span<const Bvh8_lane> lanes)
{
  using kernel::Vector;
  Bvh8_node node{};
  node.boxes.lane_count = int(lanes.size());
  Vector low = Vector::all(4), high = -low;
  for (const Bvh8_lane& lane : lanes) {
    const Vector centre = lane.box.centre();
    low = smaller(low, centre);
    high = larger(high, centre);
  }
  // The origin is exact in float, and so in double.
  Vector origin;
  for (int k = 0; k < 3; ++k) origin[k] = node.boxes.origin[k] = kernel::to_float(0.5 * (low[k] + high[k]));
  double reach = 0;
  for (std::size_t k = 0; k < lanes.size(); ++k) {
    const Bvh8_lane& lane = lanes[k];
    lane.box.store(node.boxes, int(k), origin, Bvh8_elements::local_error);
    node.first[k] = lane.first;
    node.boxes.marked |= std::uint32_t(lane.is_leaf) << k;
    node.child[k] = !lane.is_leaf      ? Bvh8_node::not_made(lane.last)
                    : lane.is_triangle ? Bvh8_node::leaf(kernel::apex_code(node.boxes, int(k), origin, lane.corners))
                                       : Bvh8_node::leaf(0);
    double sum = 0, square = 0;
    for (int i = 0; i < 3; ++i) {
      sum += node.boxes.extent[i][k];
      square += double(node.boxes.centre[i][k]) * node.boxes.centre[i][k];
    }
    reach = kernel::maximum(reach, sum + std::sqrt(square));
  }
  node.boxes.reach = float(reach * 1.0000002);
  return node;
}

}  // namespace tetracone::tetratree

#endif
