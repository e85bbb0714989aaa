#ifndef TETRACONE_TETRATREE_SOLVER_CONVEX_DEPTHS_H
#define TETRACONE_TETRATREE_SOLVER_CONVEX_DEPTHS_H

#include "tetracone/kernel/number/nearest_root.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/door/relation_solver.h"
#include "tetracone/tetratree/penetration/convex_body.h"
#include "tetracone/tetratree/penetration/convex_bounds.h"
#include "tetracone/tetratree/penetration/depth_search.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace tetracone::detail {

/// Depths of two bodies by convex solids: exact ones where both are convex, brackets where both nearly are.
///
/// A translation that parts the hulls of two bodies parts the bodies. One that parts the bodies parts convex solids
/// inside of them. So the depths of both are bounds.
class Convex_depths {
 public:
  using Shared_body = std::shared_ptr<const Body_data>;

  /// Requires closed bodies.
  explicit Convex_depths(const std::array<Shared_body, 2>& bodies)
  {
    for (const Shared_body& body : bodies) {
      const auto held = bounds(body);
      if (!held) return;
      outer_.push_back(solid(*held->outer));
      inner_.push_back(held->inner ? solid(*held->inner) : outer_.back());
      inner_body_.push_back(held->inner ? held->inner : held->outer);
      are_convex_ = are_convex_ && !held->inner;
    }
    if (!are_convex_) of_inner_ = relation_solver(inner_body_[0], inner_body_[1]);
  }

  /// Returns the bracket at these poses; nothing where a body is far from convex. Requires interiors that share a
  /// point.
  std::optional<tetratree::Depth_bracket> operator()(const kernel::Pose& pose_a, const kernel::Pose& pose_b)
  {
    if (outer_.size() < 2) return std::nullopt;
    const kernel::Convex_depth high(outer_[0], pose_a, outer_[1], pose_b);
    tetratree::Depth_bracket bracket{high.vector(), high.square(), 0, are_convex_};
    if (are_convex_ || !interiors_meet(of_inner_->relation_alone(pose_a, pose_b))) return bracket;
    const kernel::Convex_depth low(inner_[0], pose_a, inner_[1], pose_b);
    bracket.least = kernel::enclosed_root_sum(std::array{low.square()})[0];
    return bracket;
  }

 private:
  struct Bounds {
    Shared_body outer, inner;  // without an inner one, the body is convex, and the outer one is it
  };

  static std::optional<Bounds> bounds(const Shared_body& body)
  {
    const Shared_body triangles(body, &body->by_triangles());
    if (tetratree::is_known_convex(triangles->polyhedron, triangles->solid_sides())) return Bounds{triangles, nullptr};
    const auto made = [](covering::Polyhedron hull) {
      return std::make_shared<const Body_data>(std::move(hull), std::vector<covering::Face_triangle>());
    };
    auto found = tetratree::convex_bounds(triangles->polyhedron, [&](const covering::Polyhedron& hull) {
      const Solid_relation is = relation_solver(made(hull), triangles)->relation_alone(kernel::Pose(), kernel::Pose());
      return is == Solid_relation::inside || is == Solid_relation::covered_by || is == Solid_relation::equal;
    });
    if (!found) return std::nullopt;
    return Bounds{made(std::move(found->outer)), made(std::move(found->inner))};
  }

  static kernel::Convex_solid solid(const Body_data& triangles)
  {
    return tetratree::convex_solid(triangles.polyhedron, triangles.solid_sides());
  }

  using Solid_relation = kernel::Solid_relation;

  std::vector<kernel::Convex_solid> outer_, inner_;  // of both bodies; fewer where one is far from convex
  std::vector<Shared_body> inner_body_;
  bool are_convex_ = true;
  std::unique_ptr<Relation_solver> of_inner_;  // of bodies that are not both convex
};

}  // namespace tetracone::detail

#endif
