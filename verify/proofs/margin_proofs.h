#ifndef TETRACONE_VERIFY_PROOFS_MARGIN_PROOFS_H
#define TETRACONE_VERIFY_PROOFS_MARGIN_PROOFS_H

#include "tetracone/kernel/bound/bound_box.h"
#include "tetracone/kernel/bound/cone_coordinates.h"
#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/tetratree/fast/support_table.h"
#include "tetracone/tetratree/paper/regular_hull.h"
#include "tetracone/tetratree/query/bvh8_containment.h"
#include "verify/proofs/adaptive_proofs.h"
#include "verify/proofs/proof.h"

#include <CGAL/Interval_nt.h>

/// Margins proved by geometry or by counting roundings: derived in exact rationals, or in intervals.
namespace tetracone::verify::proofs {

namespace detail {

using Interval = CGAL::Interval_nt<>;
using Interval_vector = std::array<Interval, 3>;

/// Upper bounds of the errors of the plane through three unit vectors along rays, computed in double, relative to its
/// distance from V0.
struct Plane_error {
  double normal = 0;  ///< of the normal, as it moves the plane
  double height = 0;  ///< of the distance itself
};

/// Returns the errors for a cone. Unit vectors are integer vectors, whose squares are exact, over a rounded root: they
/// have 2 roundings.
inline Plane_error plane_error(const tetratree::Tetra_cone& cone)
{
  const Interval u = kernel::unit_roundoff<double>, of_unit = 2 * u * (1 + u);
  std::array<Interval_vector, 3> unit;
  for (int i = 0; i < 3; ++i) {
    Interval square = 0;
    for (const std::int32_t x : cone.ray[i]) square += Interval(x) * Interval(x);
    for (int k = 0; k < 3; ++k) unit[i][k] = Interval(cone.ray[i][k]) / sqrt(square);
  }
  const Interval_vector p = kernel::difference(unit[1], unit[0]), q = kernel::difference(unit[2], unit[0]);
  const auto error_of_edge = [&](const Interval_vector& to, const Interval_vector& edge, int k) {
    return of_unit * (abs(to[k]) + abs(unit[0][k])) + u * abs(edge[k]) * (1 + u);
  };
  const Interval_vector normal = kernel::cross(p, q);
  Interval error_2 = 0, normal_2 = 0, height = 0, terms = 0;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const auto ep = [&](int at) { return error_of_edge(unit[1], p, at); };
    const auto eq = [&](int at) { return error_of_edge(unit[2], q, at); };
    const Interval products = abs(p[i] * q[j]) + abs(p[j] * q[i]);
    const Interval error = ep(i) * (abs(q[j]) + eq(j)) + abs(p[i]) * eq(j) + ep(j) * (abs(q[i]) + eq(i)) +
                           abs(p[j]) * eq(i) + 2 * u * (1 + u) * products * (1 + Interval(0x1p-40));
    error_2 += error * error;
    normal_2 += normal[k] * normal[k];
    height += normal[k] * unit[0][k];
    terms += abs(normal[k] * unit[0][k]);
  }
  const Interval off = sqrt(error_2), distance = abs(height);
  // The normal itself; unit[0], the dot product and the product with the longest edge.
  const Interval moved = off / distance, dot = (of_unit + 4 * u) * terms / distance;
  return {(moved + dot).sup(), (moved + dot + off / sqrt(normal_2) + 4 * u).sup()};
}

/// Returns the largest errors among the cones down to a level in the first octant; the others are its mirror images.
inline Plane_error largest_plane_error(int deepest)
{
  Plane_error largest;
  const auto visit = [&](const auto& self, const tetratree::Tetra_cone& cone, int level) -> void {
    const Plane_error here = plane_error(cone);
    largest.normal = std::max(largest.normal, here.normal);
    largest.height = std::max(largest.height, here.height);
    for (int k = 0; k < 4 && level < deepest; ++k) self(self, cone.child(k), level + 1);
  };
  visit(visit, tetratree::Tetra_cone::octant(0), 1);
  return largest;
}

/// Returns the underflow of `together` of kernel/bound/obb8_overlap_simd.inl along its longest path: a coordinate along
/// an axis, times another, times an extent. Centres and extents are in local units: at most 8.
inline Rational underflow_of_boxes()
{
  using Float = Range_number<Float_range>;
  const std::array<Float, 3> axis = {Float(1), Float(1), Float(1)}, place = {Float(8), Float(8), Float(8)};
  const Float t = kernel::dot(axis, place), r = kernel::dot(axis, axis);
  const std::array<Float, 3> ts = {t, t, t}, rs = {r, r, r};
  return (kernel::dot(ts, rs) + kernel::dot(place, rs) + kernel::dot(place, rs)).lost();
}

}  // namespace detail

/// Returns their proofs. Throws std::runtime_error when Gappa does not prove one.
inline Proved_bounds margin_proofs()
{
  using Containment = tetratree::Bvh8_containment<>;
  using Hull = tetratree::Regular_hull<double, true>;
  using Cone = kernel::Cone_coordinates<double, true>;
  using Frame = kernel::Relative_frame;
  using detail::triple;
  using tetratree::Support_table;
  const double u = kernel::unit_roundoff<double>, of_float = kernel::unit_roundoff<float>;
  const Rational once = 1 / (1 - Rational(u)), once_in_float = 1 / (1 - Rational(of_float));
  const Rational defect(kernel::axis_defect);
  Proved_bounds bounds;
  const auto add = [&](const std::string& name, const std::string& file, double in_code, const Rational& proved,
                       double unit, double loosest, const std::string& by = "rationals") {
    bounds.push_back({name, file, Rational(in_code), proved, unit, loosest, by});
  };

  add("few_roundings", "kernel/number/floating_point.h", kernel::few_roundings, power(once, 100) - 1, u, 82);
  // A box's size is rounded by two sums and a stretch, and by the product with this. Then the slack of a gap is rounded
  // by two sums and two products.
  add("rounded_up", "kernel/bound/obb8.h", kernel::rounded_up - 1, power(once_in_float, 8) - 1, of_float, 2.01);
  add("box_underflow", "kernel/bound/obb8.h", kernel::box_underflow, detail::underflow_of_boxes(), 0x1p-149, 2.86e12);

  // The rows of X = f M^T: |col|_1 <= sqrt(3) |col|_2. A column is as long as the first up to the defect of its square;
  // a root, a quotient and two products round it.
  add("Relative_frame::root_of_3", "kernel/bound/relative_frame.h", Frame::root_of_3,
      root_3() * (1 + Rational(Frame::similarity_defect)) * power(once, 6), 1, 1.0001);

  // An apex is the nearest of its steps. Corners are before a line of a box whose extents are wider than they need be,
  // by the axes' defect and a float. The cut's lines are of extents that are stretched, by 3 floats each.
  add("apex_tolerance", "kernel/bound/obb8.h", kernel::apex_tolerance,
      Rational(1) / (2 * kernel::apex_steps) + Rational(kernel::axis_defect_factor) * defect +
          8 * Rational(of_float) * once_in_float,
      1, 1.75);

  // s = (A^T A)^-1 A^T y for axes with that defect d: 3 d (1 + 4 d) of the largest entry; the fourth d is for rounding.
  const Rational d(kernel::bound_box_defect);
  add("bound_box_defect in bound_box", "kernel/bound/bound_box.h",
      kernel::axis_defect_factor * kernel::bound_box_defect, 3 * d / (1 - 3 * d), kernel::bound_box_defect, 1.34);

  // |d|_1 <= 20/16 in the lattice with its corners beyond the octant; of a box within 2 of the model's origin, 8 along
  // each of its axes in all.
  const auto reach = [](const auto& in) {
    return Support_table::reach_of_box(triple(in, 0), triple(in, 3), triple(in, 6),
                                       std::array{triple(in, 9), triple(in, 12), triple(in, 15)}, triple(in, 18));
  };
  std::vector<Slice> terms_of_reach;
  for (int k = 0; k < 3; ++k)
    for (const int place : {3, 6, 9})
      terms_of_reach.push_back(slice_of(21, place == 9 ? std::vector{k, 9 + k, 18} : std::vector{k, place + k}));
  const Rational most = largest(slice_errors<Relative_32>(reach, terms_of_reach));
  add("Support_table::box_reach_rounding", "tetratree/fast/support_table.h", Support_table::box_reach_rounding,
      most * Rational(20, 16) * (2 + 2 + 8), of_float, 1.23, "gappa");

  const detail::Plane_error plane = detail::largest_plane_error(Hull::deepest_convex_level);
  add("Regular_hull::normal_rounding", "tetratree/paper/regular_hull.h", Hull::normal_rounding, Rational(plane.normal),
      1, 1.8, "intervals");
  // Cones of the levels below have edges of half the length each, and twice the error.
  const Rational deeper = 2 * power(2, kernel::max_cone_depth - Hull::deepest_convex_level);
  add("Cone_coordinates::height_rounding", "kernel/bound/cone_coordinates.h", Cone::height_rounding,
      deeper * Rational(plane.height) + 8 * Rational(u), 1, 1.8, "intervals");

  // |p|_2 <= sqrt(3) of points with |p_k| <= 1.
  add("Bvh8_containment::beyond_holder", "tetratree/query/bvh8_containment.h", Containment::beyond_holder, root_3(), 1,
      1.16);
  return bounds;
}

}  // namespace tetracone::verify::proofs

#endif
