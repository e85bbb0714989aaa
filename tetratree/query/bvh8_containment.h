#ifndef TETRACONE_TETRATREE_QUERY_BVH8_CONTAINMENT_H
#define TETRACONE_TETRATREE_QUERY_BVH8_CONTAINMENT_H

#include "tetracone/covering/inclusion.h"
#include "tetracone/kernel/bound/obb8_overlap.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/tetratree/query/placed_bvh8.h"
#include "tetracone/tetratree/query_statistics.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

namespace tetracone::tetratree {

/// Decides whether a solid holds a shell of another body, through its `Bvh8`. Both bodies must be placed, with their
/// frames related. Work is added to `counts`.
///
/// The winding number about a vertex is the signed sum over the covering (JS08 Theorem 1). A tetrahedron can count only
/// if its face is met by the ray from the vertex away from the covering's origin. The tree finds these, and the signs
/// of K decide them.
template <class K = kernel::Adaptive>
class Bvh8_containment {
 public:
  /// True when the holder holds a shell of the other body. Requires surfaces that share no point: then each shell is
  /// inside or outside as a whole, and one vertex decides.
  bool operator()(Placed_bvh8<K>& holder, Placed_bvh8<K>& held, Query_statistics& counts)
  {
    const auto& vertices = held.tree->model().covering().shell_vertices();
    return std::ranges::any_of(vertices, [&](Index v) { return holds(holder, held, v, counts); });
  }

  /// True when the holder holds a vertex of the other body. Requires one that is not on the holder's surface.
  bool holds(Placed_bvh8<K>& holder, Placed_bvh8<K>& held, Index v, Query_statistics& counts)
  {
    const Row at = image(held, v);
    const double error = held.into_other.frame().error(Bvh8_elements::local_error);
    if (is_outside(holder.tree->node(0).boxes, at, error)) return false;
    ++counts.inclusion_tests;
    return winding_number(holder, held, v, beyond(at, error), counts) != 0;
  }

  /// Upper bound of the relative error of a ray's box, over its end: centre, direction and extent are rounded to float.
  /// Proved in verify/proofs/separation_proofs.h.
  static constexpr double ray_rounding = 3 * 0x1p-24;

  /// Upper bound of the distance of the holder's points from its origin, in its local units: |p_k| <= 1. Proved in
  /// verify/proofs/margin_proofs.h.
  static constexpr double beyond_holder = 2;

 private:
  using Point = kernel::Point<K>;
  using Placed = Placed_bvh8<K>;
  using Row = kernel::Relative_frame::Row;
  using Face = covering::Placed_face<K>;

  /// Returns the vertex in the holder's local units.
  static Row image(const Placed& held, Index v) { return held.into_other.frame()(held.tree->local(v).at); }

  /// True when p is surely outside the root's box, and false if anything is undefined. A point of the box is c + sum_i
  /// s_i a_i with |s_i| <= e_i. With axes of defect d, |a_i . (p - c)| <= e_i + 3 d (1 + 4 d) |p - c|_1; the fourth d
  /// covers the roundings. The error of a coordinate of p is at most `error`, and |a_i|_1 < 2.
  static bool is_outside(const kernel::Obb8& root, const Row& at, double error)
  {
    const Row from_centre = kernel::difference(at, kernel::centre_of(root, 0));
    const double size = std::abs(from_centre[0]) + std::abs(from_centre[1]) + std::abs(from_centre[2]);
    for (int i = 0; i < 3; ++i) {
      const double along = from_centre[0] * root.axis[i][0][0] + from_centre[1] * root.axis[i][1][0] +
                           from_centre[2] * root.axis[i][2][0];
      if (std::abs(along) >
          root.extent[i][0] + kernel::axis_defect_factor * kernel::axis_defect * size + kernel::axis_norm_1 * error)
        return true;
    }
    return false;
  }

  /// Returns the holder's winding number about vertex v. `ray` is a box about the ray from v away from the origin.
  int winding_number(Placed& holder, Placed& held, Index v, const kernel::Single_box& ray, Query_statistics& counts)
  {
    const Point& p = held.placed.point(v);
    const Point origin = holder.placed.frame()(holder.placed.model().origin());
    int winding = 0;
    nodes_.assign(1, 0);
    while (!nodes_.empty()) {
      const Index n = nodes_.back();
      nodes_.pop_back();
      const Bvh8_node& node = holder.tree->node(n);
      kernel::Single_box here = ray;
      double sum = node.boxes.reach;
      for (int i = 0; i < 3; ++i) {
        here.centre[i] = float(double(ray.centre[i]) - double(node.boxes.origin[i]));
        sum += std::abs(here.centre[i]) + here.extent[i];
      }
      here.slack = kernel::obb8_slack(sum, 0) + ray.slack;
      unsigned met = kernel::overlapping(node.boxes, here, true) & ((1u << node.boxes.lane_count) - 1);
      counts.box_tests += unsigned(node.boxes.lane_count);
      for (; met != 0; met &= met - 1) {
        const int lane = std::countr_zero(met);
        const Box_id box(n, lane);
        if (!holder.tree->is_leaf(box)) {
          nodes_.push_back(holder.tree->child(box));
          continue;
        }
        for (Index k = 0; k < holder.leaf_count(box); ++k)
          winding += winding_of(holder, holder.element(box, k), p, origin);
      }
    }
    return winding;
  }

  static int winding_of(Placed& holder, const Element& element, const Point& p, const Point& origin)
  {
    if (!element.is_whole_face()) {
      const auto t = holder.corners(element);
      return covering::signed_inclusion<K>(p, origin, *t[0], *t[1], *t[2]);
    }
    const Face face(holder.placed, element.face);
    int winding = 0;
    for (std::size_t k = 0; k < face.edge_count(); ++k)
      winding += covering::signed_inclusion<K>(p, origin, face.origin(), face.from(k), face.to(k));
    return winding;
  }

  /// Returns a thin box about the part beyond p of the ray from the holder's origin through p. If p is too near to the
  /// origin to give the direction, returns a box about everything. `error` is an upper bound of the error of p's
  /// coordinates.
  ///
  /// The holder lies within `beyond_holder` of its origin. So the exact ray can meet it only at s p*, with 1 <= s <=
  /// end / |p| and p* the exact point. A coordinate of s p* differs by at most s `error` from s p on the box's axis.
  /// Rounding the axis to float adds `end` times u for the centre, and half of that each for direction and extent.
  /// `slack` covers both.
  static kernel::Single_box beyond(const Row& p, double error)
  {
    const double length = std::sqrt(kernel::dot(p, p));
    kernel::Single_box box{};
    if (!(length > 0x1p20 * error) || !(length < 0x1p20)) {
      for (int i = 0; i < 3; ++i) {
        box.edge[i][i] = 1;
        box.extent[i] = 2 * beyond_holder;
      }
      return box;
    }
    const double end = kernel::maximum(beyond_holder, 1.5 * length);
    const kernel::Matrix axes = kernel::detail::axes_from(kernel::Vector(p[0], p[1], p[2]), kernel::Vector(1, 0, 0));
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) box.edge[i][k] = float(axes(k, i));
      box.centre[i] = float(0.5 * (1 + end / length) * p[i]);
    }
    box.extent[0] = float(0.5 * (end - length));
    box.slack = kernel::obb8_slack(0, error * end / length) + float(ray_rounding) * float(end);
    return box;
  }

  std::vector<Index> nodes_;  // scratch memory
};

}  // namespace tetracone::tetratree

#endif
