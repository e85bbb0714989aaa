#ifndef TETRACONE_KERNEL_BOUND_OBB8_GAP_SIMD_INL
#define TETRACONE_KERNEL_BOUND_OBB8_GAP_SIMD_INL
// Included by kernel/bound/obb8_gap.h, once for each target.
#ifndef TETRACONE_SIMD_FILE
#undef TETRACONE_KERNEL_BOUND_OBB8_GAP_SIMD_INL  // that header includes this one, again and again
#include "tetracone/kernel/bound/obb8_gap.h"
#else

HWY_BEFORE_NAMESPACE();
namespace tetracone::kernel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A gap along an axis, whose components along the eight's axes are n.
template <class Floats>
struct Gap_along {
  Floats gap, n0, n1, n2;
};

template <class Floats>
HWY_INLINE Gap_along<Floats> Max(const Gap_along<Floats>& a, const Gap_along<Floats>& b)
{
  const auto is_first = hn::Gt(a.gap, b.gap);
  return {hn::IfThenElse(is_first, a.gap, b.gap), hn::IfThenElse(is_first, a.n0, b.n0),
          hn::IfThenElse(is_first, a.n1, b.n1), hn::IfThenElse(is_first, a.n2, b.n2)};
}

/// A policy of `largest_gap` that keeps the gap and its axis.
struct Gap_and_axis {
  template <class Floats>
  HWY_INLINE Gap_along<Floats> operator()(Floats gap, Floats, Floats n0, Floats n1, Floats n2) const
  {
    return {gap, n0, n1, n2};
  }
};

// The error of a gap is proved from these functions, run over other numbers than vectors (verify/proofs/gap_proofs.h).

/// Returns component k, in the node's frame, of a vector with components n along the eight's axes.
template <class Test, class Floats>
HWY_INLINE Floats component_in_frame(const Test& test, int k, const Floats& n0, const Floats& n1, const Floats& n2)
{
  return MulAdd(n2, test.load(test.boxes.axis[2][k]),
                MulAdd(n1, test.load(test.boxes.axis[1][k]), Mul(n0, test.load(test.boxes.axis[0][k]))));
}

/// Returns what `kept` keeps of the gap beyond a triangle's edge and of its axis: the distance `beyond` and the normal
/// n, both over `length`. The gap takes the place of the centres' distance too.
template <class Kept, class Test, class Floats, class Number>
HWY_INLINE auto gap_beyond(const Kept& kept, const Test& test, const Floats& beyond, const Number& length,
                           const Floats (&n)[3], const Number& slack)
{
  const Floats shorter = test.all(Number(1) / length);
  const Floats gap = Sub(Mul(beyond, shorter), test.all(slack));
  return kept(gap, gap, Mul(n[0], shorter), Mul(n[1], shorter), Mul(n[2], shorter));
}

/// Returns n . way.
template <class Floats>
HWY_INLINE Floats along_axis(const Floats (&n)[3], const Floats (&way)[3])
{
  return MulAdd(way[2], n[2], MulAdd(way[1], n[1], Mul(way[0], n[0])));
}

/// Writes certified gaps of the test's lanes, and their axes; returns the gaps. Requires a similarity, and a slack that
/// is at most `most_gap_slack`.
HWY_INLINE auto certify_gaps(const One_test& test, float slack, Certified_gaps& gaps)
{
  using Floats = One_test::Floats;
  const auto all = [&](float x) HWY_ATTR { return test.all(x); };
  const auto largest = largest_gap<true>(test, Gap_and_axis());
  const Relative_edges<Floats>& edges = largest.edges;
  Gap_along<Floats> best = largest.kept;
  best.gap = Sub(best.gap, all(slack));
  if (test.holds_triangle()) {
    const auto sides = beyond_triangle(test, edges, test.load(test.boxes.extent[0]), test.load(test.boxes.extent[1]),
                                       test.load(test.boxes.extent[2]));
    const float slack_of_sides = side_slack(test.box, slack);
    const auto side = [&](Floats beyond, float length, const Floats(&n)[3])
                          HWY_ATTR { return gap_beyond(Gap_and_axis(), test, beyond, length, n, slack_of_sides); };
    best = Max(best, Max(side(sides.left, sides.left_length, sides.left_normal),
                         side(sides.right, sides.right_length, sides.right_normal)));
  }
  // The axis points away from the lane, towards the single box's centre.
  const Floats along = MulAdd(edges.t2, best.n2, MulAdd(edges.t1, best.n1, Mul(edges.t0, best.n0)));
  const Floats outward = hn::CopySign(all(1), along), n0 = Mul(best.n0, outward), n1 = Mul(best.n1, outward),
               n2 = Mul(best.n2, outward);
  for (int k = 0; k < 3; ++k)
    hn::Store(component_in_frame(test, k, n0, n1, n2), One_test::tag, gaps.axis[k] + test.first);
  const Floats gap = Mul(best.gap, all(gap_shrink));
  hn::Store(gap, One_test::tag, gaps.gap + test.first);
  return gap;
}

inline HWY_ATTR void certified_gaps_simd(const Obb8& boxes, const Box_map& map, const Obb8& from, int lane, float apex,
                                         Certified_gaps& gaps)
{
  constexpr Float_tag tag;
  const float size = (from.extent[0][lane] + from.extent[1][lane] + from.extent[2][lane]) * map.stretch() * rounded_up;
  Single_box box = carried(boxes, map, from, lane, size);
  box.apex = apex;
  const float slack = gap_slack(box, boxes.reach, size);
  const bool is_bounded = map.is_similarity() && slack <= most_gap_slack;
  for (std::size_t first = 0; first < lanes; first += hn::Lanes(tag)) {
    if (is_bounded)
      certify_gaps(One_test{boxes, box, first}, slack, gaps);
    else
      hn::Store(hn::Zero(tag), tag, gaps.gap + first);
  }
}

/// Returns the centre's image in double, from coordinate k on.
HWY_INLINE auto centre_image(const Carrier& carrier, const float (&centre)[3], std::size_t k)
{
  constexpr hn::CappedTag<double, 4> doubles;
  const auto column = [&](int j) HWY_ATTR { return hn::Load(doubles, carrier.map->column(j) + k); };
  const auto term = [&](int j) HWY_ATTR { return Mul(column(j), hn::Set(doubles, double(centre[j]))); };
  return hn::Add(hn::Add(hn::Add(column(3), term(0)), term(1)), term(2));
}

/// Returns the image of p by these columns, from coordinate k on.
HWY_INLINE auto image_by(const float (*column)[4], const float (&p)[3], std::size_t k)
{
  constexpr hn::CappedTag<float, 4> four;
  const auto load = [&](int j) HWY_ATTR { return hn::Load(four, column[j] + k); };
  return MulAdd(load(2), hn::Set(four, p[2]), MulAdd(load(1), hn::Set(four, p[1]), Mul(load(0), hn::Set(four, p[0]))));
}

HWY_INLINE void carry_now(const Carrier& carrier, const Obb8& from, int lane, Carried_box& box)
{
  constexpr hn::CappedTag<double, 4> doubles;
  constexpr hn::CappedTag<float, 4> four;
  float size = 0;
  for (int k = 0; k < 3; ++k) {
    box.centre[k] = from.origin[k] + from.centre[k][lane];
    const float extent = from.extent[k][lane];
    for (int i = 0; i < 3; ++i) box.half_edge[k][i] = from.axis[k][i][lane] * extent;
    size += extent;
  }
  for (std::size_t k = 0; k < 4; k += hn::Lanes(doubles))
    hn::Store(centre_image(carrier, box.centre, k), doubles, box.image + k);
  for (std::size_t k = 0; k < 4; k += hn::Lanes(four))
    for (int j = 0; j < 3; ++j) hn::Store(image_by(carrier.column, box.half_edge[j], k), four, box.edge[j] + k);
  const double rounding = Carried_box::edge_rounding * double(size * rounded_up) + Carried_box::centre_rounding;
  box.rounding = float(rounding) * rounded_up;
  box.error = float(carrier.error + carrier.scale * rounding) * rounded_up;
}

inline HWY_ATTR void carry_now_simd(const Carrier& carrier, const Obb8& from, int lane, Carried_box& box)
{
  carry_now(carrier, from, lane, box);
}

HWY_INLINE Gap_and_rate least_gap_after(const Certified_gaps& gaps, unsigned of_lanes, const Carried_box& box,
                                        const Going_box& going, const Carrier& carrier)
{
  constexpr Float_tag tag;
  constexpr hn::CappedTag<double, 4> doubles;
  constexpr hn::CappedTag<float, 4> four;
  constexpr hn::Rebind<float, decltype(doubles)> narrow;
  alignas(16) float way[4], on[4], turn[3][4], bend[3][4];
  alignas(32) double far[4];
  for (std::size_t k = 0; k < 4; k += hn::Lanes(doubles)) {
    const auto moved = Sub(centre_image(carrier, box.centre, k), hn::Load(doubles, box.image + k));
    hn::Store(Abs(moved), doubles, far + k);
    hn::StoreU(hn::DemoteTo(narrow, moved), narrow, way + k);
  }
  for (std::size_t k = 0; k < 4; k += hn::Lanes(four)) {
    const auto& course = carrier.course.column;
    for (int j = 0; j < 3; ++j) {
      hn::Store(Sub(image_by(carrier.column, box.half_edge[j], k), hn::Load(four, box.edge[j] + k)), four, turn[j] + k);
      hn::Store(image_by(course, going.half_edge[j], k), four, bend[j] + k);
    }
    hn::Store(Add(hn::Load(four, course[3] + k), image_by(course, going.centre, k)), four, on + k);
  }
  const double loss = Carried_box::way_rounding * (far[0] + far[1] + far[2]) +
                      ((double(box.error) + carrier.error) + double(box.rounding) * carrier.scale);
  const float lost = float(loss) * rounded_up + box_underflow;
  auto least = hn::Set(tag, most_gap_slack), share = hn::Zero(tag);
  for (std::size_t first = 0; first < lanes; first += hn::Lanes(tag)) {
    const auto load = [&](const float* lane) HWY_ATTR { return hn::Load(tag, lane + first); };
    const auto all = [&](float x) HWY_ATTR { return hn::Set(tag, x); };
    const One_test::Floats n[3] = {load(gaps.axis[0]), load(gaps.axis[1]), load(gaps.axis[2])};
    const auto along = [&](const float* v) HWY_ATTR {
      const One_test::Floats by[3] = {all(v[0]), all(v[1]), all(v[2])};
      return along_axis(n, by);
    };
    const auto across = [&](const float(&v)[3][4])
                            HWY_ATTR { return Add(Add(Abs(along(v[0])), Abs(along(v[1]))), Abs(along(v[2]))); };
    const auto gap = Sub(Mul(Sub(Add(load(gaps.gap), along(way)), across(turn)), all(gap_shrink)), all(lost));
    const auto rate = Add(Sub(across(bend), along(on)), all(carrier.slack));
    const std::uint8_t some[8] = {std::uint8_t(of_lanes >> first)};
    const auto is_one = hn::LoadMaskBits(tag, some);
    least = hn::Min(least, hn::IfThenElse(is_one, gap, all(most_gap_slack)));
    share = Max(share, hn::IfThenElseZero(is_one, hn::Div(rate, gap)));
  }
  // A vector's minimum may have dropped an undefined value.
  if (!(loss <= most_gap_slack && carrier.slack <= most_gap_slack)) return {0, 0};
  const double found = double(hn::GetLane(hn::MinOfLanes(tag, least)));
  return {found, found * double(hn::GetLane(hn::MaxOfLanes(tag, share))) * (1 + 0x1p-20)};
}

inline HWY_ATTR Gap_and_rate least_gap_after_simd(const Certified_gaps& gaps, unsigned of_lanes, const Carried_box& box,
                                                  const Going_box& going, const Carrier& carrier)
{
  return least_gap_after(gaps, of_lanes, box, going, carrier);
}

}  // namespace tetracone::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// Included again for the next target.
#undef TETRACONE_KERNEL_BOUND_OBB8_GAP_SIMD_INL
#endif
