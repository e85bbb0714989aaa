#ifndef TETRACONE_VERIFY_PROOFS_OBB8_PROOFS_H
#define TETRACONE_VERIFY_PROOFS_OBB8_PROOFS_H

#include "tetracone/kernel/bound/obb8_overlap.h"
#include "verify/proofs/box_test.h"
#include "verify/proofs/proof.h"

#include <map>
#include <utility>

/// The slacks of kernel/bound/obb8.h, from the comparison of kernel/bound/obb8_overlap_simd.inl itself.
namespace tetracone::verify::proofs {

namespace detail {

/// The positions of a slice's inputs, in any arithmetic.
using Place = Box_test<Recorded<Exact>, true>;

/// The error of an axis' gap, by its four coefficients. They are those of |single centre|, |centre|, the sum of
/// extents, and the sum of the single box's extents.
using Shares = std::array<Rational, 4>;

/// Returns the gaps along all axes for these inputs, in the order of `gaps_of`.
template <class Arithmetic, bool fused>
std::vector<Recorded<Arithmetic>> gaps(const std::vector<Recorded<Arithmetic>>& in, Edges edges, bool triangle)
{
  return gaps_of(Box_test<Recorded<Arithmetic>, fused>(in, edges, triangle, {*in[0].script(), "0"}), edges);
}

/// Returns the slices of a scale, which is the first input of a vector: `single_centre`, `centre` or an extent. A slice
/// has 1 for one component of that vector, for component q of the first axis and, with `two_axes`, of the second. It
/// also has 1 for component q of the edges; `general` ones have the next components in turn. Products of other
/// components are rounded no more often. The code treats other axes alike.
inline std::vector<Slice> slices_of_box(int scale, bool two_axes, Edges edges, bool triangle)
{
  std::vector<Slice> slices;
  for (int s = 0; s < 3; ++s) {
    // A centre counts along the same component of an axis; of others, the first product of a sum is rounded most.
    const int q = scale == Place::extent || scale == Place::single_extent ? 0 : s;
    Slice slice(Place::end, 0);
    slice[scale + s] = 1;
    slice[Place::axis + q] = 1;
    if (two_axes) slice[Place::axis + 3 + q] = 1;
    for (int j = 0; j < 3; ++j)
      slice[Place::edge + 3 * j + (edges == Edges::carried ? 0 : edges == Edges::general ? (q + j) % 3 : q)] = 1;
    slice[Place::direction + 3 * q] = 1;
    if (triangle) slice[Place::single_extent + 1] = slice[Place::single_extent + 2] = 1;
    slices.push_back(slice);
  }
  return slices;
}

/// A kind of axis: a normal of the eight boxes, one of the single box, a cross product, or a normal of a triangle's
/// side.
enum class Kind { own, other, across, triangle };

/// Returns the rounding error of the gap for each kind of axis. Gappa bounds it for single products of the inputs; the
/// bound is multiplied by the number of products in a gap. All inputs except the scale are components of vectors of
/// length about 1. By Cauchy and Schwarz, the sums of their products are therefore at most 1. The number is 3 for a
/// normal of the single box, and 2 for a product of two axes. Along that normal, the centres' distance is a sum over
/// all three axes of the eight boxes.
template <bool fused>
std::array<Shares, 4> rounding_of_gaps(Edges edges, bool triangle)
{
  std::array<Shares, 4> shares{};
  constexpr std::array<int, 4> scales = {Place::single_centre, Place::centre, Place::extent, Place::single_extent};
  for (int scale = 0; scale < (triangle ? 3 : 4); ++scale)
    for (const bool two_axes : {false, true}) {
      if (two_axes && (triangle || scale > 1)) continue;
      const auto slices = slices_of_box(scales[scale], two_axes, edges, triangle);
      Gappa_script script;
      std::vector<std::pair<Kind, Rational>> asked;  // and how often it counts
      for (std::size_t n = 0; n < slices.size(); ++n) {
        std::vector<Recorded<Relative_32>> computed;
        std::vector<Recorded<Exact>> exact;
        for (const double input : slices[n]) {
          const std::string name = input == 0 ? "0" : script.define("1");
          computed.emplace_back(script, name);
          exact.emplace_back(script, name);
        }
        const auto rounded = gaps<Relative_32, fused>(computed, edges, triangle);
        const auto meant = gaps<Exact, true>(exact, edges, triangle);
        std::array<bool, 4> is_asked{};
        for (std::size_t g = 0; g < rounded.size(); ++g) {
          const Kind kind = g < 3 ? Kind::own : g < 6 ? Kind::other : g < 15 ? Kind::across : Kind::triangle;
          if (rounded[g].is_zero() || two_axes != (kind == Kind::across && scale < 2)) continue;
          if (triangle != (kind == Kind::triangle) || is_asked[int(kind)]) continue;
          is_asked[int(kind)] = kind != Kind::triangle;
          // Both products across stand in one slice. A triangle's normal has length 3 in these slices, and distances of
          // centres 3 terms, as along others' normals.
          const Rational times = kind == Kind::triangle && scale >= 2 ? Rational(1, 3)
                                 : kind == Kind::other && scale < 2   ? Rational(3)
                                                                      : Rational(1);
          script.ask(rounded[g].name() + " - (" + meant[g].name() + ")");
          asked.emplace_back(kind, times);
        }
      }
      if (asked.empty()) continue;
      const auto enclosures = script.prove();
      for (std::size_t k = 0; k < asked.size(); ++k) {
        Rational& most = shares[int(asked[k].first)][scale];
        most = std::max(most, Rational(asked[k].second * enclosures[k].magnitude()));
      }
    }
  return shares;
}

/// Returns the change of the gap of boxes that share a point, over real numbers, when axes are not orthonormal. The
/// axes of the eight boxes are off by `d`, those of the single box by `e`.
///
/// Along its own normal a_i, the other axes' reach is d. Another box's normal n is tried as A A^T n, which differs by 3
/// d; the other edges reach e along it. Across, r_l a_m - r_m a_l, the eight boxes reach sqrt(2) d more. An edge b_k
/// reaches (a_l x a_m) . (b_j x b_k) instead of a_i . b_o.
inline Shares defect_of_gap(Kind kind, Edges edges, const Rational& d, const Rational& e)
{
  const Rational none = 0, second_order = 1 + Rational(0x1p-10);
  const Rational of_normal = edges == Edges::general ? none : Rational(e),
                 across_edges = edges == Edges::general ? none : cross_defect(e);
  switch (kind) {
    case Kind::own: return {none, none, d, none};
    case Kind::other:
    case Kind::triangle: return {none, none, 3 * d * second_order, (3 * d + of_normal) * second_order};
    case Kind::across:
      return {none, none, root_2() * d * second_order, (cross_defect(d) + across_edges) * second_order};
  }
  return {};
}

/// Returns the coefficients of one kind of axis: upper bounds over all its gaps, with fused products and without. `d`
/// and `e` are as in `defect_of_gap`.
inline Shares shares_of(Edges edges, Kind kind, const Rational& d, const Rational& e)
{
  const bool triangle = kind == Kind::triangle;
  static std::map<std::pair<Edges, bool>, std::array<std::array<Shares, 4>, 2>> known;
  auto& both = known[{edges, triangle}];
  if (both[0][int(kind)] == Shares{})
    both = {rounding_of_gaps<true>(edges, triangle), rounding_of_gaps<false>(edges, triangle)};
  // Lengths above 1, of normals and of directions: |b x c| taken with absolute terms, and a rotation's entries as well.
  const Rational longer = (edges == Edges::general   ? root_2()
                           : edges == Edges::carried ? root_3()
                                                     : Rational(1)) *
                          (1 + Rational(0x1p-16));
  const Shares defect = defect_of_gap(kind, edges, d, e);
  Shares sum;
  for (int k = 0; k < 4; ++k) sum[k] = longer * std::max(both[0][int(kind)][k], both[1][int(kind)][k]) + defect[k];
  // Edges in double are rounded to float: this is also the error of a point of the single box along any axis.
  if (edges == Edges::general) sum[3] += Rational(kernel::unit_roundoff<float>);
  return sum;
}

}  // namespace detail

/// Returns their proofs. Throws std::runtime_error when Gappa does not prove one.
inline Proved_bounds obb8_proofs()
{
  using detail::Kind;
  const double u = kernel::unit_roundoff<float>;
  const Rational roundoff(u), defect(kernel::axis_defect), computed = 1 + Rational(0x1p-18);
  Proved_bounds bounds;
  const std::string file = "kernel/bound/obb8.h";

  const auto largest = [&](Edges edges, const Rational& e) {
    Rational most = 0;
    for (const Kind kind : {Kind::own, Kind::other, Kind::across})
      for (const Rational& share : detail::shares_of(edges, kind, defect, e)) most = std::max(most, share);
    return Rational(most * computed);
  };
  bounds.push_back({"box_rounding, boxes of any map", file, Rational(kernel::box_rounding), largest(Edges::general, 0),
                    u, 1.12, "gappa"});
  // Orthonormal in double, and rounded to float.
  bounds.push_back({"box_rounding, rays of containment", file, Rational(kernel::box_rounding),
                    largest(Edges::given, Rational(2 * roundoff * computed)), u, 1.79, "gappa"});

  // Axes with their defect, turned by the directions of a similarity, which are orthonormal up to 2^-24. Roundings
  // after the centres' difference are counted together: boxes that meet are no farther apart than their extents. For
  // these, the single centre is no farther from the node's origin than reach and extents together.
  const auto carried = [&](Kind kind) {
    const auto share = detail::shares_of(Edges::carried, kind, defect, Rational(defect + 3 * roundoff * computed));
    return Rational((share[0] + std::max(share[2], share[3])) * computed);
  };
  bounds.push_back({"carried_box_rounding", file, Rational(kernel::carried_box_rounding),
                    std::max({carried(Kind::own), carried(Kind::other), carried(Kind::across)}), u, 1.36, "gappa"});
  bounds.push_back({"twice carried_box_rounding, sides of a triangle", file, Rational(2 * kernel::carried_box_rounding),
                    carried(Kind::triangle), u, 2.13, "gappa"});

  // |L|_1 <= sqrt(3) |L|_2 for every axis L, of length 1 up to the defect.
  bounds.push_back({"position_factor", file, Rational(kernel::position_factor), root_3() * (1 + 6 * defect) * computed,
                    1, 4.63, "rationals"});
  return bounds;
}

}  // namespace tetracone::verify::proofs

#endif
