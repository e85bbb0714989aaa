#ifndef TETRACONE_VERIFY_PROOFS_GAP_PROOFS_H
#define TETRACONE_VERIFY_PROOFS_GAP_PROOFS_H

#include "tetracone/kernel/bound/obb8_gap.h"
#include "tetracone/kernel/bound/obb8_sweep.h"
#include "tetracone/kernel/bound/relative_frame.h"
#include "tetracone/kernel/bound/relative_motion.h"
#include "verify/proofs/box_test.h"
#include "verify/proofs/obb8_proofs.h"
#include "verify/proofs/proof.h"

/// The constants of kernel/bound/obb8_gap.h and obb8_sweep.h, from the code of their *_simd.inl.
namespace tetracone::verify::proofs {

namespace detail {

/// Numbers of inputs of the expressions below: those of a comparison, and three more numbers behind them.
inline constexpr std::size_t more = Place::end, gap_inputs = more + 3;

/// Returns the comparison for a triangle's box of these inputs.
template <bool fused, class Number>
Box_test<Number, fused> box_test(const std::vector<Number>& in, Edges edges)
{
  return Box_test<Number, fused>(in, edges, true, Number(*in[0].script(), "0"));
}

/// Returns the component of the single box's first axis along the first axis of the eight boxes. In `kept` that axis
/// comes after the three of the eight boxes.
template <bool fused, class Number>
Number component_of_axis(const std::vector<Number>& in)
{
  return kernel::HWY_NAMESPACE::largest_gap<true>(box_test<fused>(in, Edges::carried), Keep_all()).kept.all[3][1].one();
}

/// Returns the first coordinate of a stored axis; its components are the three numbers.
template <bool fused, class Number>
Number stored_coordinate(const std::vector<Number>& in)
{
  using Floats = Axis_number<Number, fused>;
  return kernel::HWY_NAMESPACE::component_in_frame(box_test<fused>(in, Edges::given), 0, Floats(in[more]),
                                                   Floats(in[more + 1]), Floats(in[more + 2]))
      .one();
}

/// Returns the gap beyond a triangle's edge, or the first component of its axis. The first number is the excess of the
/// box over the edge's line, relative to the normal's length. The two others are the first components of the single
/// box's edges 1 and 2.
template <bool fused, bool is_axis, class Number>
Number beyond_edge(const std::vector<Number>& in)
{
  using Floats = Axis_number<Number, fused>;
  const auto test = box_test<fused>(in, Edges::given);
  const Number none(*in[0].script(), "0");
  const Floats zero(none);
  const kernel::HWY_NAMESPACE::Relative_edges<Floats> edges = {
      zero, zero, zero, Floats(in[more + 1]), zero, zero, Floats(in[more + 2]), zero, zero};
  const auto sides = kernel::HWY_NAMESPACE::beyond_triangle(test, edges, zero, zero, zero);
  return kernel::HWY_NAMESPACE::gap_beyond(Keep_all(), test, Floats(in[more]), sides.left_length, sides.left_normal,
                                           none)
      .all[0][is_axis]
      .one();
}

/// Inputs of a sweep along an axis.
struct Sweep_place {
  static constexpr int components = 0, centre = 3, shift = 6, bend = 9, axes = 18, end = 27;
};

/// Returns the displacement along an axis with these components along the axes of the eight boxes. Shift and bend are
/// rounded to float.
template <class Numbers>
auto way_of_sweep(const Numbers& in)
{
  using Floats = Axis_number<std::decay_t<decltype(in[0])>, false>;
  Floats n[3], centre[3], shift[3], bend[3][3], sweep[3];
  for (std::size_t k = 0; k < 3; ++k) {
    n[k] = in[Sweep_place::components + k];
    centre[k] = in[Sweep_place::centre + k];
    shift[k] = entry(in[Sweep_place::shift + k]);
    for (std::size_t j = 0; j < 3; ++j) bend[k][j] = entry(in[Sweep_place::bend + 3 * k + j]);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto* const axis = &in[Sweep_place::axes + 3 * i];
    const Floats a[3] = {axis[0], axis[1], axis[2]};
    sweep[i] = kernel::HWY_NAMESPACE::sweep_along(a, centre, shift, bend);
  }
  return kernel::HWY_NAMESPACE::along_axis(n, sweep);
}

/// The errors of a gap and of its axis, with fused products and without.
struct Losses_of_gap {
  Rational component = 0;  ///< of an axis' components, shares of an edge's length
  Rational stored = 0;     ///< of the stored axis' coordinates, shares of these components
  Rational side = 0;       ///< of components along a triangle's side, over the normal's length
  Rational beyond = 0;     ///< of the gap there, a share of itself
};

/// Returns these errors, with fused products or without.
template <bool fused>
Losses_of_gap losses_of_gap()
{
  const auto slice = [](const std::vector<int>& places) { return slice_of(gap_inputs, places); };
  const auto most = [](const auto& expression, const std::vector<Slice>& slices) {
    return largest(slice_errors<Relative_32>(expression, slices));
  };
  Losses_of_gap losses;
  std::vector<Slice> components, stored;
  for (int k = 0; k < 3; ++k) {
    components.push_back(slice({Place::axis + k, Place::edge, Place::direction + 3 * k}));
    stored.push_back(slice({Place::axis + 3 * k, int(more) + k}));
  }
  losses.component = most([](const auto& in) { return component_of_axis<fused>(in); }, components);
  losses.stored = most([](const auto& in) { return stored_coordinate<fused>(in); }, stored);
  // Extents 1 and 2 are 1: the base is 2, the rest of the apex 1, and the normal's length 3. Each of these contributes
  // at least a third.
  const int one = Place::single_extent + 1, two = Place::single_extent + 2;
  losses.side = 3 * most([](const auto& in) { return beyond_edge<fused, true>(in); },
                         {slice({one, two, int(more) + 1}), slice({one, two, int(more) + 2})});
  losses.beyond =
      3 * most([](const auto& in) { return beyond_edge<fused, false>(in); }, {slice({one, two, int(more)})});
  return losses;
}

}  // namespace detail

/// Returns their proofs. Throws std::runtime_error when Gappa does not prove one.
inline Proved_bounds gap_proofs()
{
  using detail::Kind;
  using kernel::Carried_box;
  const double u = kernel::unit_roundoff<float>;
  const Rational roundoff(u), defect(kernel::axis_defect), computed = 1 + Rational(0x1p-16);
  const std::string file = "kernel/bound/obb8_gap.h";
  Proved_bounds bounds;
  const auto add = [&](const std::string& name, double in_code, const Rational& proved, double unit, double loosest,
                       const std::string& by) {
    bounds.push_back({name, file, Rational(in_code), proved, unit, loosest, by});
  };

  // An upper bound of the distance, as vectors, between a stored axis and the axis of the comparison's exact gap. A
  // component is a sum over products of the entries of two rotations: of the axes of the eight boxes and of the
  // directions. A stored coordinate is a sum over the components.
  const detail::Losses_of_gap fused = detail::losses_of_gap<true>(), apart = detail::losses_of_gap<false>();
  const Rational component = std::max(fused.component, apart.component), stored = std::max(fused.stored, apart.stored),
                 side = std::max(fused.side, apart.side), beyond = std::max(fused.beyond, apart.beyond);
  const Rational off = (3 * component + root_3() * stored) * computed, off_along_side = off + side * computed;

  // Gaps of boxes that are apart: every error counts, relative to M. M is also an upper bound of the distance of two of
  // their points.
  const auto gap = [&](Kind kind) {
    Rational most = 0;
    for (const Rational& share : detail::shares_of(Edges::carried, kind, defect, defect + 3 * roundoff * computed))
      most = std::max(most, share);
    return Rational(most * computed);
  };
  add("gap_rounding", kernel::gap_rounding,
      std::max(gap(Kind::own), Rational(std::max(gap(Kind::other), gap(Kind::across)) + off)), u, 1.16, "gappa");
  add("twice gap_rounding, sides of a triangle", 2 * kernel::gap_rounding,
      gap(Kind::triangle) + beyond + off_along_side, u, 1.66, "gappa");

  // |A A^T b|, b turned by directions of a similarity, of the axes' own defect; and three roundings of the gap.
  const Rational norm = 1 + Rational(3, 2) * defect,
                 length =
                     norm * norm * (1 + defect / 2) * (1 + 2 * Rational(kernel::Relative_frame::similarity_defect)) +
                     off_along_side;
  add("gap_shrink", 1 - double(kernel::gap_shrink), 1 - 1 / (length * power(1 + roundoff, 3)), u, 1.74, "gappa");

  // The displacement is rounded, and n may be.
  const auto moved = [](const auto& in) {
    using Floats = Axis_number<std::decay_t<decltype(in[0])>, false>;
    const Floats n[3] = {entry(in[0]), entry(in[1]), entry(in[2])}, way[3] = {entry(in[3]), entry(in[4]), entry(in[5])};
    return kernel::HWY_NAMESPACE::along_axis(n, way).one();
  };
  const std::vector<Slice> terms = slices_of_dot();
  add("Carried_box::way_rounding", Carried_box::way_rounding,
      largest(slice_errors<Relative_32>(moved, terms)) * length * computed, u, 3.21, "gappa");

  // The error of n . (L_t h - L_0 h). Columns and half edges are rounded. Their images are rounded relative to |L| |h|,
  // with |L| at most sqrt(3) times the scale. Their difference, of length at most |L_t h| + |L_0 h|, is rounded once,
  // and three sums follow.
  const auto image = [](const auto& in) {
    using Floats = Axis_number<std::decay_t<decltype(in[0])>, false>;
    const Floats columns[3] = {entry(in[0]), entry(in[1]), entry(in[2])}, p[3] = {in[3], in[4], in[5]};
    return kernel::HWY_NAMESPACE::along_axis(columns, p).one();
  };
  const Rational of_image = largest(slice_errors<Relative_32>(image, terms)), of_turn = of_image;
  add("Carried_box::edge_rounding", Carried_box::edge_rounding,
      (root_3() * of_image + 2 * roundoff + of_turn + 3 * roundoff) * length * computed, u, 2.02, "gappa");

  // For points with coordinates up to 5: the roundings of the shift and of the half edges, and of three sums.
  add("Carrier::rate_rounding", kernel::Carrier::rate_rounding,
      5 * (of_image + 2 * roundoff + of_turn + 3 * roundoff) * length * computed, u, 1.98, "gappa");

  // The entries of the map and the point's coordinates are rounded.
  const auto gone = [](const auto& in) {
    using Floats = Axis_number<std::decay_t<decltype(in[0])>, false>;
    const Floats row[3] = {entry(in[0]), entry(in[1]), entry(in[2])},
                 point[3] = {entry(in[3]), entry(in[4]), entry(in[5])};
    return kernel::HWY_NAMESPACE::gone(row, Floats(entry(in[6])), point).one();
  };
  const std::vector<Slice> goings = {
      {1, 0, 0, 1, 0, 0, 0}, {0, 1, 0, 0, 1, 0, 0}, {0, 0, 1, 0, 0, 1, 0}, {0, 0, 0, 0, 0, 0, 1}};
  bounds.push_back({"motion_rounding", "kernel/bound/relative_motion.h", Rational(kernel::motion_rounding),
                    largest(slice_errors<Relative_32>(gone, goings)) * computed, u, 2.68, "gappa"});

  // Coordinates of a sweep are rounded to float. The axis has components n along the axes of the eight boxes. Its terms
  // are products of n_i and coordinate k of axis i. The sum of their magnitudes over i is at most the product of both
  // lengths. The sums with the centres' distance keep its error.
  using Sweep = detail::Sweep_place;
  std::vector<Slice> terms_of_sweep;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      const int component = Sweep::components + i, axis = Sweep::axes + 3 * i + k;
      for (int j = 0; j < 3; ++j)
        terms_of_sweep.push_back(slice_of(Sweep::end, {component, axis, Sweep::centre + j, Sweep::bend + 3 * k + j}));
      terms_of_sweep.push_back(slice_of(Sweep::end, {component, axis, Sweep::shift + k}));
    }
  const Rational of_sweep =
      largest(slice_errors<Relative_32>([](const auto& in) { return detail::way_of_sweep(in).one(); }, terms_of_sweep));
  bounds.push_back({"sweep_rounding", "kernel/bound/obb8_sweep.h", Rational(kernel::sweep_rounding),
                    of_sweep * length * norm * computed, u, 2.93, "gappa"});

  // A time is a sum times the inverse of a speed, halved, plus a sum: half of the span's parameters, at most 1.
  bounds.push_back({"time_rounding", "kernel/bound/obb8_sweep.h", Rational(double(kernel::time_rounding)),
                    power(1 + roundoff, 4) - 1, u, 2.02, "rationals"});

  // Points are sums of axes times extents. These are the roundings:
  // - 2 of the squares, which the root halves, and 2 more of the root;
  // - 2 of the product with a turn, and 2 of the sum with a loss;
  // - 1 of what is farthest from the middle, and 1 of a turn's product with that.
  add("radius_rounding", kernel::radius_rounding, norm * length * power(1 + roundoff, 2 + 2 + 4 + 2) - 1, u, 2.76,
      "rationals");
  add("Carried_box::centre_rounding", Carried_box::centre_rounding, root_3() * 4 * roundoff + Rational(0x1p-70), 1,
      2.32, "rationals");
  bounds.push_back({"Placement::position_norm", "kernel/bound/relative_motion.h",
                    Rational(kernel::Placement::position_norm), root_3() * length, 1, 1.16, "rationals"});
  return bounds;
}

}  // namespace tetracone::verify::proofs

#endif
