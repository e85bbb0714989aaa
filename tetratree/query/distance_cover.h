#ifndef TETRACONE_TETRATREE_QUERY_DISTANCE_COVER_H
#define TETRACONE_TETRATREE_QUERY_DISTANCE_COVER_H

#include "tetracone/kernel/predicate/face_distance.h"
#include "tetracone/tetratree/fast/bvh8.h"
#include "tetracone/tetratree/query/exact_vertices.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// Elements of A, elements of B, and a direction m along which B's are beyond A's by at least the distance d: min m . b
/// - max m . a >= d |m| over their corners.
struct Separated_parts {
  std::array<std::vector<Element>, 2> elements;
  kernel::Exact_vector direction;
};

/// A proof that two placed bodies are at least a distance apart: every pair of their elements is in one of its parts.
/// Requires elements that are triangles, or faces on a line.
class Distance_cover {
 public:
  /// Builds the proof. `direction` leads from A to B between nearest points. `top` / `bottom` is the exact square of
  /// the distance in the coordinates of `Exact_vertices`, not 0. The trees and poses must outlive this object.
  Distance_cover(const Bvh8& a, const kernel::Pose& pose_a, const Bvh8& b, const kernel::Pose& pose_b,
                 kernel::Exact_vector direction, kernel::Exact_number top, kernel::Exact_number bottom)
      : tree_{&a, &b},
        exact_{Exact_vertices(a.model().vertices()), Exact_vertices(b.model().vertices())},
        direction_(std::move(direction)),
        top_(std::move(top)),
        bottom_(std::move(bottom))
  {
    exact_[0].place(pose_a, pose_b);
    exact_[1].place(pose_b, pose_a);
    cover({}, {});
  }

  const std::vector<Separated_parts>& parts() const { return parts_; }

 private:
  /// Appends the elements below a box.
  void collect(int body, Box_id box, std::vector<Element>& elements) const
  {
    if (tree_[body]->is_leaf(box)) {
      for (Index i = 0; i < tree_[body]->leaf_count(box); ++i) elements.push_back(tree_[body]->element(box, i));
      return;
    }
    const Index child = tree_[body]->child(box);
    for (int part = 0; part < tree_[body]->node(child).boxes.lane_count; ++part) collect(body, {child, part}, elements);
  }

  /// True when A's and B's elements are at least the distance apart along m, exactly.
  bool separates(const std::array<std::vector<Element>, 2>& elements, const kernel::Exact_vector& m)
  {
    bool any[2] = {false, false};
    kernel::Exact_number end[2];
    for (int body = 0; body < 2; ++body)
      for (const Element& element : elements[body])
        tree_[body]->for_vertices(element, [&](Index v) {
          const kernel::Exact_number at = kernel::dot(m, exact_[body](v));
          if (!any[body] || (body == 0 ? at > end[body] : at < end[body])) end[body] = at;
          any[body] = true;
        });
    const kernel::Exact_number gap = end[1] - end[0];
    return gap.sign() == CGAL::POSITIVE && gap * gap * bottom_ >= top_ * kernel::dot(m, m);
  }

  /// Returns the mean of the corners' images, in double.
  std::array<double, 3> middle(int body, const std::vector<Element>& elements)
  {
    std::array<double, 3> sum{};
    double count = 0;
    for (const Element& element : elements)
      tree_[body]->for_vertices(element, [&](Index v) {
        for (int k = 0; k < 3; ++k) sum[k] += exact_[body](v)[k].to_double();
        ++count;
      });
    for (double& x : sum) x /= count;
    return sum;
  }

  kernel::Exact_face face(int body, const Element& element)
  {
    kernel::Exact_face face;
    std::vector<kernel::Exact_vector> corners;
    tree_[body]->for_vertices(element, [&](Index v) { corners.push_back(exact_[body](v)); });
    for (std::size_t k = 0; k < corners.size(); ++k)
      face.edges.push_back({corners[k], corners[k + 1 == corners.size() ? 0 : k + 1]});
    if (!element.is_whole_face()) face.plane = {corners[0], corners[1], corners[2]};
    return face;
  }

  /// Covers all pairs of elements below two boxes. It tries the direction of the nearest points, then that between the
  /// middles, then opens the larger box.
  void cover(Box_id a, Box_id b)
  {
    std::array<std::vector<Element>, 2> elements;
    collect(0, a, elements[0]);
    collect(1, b, elements[1]);
    const auto keep = [&](const kernel::Exact_vector& m) {
      if (!separates(elements, m)) return false;
      parts_.push_back({std::move(elements), m});
      return true;
    };
    if (keep(direction_)) return;
    // Float is precise enough for a direction to try.
    const auto from = middle(0, elements[0]), to = middle(1, elements[1]);
    kernel::Exact_vector between;
    bool is_finite = true;
    for (int k = 0; k < 3; ++k) {
      const float x = float(to[k] - from[k]);
      is_finite = is_finite && std::isfinite(x);
      between[k] = kernel::Exact_number(is_finite ? double(x) : 0);
    }
    if (is_finite && keep(between)) return;
    const bool leaf_a = tree_[0]->is_leaf(a), leaf_b = tree_[1]->is_leaf(b);
    if (leaf_a && leaf_b) {
      for (const Element& x : elements[0])
        for (const Element& y : elements[1])
          parts_.push_back({{{{x}, {y}}}, kernel::distance_of_faces(face(0, x), face(1, y)).direction});
      return;
    }
    const int opened = leaf_a || (!leaf_b && elements[0].size() < elements[1].size()) ? 1 : 0;
    const Index child = tree_[opened]->child(opened == 0 ? a : b);
    for (int part = 0; part < tree_[opened]->node(child).boxes.lane_count; ++part) {
      if (opened == 0)
        cover({child, part}, b);
      else
        cover(a, {child, part});
    }
  }

  std::array<const Bvh8*, 2> tree_;
  std::array<Exact_vertices, 2> exact_;
  kernel::Exact_vector direction_;
  kernel::Exact_number top_, bottom_;
  std::vector<Separated_parts> parts_;
};

}  // namespace tetracone::tetratree

#endif
