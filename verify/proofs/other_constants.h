#ifndef TETRACONE_VERIFY_PROOFS_OTHER_CONSTANTS_H
#define TETRACONE_VERIFY_PROOFS_OTHER_CONSTANTS_H

#include <vector>

namespace tetracone::verify::proofs {

/// The reason why a constant has no row of its own among the proofs.
enum class Constant_kind {
  unit,    ///< it is exact: a property of a number type, a scale or a count
  choice,  ///< it decides how fast an answer is found, and never which
  gate,    ///< a limit that the code tests: beyond it no bound is used, so proofs take it as given
  term,    ///< it stands in the proof of another constant, which the reason names
  tested,  ///< a test checks it, whose file is the reason
  by_hand  ///< it is an error bound that no machine checks
};

/// A constant of the package without a proof; `name` is its name, or the literal in an expression. `reason` says why it
/// needs none.
struct Other_constant {
  const char *file, *name;
  Constant_kind kind;
  const char* reason;
};

/// Returns all of them: a test finds every other constant without a proof.
inline std::vector<Other_constant> other_constants()
{
  using enum Constant_kind;
  return {
      {"kernel/number/floating_point.h", "unit_roundoff", unit, "half the distance from 1 to the next number"},
      {"kernel/number/floating_point.h", "0x1p-30", unit, "a factor whose square tells fused products"},
      {"kernel/number/floating_point.h", "0x1p-60", unit, "a summand that tells whether sums are rounded"},
      {"tetratree/fast/bvh8_cuts.h", "last", unit, "a count as a float"},

      {"kernel/predicate/hull_separation.h", "least", choice, "lengths that the search for a direction takes"},
      {"kernel/predicate/hull_separation.h", "most", choice, "lengths that the search for a direction takes"},
      {"kernel/predicate/vertex_separation.h", "longest", choice, "how finely a direction is tried"},
      {"kernel/predicate/vertex_separation.h", "0x1p-500", gate, "directions beyond it part nothing"},
      {"kernel/predicate/vertex_separation.h", "0x1p500", gate, "directions beyond it part nothing"},
      {"tetratree/fast/separating_direction.h", "most_overlap_of_near", choice, "when vertices are asked"},
      {"kernel/predicate/hull_separation.h", "step", choice, "a scale of lengths beyond these"},
      {"kernel/predicate/hull_separation.h", "0x1p-40", by_hand, "7 roundings of a sum of absolute values"},
      {"kernel/predicate/hull_separation.h", "image_rounding", tested,
       "verify/test/kernel/predicate/hull_separation.cpp"},
      {"kernel/predicate/hull_separation.h", "image_underflow", tested,
       "verify/test/kernel/predicate/hull_separation.cpp"},
      {"kernel/contact/crossing_polytope.h", "tangent", choice, "from where on fractions decide"},
      {"tetratree/penetration/near_origin.h", "much", choice, "which translations are taken off"},
      {"tetratree/penetration/inner_balls.h", "least_share", choice, "which balls stand for a solid"},
      {"tetratree/penetration/depth_search.h", "enough", choice, "when the search of a ball ends"},
      {"tetratree/penetration/convex_bounds.h", "most_lacking", choice, "which solids are taken as nearly convex"},
      {"tetratree/penetration/depth_search.h", "same_plane", choice, "which planes are tried for corners"},
      {"tetratree/penetration/depth_search.h", "pairs_a_box", choice, "when pairs of boxes are opened"},
      {"tetratree/certificate/group_hull.h", "least", gate, "with smaller numbers all corners are multiplied exactly"},
      {"tetratree/certificate/group_hull.h", "least_point", gate,
       "with smaller numbers all corners are multiplied exactly"},
      {"tetratree/certificate/group_hull.h", "rounding", by_hand, "14 of 32 roundings, in two sums of three products"},
      {"tetratree/certificate/group_hull.h", "shortest", gate, "along shorter directions no box is passed over"},
      {"tetratree/certificate/group_hull.h", "of_boxes", by_hand,
       "8 times box_reach_rounding, for a rounded direction"},
      {"tetratree/certificate/group_hull.h", "farthest", by_hand, "local coordinates are at most 1"},
      {"tetratree/certificate/group_hull.h", "of_places", by_hand, "12 of 512 roundings of a placed point's terms"},
      {"tetratree/certificate/sides.h", "0x1p-20", unit, "a unit of random offsets of points to try"},
      {"tetratree/certificate/approach.h", "0x1p-2", choice, "a share of a segment's length that is tried"},
      {"tetratree/certificate/approach.h", "0x1p-5", choice, "a share of a segment's length that is tried"},
      {"tetratree/certificate/ways.h", "0x1p-4", choice, "a share of a body's size that is tried"},
      {"tetratree/certificate/ways.h", "shortest", choice, "where a cover over intervals is given up"},
      {"tetratree/certificate/lower_bound.h", "shortest", choice, "where a cover over intervals is given up"},
      {"tetratree/certificate/lower_bound.h", "0x1p-20", choice, "a share of a radius, so that covers have room"},
      {"tetratree/certificate/fractions.h", "0x1p-1000", unit, "a power of two, by which an exact number is scaled"},
      {"kernel/bound/relative_motion.h", "least_step", choice, "steps are multiples of it, exactly"},
      {"kernel/bound/triangle_distance.h", "0x1p-40", choice, "where the search for nearer points ends"},
      {"tetratree/fast/bvh8_builder.h", "steep", choice, "cost of a tree"},
      {"tetratree/fast/bvh8_builder.h", "reach_of_bins", choice, "cost of a tree"},
      {"tetratree/fast/bvh8_builder.h", "most_for_cones", choice, "cost of a tree"},
      {"tetratree/memory/bvh8_front.h", "most_strayed", choice, "when a new course is set"},
      {"tetratree/memory/bvh8_front.h", "most_at_rest", choice, "when a new course is set"},
      {"tetratree/query/bvh8_motion.h", "share_of_size", choice, "when a span of time is halved"},
      {"tetratree/query/bvh8_motion.h", "share_of_leaves", choice, "when a span of time is halved"},
      {"tetratree/fast/bvh8_treelet.h", "opening_cost", choice, "cost of a tree"},
      {"tetratree/fast/bvh8_treelet.h", "no_surface", choice, "cost of a tree"},
      {"tetratree/memory/front_entries.h", "at_once", choice, "a mark: what is to be asked the next time"},
      {"tetratree/memory/front_policy.h", "of_elements", choice, "cost of a front"},
      {"tetratree/memory/front_policy.h", "of_check", choice, "cost of a front"},
      {"tetratree/memory/front_policy.h", "of_certified", choice, "cost of a front"},
      {"tetratree/memory/front_policy.h", "of_pose", choice, "cost of a front"},
      {"tetratree/memory/front_policy.h", "making", choice, "cost of a front"},
      {"tetratree/memory/front_policy.h", "too_many", choice, "cost of a front"},
      {"tetratree/memory/front_policy.h", "pays_below", choice, "cost of a front"},
      {"tetratree/fast/separating_direction.h", "hopeless", choice, "when a search for a plane is given up"},
      {"tetratree/scene/box_tree.h", "nodes_a_build", choice, "when a tree of boxes is built anew"},
      {"tetratree/scene/scene_bodies.cpp", "steps_ahead", choice, "how wide kept boxes are"},
      {"tetratree/scene/scene_bodies.cpp", "most_room", choice, "how wide kept boxes are"},
      {"tetratree/scene/scene_bodies.cpp", "places_ahead", choice, "how wide kept boxes are"},
      {"tetratree/scene/scene_bodies.cpp", "most_room_ahead", choice, "how wide kept boxes are"},
      {"tetratree/scene/scene_bodies.cpp", "first_room_of_long", choice, "how wide kept boxes are"},
      {"tetratree/scene/scene_bodies.cpp", "soon", choice, "when kept boxes are made anew"},
      {"tetratree/scene/scene_bodies.cpp", "most_grown", choice, "when kept boxes are made anew"},
      {"tetratree/scene/scene_models.cpp", "pairs_a_face_of_trees", choice, "when trees are made"},
      {"tetratree/scene/near_pairs.cpp", "little", choice, "when a pair is asked for a certificate"},

      {"kernel/bound/bounds.h", "separation_gate", gate, "larger boxes are not told apart"},
      {"kernel/bound/cone_cells.h", "core", gate, "nearer to the origin no cell is asked"},
      {"kernel/bound/cone_cells.h", "least_slope", gate, "a plane of less slope tells nothing"},
      {"kernel/bound/cone_lattice.h", "room", gate, "an origin is clamped to it"},
      {"kernel/bound/cone_slab.h", "least_slope", gate, "a plane of less slope tells nothing"},
      {"kernel/bound/cone_slab.h", "highest", gate, "a plane of greater heights tells nothing"},
      {"kernel/bound/obb8.h", "no_apex", gate, "a mark: no triangle lies in the box"},
      {"kernel/bound/obb8_gap.h", "most_gap_slack", gate, "with more slack no gap is certified"},
      {"kernel/bound/obb8_ray.h", "length", gate, "no ray meets a body beyond it"},
      {"kernel/bound/obb8_ray.h", "farthest", gate, "rays from beyond it are asked without boxes"},
      {"kernel/bound/relative_frame.h", "similarity_defect", gate, "maps of more defect are no similarities"},
      {"kernel/bound/relative_frame.h", "most_residual", gate, "inverses with more residual are not used"},
      {"kernel/motion/rotation_quaternion.h", "rotation_tolerance", gate,
       "matrices farther from rotations are refused"},
      {"kernel/bound/relative_motion.h", "most_steps", gate, "after more steps a new course is set"},
      {"kernel/number/floating_point.h", "magnitude_gate", gate, "beyond it no sign is decided in rounded numbers"},
      {"tetratree/query/bvh8_distance.h", "least_square", gate, "a square below it tells no lower bound"},
      {"tetratree/memory/bvh8_front.h", "most_error", gate, "maps with more error are not certified"},
      {"tetratree/memory/front_entries.h", "most_gone", gate, "after more motion a new course is set"},
      {"tetratree/query/span_reference.h", "most_bent", gate, "maps farther from a similarity are not certified"},
      {"tetratree/locator/point_locator.h", "farthest", gate, "points beyond it are outside"},
      {"tetratree/door/tree_flaw.cpp", "most_coordinate", gate, "saved boxes of larger numbers are refused"},
      {"tetratree/memory/pair_certificate.h", "least_left", gate, "with less left a pair is asked"},
      {"tetratree/memory/pair_certificate.h", "most_gap", gate, "of a larger gap no more is kept"},
      {"tetratree/scene/turned_box.h", "most_skewed", gate, "axes that are more skewed make no box"},
      {"kernel/bound/obb8_distance_simd.inl", "0x1p-100f", gate, "smaller numerators or squares tell nothing"},

      {"kernel/bound/obb8.h", "axis_defect", term, "of boxes' axes, which are checked when stored: axis_defect_factor"},
      {"kernel/bound/obb8_ray.h", "least_step", term, "Local_ray::slack"},
      {"kernel/predicate/enclosed_distance.h", "most_radii", term, "Enclosed_distance::direction_error"},
      {"kernel/number/double_double_ball.h", "most_radius", term, "Double_double_ball::quotient_rounding"},
      {"kernel/number/double_double_ball.h", "most_step", term, "Double_double_ball::step_rounding"},
      {"kernel/number/floating_point.h", "underflow_slack", tested, "verify/test/verify/proofs/bound_proofs.cpp"},

      {"kernel/predicate/vertex_separation.h", "rounding", by_hand,
       "a rounded fraction, a product and two sums of a factor, a product and three sums: 8 of 16 roundings"},
      {"kernel/bound/relative_frame.h", "underflow", by_hand,
       "products of numbers within is_in_range lose 2^-1075 each, times factors of at most 2^700"},
      {"kernel/bound/cone_coordinates.h", "64 * unit_roundoff<B>", by_hand,
       "lengths are products and quotients of fewer than 64 rounded numbers"},
      {"kernel/bound/obb8_gap_simd.inl", "0x1p-20", by_hand,
       "an upper bound of a double times a float, each rounded once: 2^-23 is enough"},
      {"kernel/bound/obb8_point.h", "point_box_rounding", by_hand,
       "9 roundings of 2^-24 of numbers up to M, and 8 of 2^-24 for the axes' defect times the extents: 17 of 32"},
      {"kernel/bound/obb8_point.h", "point_square_shrink", by_hand,
       "3 axis_defect are 3 of 2^-21, 6 roundings less than 1: 4 of 8"},
      {"kernel/bound/obb8_sweep.h", "0x1p-120", by_hand,
       "eighth powers of singular values underflow below 2^-134, where their root is below 2^-130"},
      {"kernel/bound/obb8_distance_simd.inl", "0x1p-20f", by_hand,
       "three sums and two products in float: five roundings of 2^-24"},
      {"kernel/motion/motion_span.h", "0x1p-90", by_hand,
       "seven sums in double-double, each off by 3 u^2 of the terms: 24 u^2 is below 2^-101"},
      {"tetratree/fast/separating_direction.h", "0x1p-40", by_hand,
       "a root, a quotient and two products in double: five roundings of 2^-53"},
      {"tetratree/query/bvh8_motion.h", "0x1p-20", by_hand, "a window's end as a float: one rounding of 2^-24"},
      {"tetratree/query/bvh8_motion.h", "0x1p-40f", by_hand,
       "a share of a window's end near 0, where a float has no relative error of 2^-24"},
      {"tetratree/query/bvh8_distance.h", "0x1p-100f", by_hand, "what a limit in float loses by underflow: 2^-150"},
      {"kernel/bound/triangle_distance.h", "length_underflow", by_hand,
       "3 2^-1075 is below 2^-1073, and its root below 2^-536"},
      {"tetratree/query/bvh8_points.h", "0x1p-100f", by_hand, "what a limit in float loses by underflow: 2^-150"},
      {"tetratree/query/bvh8_points.h", "relative_error", by_hand, "a difference of doubles: one rounding of two"},
      {"tetratree/query/bvh8_points.h", "least_double", by_hand, "a rational below it is rounded to it or to 0"},
      {"tetratree/query/bvh8_points.h", "box_error", by_hand,
       "local_error, 2^-52, in three coordinates: the root of 3 of 4"},
      {"tetratree/query/bvh8_rays.h", "0x1p-14", by_hand,
       "entries of boxes are off by Local_ray::slack, 2^-16, and times by less than as much"},
      {"kernel/motion/contact_plane.h", "most_in_box", by_hand,
       "three coordinates or half-edges within the unit cube, each below 2"},
      {"tetratree/door/tree_flaw.cpp", "defect_share", by_hand, "3 d (1 + 4 d) of axes with defect d, and half a d"},
      {"tetratree/door/tree_flaw.cpp", "position_share", by_hand, "the root of 3 times 3 2^-54, below 1.5 2^-52"},
      {"tetratree/door/tree_flaw.cpp", "0x1p-46", by_hand, "fewer than 64 roundings in double of numbers below 2"},
      {"tetratree/door/tree_flaw.cpp", "0x1p-54", by_hand, "a rounded difference below 1"},
      {"tetratree/door/tree_flaw.cpp", "0x1p-50", by_hand, "a root, five sums and a product in double"},
      {"tetratree/scene/body_extent.h", "0x1p-50", by_hand, "two differences and a product in double: 3 of 2^-53"},
      {"tetratree/scene/world_box.h", "0x1p-50", by_hand,
       "a difference, three sums and a product in double: 5 of 2^-53"},
  };
}

}  // namespace tetracone::verify::proofs

#endif
