#ifndef TETRACONE_TETRATREE_WIDE_COLLISION_H
#define TETRACONE_TETRATREE_WIDE_COLLISION_H

#include "covering/inclusion.h"
#include "kernel/question.h"
#include "kernel/segment_face.h"
#include "tetratree/counts.h"
#include "tetratree/wide_tree.h"

#include <array>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

using kernel::Pose;
using kernel::Question;

/// Collision detection between two wide trees, exact. Build once, ask for many poses.
///
/// A query descends pairs of boxes, the larger one first: its eight parts against the other box, carried into their frame in double, with a
/// slack that covers all rounding and the pose's. What is left are pairs of elements, which the adaptive kernel's exact signs decide.
/// So the answer is that of all elements against all elements. A solid that holds the other is found by the signed sum over the covering
/// (JS08 Theorem 1), of which only tetrahedra can count whose face is met by the ray from the point away from the covering's origin.
///
/// Both trees must outlive the query object.
class Wide_collision {
 public:
  Wide_collision(Wide_tree& a, Wide_tree& b) : a_(a), b_(b) {}

  /// Whether the two placed polyhedra collide. Requires det M != 0 of both poses, and closed polyhedra for `Question::solid`.
  bool operator()(const Pose& pose_a, const Pose& pose_b, Question question = Question::solid)
  {
    const std::uint64_t fallbacks = kernel::Adaptive::exact_fallbacks();
    const bool answer = ask(pose_a, pose_b, question);
    counts_.exact_fallbacks += kernel::Adaptive::exact_fallbacks() - fallbacks;
    return answer;
  }

  const Counts& counts() const { return counts_; }
  void clear_counts() { counts_ = {}; }

 private:
  using Adaptive = kernel::Adaptive;
  using Point = kernel::Point<Adaptive>;
  using Sign = kernel::Sign;
  using Row = kernel::Relative_frame::Row;
  using Face = covering::Placed_face<Adaptive>;

  /// A box: lane k of node n is 8 n + k.
  using Box = Index;
  static Index node_of(Box box) { return box / 8; }
  static int lane_of(Box box) { return int(box % 8); }

  struct Body {
    Wide_tree* tree;
    covering::Placed_model<Adaptive> placed;
    kernel::Relative_frame into_other;  // from this body's local units to the other's
    kernel::Overlapping overlapping = nullptr;  // of this body's lanes with a box of the other
    double scale = 1;                   // of into_other, where it is a similarity

    explicit Body(Wide_tree& t) : tree(&t), placed(t.model()) {}
    bool is_leaf(Box box) const { return tree->is_leaf(node_of(box), lane_of(box)); }
    const Element& element(Box box) const { return tree->element(node_of(box), lane_of(box)); }
    float size(Box box) const
    {
      const auto& extent = tree->node(node_of(box)).boxes.extent;
      return extent[0][lane_of(box)] + extent[1][lane_of(box)] + extent[2][lane_of(box)];
    }
  };

  bool ask(const Pose& pose_a, const Pose& pose_b, Question question)
  {
    ++counts_.queries;
    if (a_.tree->empty() || b_.tree->empty()) return false;
    a_.placed.place(pose_a), b_.placed.place(pose_b);
    prepare(a_, pose_a, b_, pose_b);
    prepare(b_, pose_b, a_, pose_a);
    if (surfaces_meet()) return true;
    return question == Question::solid && (holds_a_shell(a_, b_) || holds_a_shell(b_, a_));
  }

  static void prepare(Body& body, const Pose& pose, Body& other, const Pose& pose_of_other)
  {
    body.into_other = kernel::Relative_frame(pose_of_other, other.tree->units(), pose, body.tree->units());
    const auto& m = body.into_other.linear();
    body.scale = std::sqrt(m[0][0] * m[0][0] + m[1][0] * m[1][0] + m[2][0] * m[2][0]);
    other.overlapping = kernel::overlapping_boxes(body.into_other.is_similarity());
  }

  bool surfaces_meet()
  {
    stack_.assign(1, {Box(0), Box(0)});
    // The roots are single boxes: compare them as such.
    if (!(lanes_met(a_, 0, b_, 0) & 1u)) return false;
    while (!stack_.empty()) {
      const auto [box_a, box_b] = stack_.back();
      stack_.pop_back();
      const bool leaf_a = a_.is_leaf(box_a), leaf_b = b_.is_leaf(box_b);
      if (leaf_a && leaf_b) {
        if (elements_meet(a_.element(box_a), b_.element(box_b))) return true;
      } else if (leaf_b || (!leaf_a && double(a_.size(box_a)) * a_.scale > double(b_.size(box_b)))) {
        const Index n = a_.tree->child(node_of(box_a), lane_of(box_a));
        for (unsigned met = lanes_met(a_, n, b_, box_b); met != 0; met &= met - 1) stack_.push_back({8 * n + Box(std::countr_zero(met)), box_b});
      } else {
        const Index n = b_.tree->child(node_of(box_b), lane_of(box_b));
        for (unsigned met = lanes_met(b_, n, a_, box_a); met != 0; met &= met - 1) stack_.push_back({box_a, 8 * n + Box(std::countr_zero(met))});
      }
    }
    return false;
  }

  /// The lanes of the body's node whose box may meet the other body's box.
  unsigned lanes_met(const Body& body, Index n, const Body& other, Box box)
  {
    const Wide_node& node = body.tree->node(n);
    const Wide_node& from = other.tree->node(node_of(box));
    const int lane = lane_of(box);
    Row centre, edges[3];
    for (int i = 0; i < 3; ++i) centre[i] = double(from.origin[i]) + double(from.boxes.centre[i][lane]);
    kernel::Single_box single;
    double sum = node.reach;
    for (int j = 0; j < 3; ++j) {
      const auto& axis = from.boxes.axis[j];
      edges[j] = other.into_other.direction(std::array{axis[0][lane], axis[1][lane], axis[2][lane]});
      const double length = other.into_other.is_similarity() ? other.scale : std::sqrt(edges[j][0] * edges[j][0] + edges[j][1] * edges[j][1] + edges[j][2] * edges[j][2]);
      for (int i = 0; i < 3; ++i) single.edge[j][i] = float(edges[j][i] /= length);
      single.extent[j] = float(double(from.boxes.extent[j][lane]) * length) * (1 + 0x1p-20f);
      sum += single.extent[j];
    }
    if (!other.into_other.is_similarity()) add_normals(single);
    centre = other.into_other(centre);
    for (int i = 0; i < 3; ++i) {
      const double t = centre[i] - double(node.origin[i]);
      single.centre[i] = float(t);
      sum += std::abs(t);
    }
    single.slack = kernel::wide_slack(sum, other.into_other.error());
    counts_.box_tests += unsigned(node.lane_count);
    ++counts_.pairs_visited;
    return body.overlapping(node.boxes, single) & ((1u << node.lane_count) - 1);
  }

  static void add_normals(kernel::Single_box& box)
  {
    for (int j = 0; j < 3; ++j) {
      const auto &p = box.edge[(j + 1) % 3], &q = box.edge[(j + 2) % 3];
      for (int i = 0; i < 3; ++i) box.normal[j][i] = p[(i + 1) % 3] * q[(i + 2) % 3] - p[(i + 2) % 3] * q[(i + 1) % 3];
    }
  }

  // --- leaves -------------------------------------------------------------------------------------------------------

  bool elements_meet(const Element& a, const Element& b)
  {
    ++counts_.leaf_pairs;
    if (!a.is_whole_face() && !b.is_whole_face()) return triangles_meet(a, b);
    return edges_meet(a_, a, b_, b) || edges_meet(b_, b, a_, a);
  }

  bool triangles_meet(const Element& a, const Element& b)
  {
    const std::array<const Point*, 3> p = corners(a_, a), q = corners(b_, b);
    std::array<Sign, 3> side_q, side_p;
    if (all_beside(p, q, side_q) || all_beside(q, p, side_p)) return false;
    return edges_meet(p, side_p, q) || edges_meet(q, side_q, p);
  }

  static std::array<const Point*, 3> corners(Body& body, const Element& element)
  {
    return {&body.placed.point(element.corner[0]), &body.placed.point(element.corner[1]), &body.placed.point(element.corner[2])};
  }

  /// The sides of the points against the triangle's plane; true when all are strictly on one.
  static bool all_beside(const std::array<const Point*, 3>& triangle, const std::array<const Point*, 3>& points, std::array<Sign, 3>& side)
  {
    for (int k = 0; k < 3; ++k) side[k] = kernel::volume_sign<Adaptive>(*triangle[0], *triangle[1], *triangle[2], *points[k]);
    return side[0] == side[1] && side[1] == side[2] && side[0] != kernel::ZERO;
  }

  bool edges_meet(const std::array<const Point*, 3>& p, const std::array<Sign, 3>& side, const std::array<const Point*, 3>& q)
  {
    for (int k = 0; k < 3; ++k) {
      const int l = k == 2 ? 0 : k + 1;
      if (side[k] == side[l] && side[k] != kernel::ZERO) continue;
      ++counts_.edge_face_tests;
      if (kernel::segment_triangle<Adaptive>(*p[k], *p[l], *q[0], *q[1], *q[2], side[k], side[l]) != kernel::Contact::none) return true;
    }
    return false;
  }

  /// The edges of an element against one of which either is a whole face.
  bool edges_meet(Body& body, const Element& with_edges, Body& other, const Element& face)
  {
    const auto meets = [&](const Point& p, const Point& q) {
      ++counts_.edge_face_tests;
      if (face.is_whole_face()) return kernel::segment_face<Adaptive>(p, q, Face(other.placed, face.face)) != kernel::Contact::none;
      const auto t = corners(other, face);
      return kernel::segment_face<Adaptive>(p, q, kernel::Triangle<Adaptive>{*t[0], *t[1], *t[2]}) != kernel::Contact::none;
    };
    if (with_edges.is_whole_face()) {
      const Face edges(body.placed, with_edges.face);
      for (std::size_t k = 0; k < edges.edge_count(); ++k)
        if (meets(edges.from(k), edges.to(k))) return true;
      return false;
    }
    const auto p = corners(body, with_edges);
    return meets(*p[0], *p[1]) || meets(*p[1], *p[2]) || meets(*p[2], *p[0]);
  }

  // --- containment --------------------------------------------------------------------------------------------------

  /// Requires surfaces that share no point: then each shell is inside or outside as a whole, and one vertex of it tells.
  bool holds_a_shell(Body& holder, Body& held)
  {
    for (const Index v : held.tree->model().covering().shell_vertices()) {
      ++counts_.inclusion_tests;
      if (winding_number(holder, held, v) != 0) return true;
    }
    return false;
  }

  int winding_number(Body& holder, Body& held, Index v)
  {
    const Point& p = held.placed.point(v);
    const Point origin = holder.placed.frame()(holder.tree->model().origin());
    const kernel::Single_box ray = beyond(held, v);
    int winding = 0;
    std::vector<Index>& nodes = nodes_;
    nodes.assign(1, 0);
    while (!nodes.empty()) {
      const Index n = nodes.back();
      nodes.pop_back();
      const Wide_node& node = holder.tree->node(n);
      kernel::Single_box box = ray;
      double sum = node.reach;
      for (int i = 0; i < 3; ++i) {
        box.centre[i] = float(double(ray.centre[i]) - double(node.origin[i]));
        sum += std::abs(box.centre[i]) + box.extent[i];
      }
      box.slack = kernel::wide_slack(sum, 0) + ray.slack;
      unsigned met = kernel::overlapping_boxes(true)(node.boxes, box) & ((1u << node.lane_count) - 1);
      counts_.box_tests += unsigned(node.lane_count);
      for (; met != 0; met &= met - 1) {
        const int lane = std::countr_zero(met);
        if (holder.tree->is_leaf(n, lane)) winding += winding_of(holder, holder.tree->element(n, lane), p, origin);
        else nodes.push_back(holder.tree->child(n, lane));
      }
    }
    return winding;
  }

  static int winding_of(Body& holder, const Element& element, const Point& p, const Point& origin)
  {
    if (!element.is_whole_face()) {
      const auto t = corners(holder, element);
      return covering::signed_inclusion<Adaptive>(p, origin, *t[0], *t[1], *t[2]);
    }
    const Face face(holder.placed, element.face);
    int winding = 0;
    for (std::size_t k = 0; k < face.edge_count(); ++k)
      winding += covering::signed_inclusion<Adaptive>(p, origin, face.origin(), face.from(k), face.to(k));
    return winding;
  }

  /// A thin box in the holder's local units about the part of the ray from its origin through the vertex that lies beyond the vertex; where
  /// the vertex is too near to the origin to tell the direction, a box about everything. `slack` is the position's error.
  static kernel::Single_box beyond(const Body& held, Index v)
  {
    const kernel::Vector at = held.tree->local(v);
    const Row p = held.into_other(Row{at[0], at[1], at[2]});
    const double error = held.into_other.error() + 0x1p-40;
    const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    kernel::Single_box box{};
    if (!(length > 0x1p20 * error) || !(length < 0x1p20)) {
      for (int i = 0; i < 3; ++i) box.edge[i][i] = 1, box.extent[i] = 4;
      return box;
    }
    // Every point of the holder is within sqrt(3) of its origin; an error at the vertex grows with the distance from it.
    const double end = std::max(2.0, 1.5 * length);
    const kernel::Matrix axes = kernel::detail::axes_from(kernel::Vector(p[0], p[1], p[2]), kernel::Vector(1, 0, 0));
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) box.edge[i][k] = float(axes(k, i));
      box.centre[i] = float(0.5 * (1 + end / length) * p[i]);
    }
    box.extent[0] = float(0.5 * (end - length));
    box.slack = kernel::wide_slack(0, error * end / length) + 64 * 0x1p-24f * float(end);
    return box;
  }

  Body a_, b_;
  std::vector<std::pair<Box, Box>> stack_;
  std::vector<Index> nodes_;
  Counts counts_;
};

}  // namespace tetracone::tetratree

#endif
