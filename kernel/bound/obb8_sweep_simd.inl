#ifndef TETRACONE_KERNEL_BOUND_OBB8_SWEEP_SIMD_INL
#define TETRACONE_KERNEL_BOUND_OBB8_SWEEP_SIMD_INL
// Included by kernel/bound/obb8_sweep.h, once for each target.
#ifndef TETRACONE_SIMD_FILE
#undef TETRACONE_KERNEL_BOUND_OBB8_SWEEP_SIMD_INL  // that header includes this one, again and again
#include "tetracone/kernel/bound/obb8_sweep.h"
#else

HWY_BEFORE_NAMESPACE();
namespace tetracone::kernel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// The error of the motion along an axis is proved from this function and `along_axis`, run over other numbers than
// vectors (verify/proofs/gap_proofs.h).

/// Returns a . (shift - bend centre) for an axis a of the eight.
template <class Floats>
HWY_INLINE Floats sweep_along(const Floats (&a)[3], const Floats (&centre)[3], const Floats (&shift)[3],
                              const Floats (&bend)[3][3])
{
  const auto way = [&](int k) HWY_ATTR {
    return NegMulAdd(centre[2], bend[k][2],
                     NegMulAdd(centre[1], bend[k][1], NegMulAdd(centre[0], bend[k][0], shift[k])));
  };
  const Floats moved[3] = {way(0), way(1), way(2)};
  return along_axis(a, moved);
}

/// The times at which boxes may meet, from -`minus_from` to `until`. They run from -1 to 1 over the span.
template <class Floats>
struct Times_near {
  Floats minus_from, until;
};

/// Returns the times that are left by two axes together.
template <class Floats>
HWY_INLINE Times_near<Floats> Max(const Times_near<Floats>& a, const Times_near<Floats>& b)
{
  return {hn::Min(a.minus_from, b.minus_from), hn::Min(a.until, b.until)};
}

/// The motion along an axis.
struct Swept {
  using Floats = One_test::Floats;
  Floats sweep[3];  ///< along the eight's axes
  Floats lost;      ///< the loss of a gap

  HWY_INLINE Floats along(Floats n0, Floats n1, Floats n2) const
  {
    const Floats n[3] = {n0, n1, n2};
    return along_axis(n, sweep);
  }
  static HWY_INLINE Floats time_of_one(Floats speed)
  {
    return hn::Div(hn::Set(One_test::tag, 1.f), Max(Abs(speed), hn::Set(One_test::tag, least_speed)));
  }

  /// Returns the times that an axis leaves. The boxes are apart where the distance s + x v, of either sign, is beyond
  /// the sum r of the supports. For v > 0 that is up to -(r + s) / v, and from (r - s) / v on.
  HWY_INLINE Times_near<Floats> operator()(Floats gap, Floats distance, Floats n0, Floats n1, Floats n2) const
  {
    const Floats speed = along(n0, n1, n2), ahead = hn::Xor(distance, hn::And(speed, hn::SignBit(One_test::tag))),
                 reach = Add(Sub(Abs(distance), gap), lost), time = time_of_one(speed);
    return {Mul(Add(reach, ahead), time), Mul(Sub(reach, ahead), time)};
  }
};

/// The motion along an axis that separates boxes on one side of it only.
struct Swept_beyond {
  using Floats = One_test::Floats;
  const Swept& swept;

  HWY_INLINE Times_near<Floats> operator()(Floats gap, Floats, Floats n0, Floats n1, Floats n2) const
  {
    const Floats speed = swept.along(n0, n1, n2), far = hn::Inf(One_test::tag);
    const Floats time = Mul(Sub(swept.lost, gap), Swept::time_of_one(speed));
    const auto comes = hn::Lt(speed, hn::Zero(One_test::tag));
    return {hn::IfThenElse(comes, time, far), hn::IfThenElse(comes, far, time)};
  }
};

/// The single box of a test, and the losses of gaps.
struct Swept_box {
  Single_box box;  ///< in the middle of the span
  float way[4];    ///< the motion of its centre relative to the eight's origin, in half the span
  float slack;
  float loss, turn;  ///< the loss of gaps, and its part per unit of a lane's radius
};

/// Returns the lanes of `by` that are near, and writes the times.
HWY_INLINE unsigned near_in_sweep(const One_test& by, const Swept_box& single, Sweep_test& test)
{
  using Floats = One_test::Floats;
  const auto all = [&](float x) HWY_ATTR { return by.all(x); };
  const Floats e0 = by.load(by.boxes.extent[0]), e1 = by.load(by.boxes.extent[1]), e2 = by.load(by.boxes.extent[2]),
               radius = hn::Sqrt(MulAdd(e2, e2, MulAdd(e1, e1, Mul(e0, e0))));
  Floats centre[3], shift[3], bend[3][3];
  for (int k = 0; k < 3; ++k) {
    centre[k] = by.load(by.boxes.centre[k]);
    shift[k] = all(single.way[k]);
    for (int j = 0; j < 3; ++j) bend[k][j] = all(test.sweep->half.rounded_eight[j][k]);
  }
  Swept swept;
  swept.lost = MulAdd(radius, all(single.turn), all(slacks_of_sweep * single.slack + single.loss));
  for (int i = 0; i < 3; ++i) {
    const Floats axis[3] = {by.load(by.boxes.axis[i][0]), by.load(by.boxes.axis[i][1]), by.load(by.boxes.axis[i][2])};
    swept.sweep[i] = sweep_along(axis, centre, shift, bend);
  }
  const Floats half = all(0.5f), earlier = all(0.5f - time_rounding), later = all(0.5f + time_rounding);
  const unsigned held = ((1u << by.boxes.lane_count) - 1) >> by.first;
  Floats from, until;
  const auto lanes_near = [&](const Times_near<Floats>& near) HWY_ATTR {
    // A vector's maximum may drop an undefined value, so the known bound comes second.
    from = Max(NegMulAdd(half, near.minus_from, earlier), all(test.known.from));
    until = hn::Min(MulAdd(half, near.until, later), all(test.known.until));
    std::uint8_t bits[8];
    hn::StoreMaskBits(One_test::tag, Not(Gt(from, until)), bits);
    return bits[0] & held;
  };
  const auto largest =
      largest_gap<true>(by, swept, [&](const Times_near<Floats>& near) HWY_ATTR { return lanes_near(near) == 0; });
  unsigned lanes = lanes_near(largest.kept);
  if (lanes != 0 && by.holds_triangle()) {
    const auto sides = beyond_triangle(by, largest.edges, e0, e1, e2);
    const float slack_of_sides = side_slack(by.box, single.slack);
    const auto side = [&](Floats beyond, float length, const Floats(&n)[3])
                          HWY_ATTR { return gap_beyond(Swept_beyond{swept}, by, beyond, length, n, slack_of_sides); };
    lanes = lanes_near(Max(largest.kept, Max(side(sides.left, sides.left_length, sides.left_normal),
                                             side(sides.right, sides.right_length, sides.right_normal))));
  }
  hn::Store(from, One_test::tag, test.times.from + by.first);
  hn::Store(until, One_test::tag, test.times.until + by.first);
  return lanes << by.first;
}

/// Writes the value of `way` for the origin of the eight and the centre of box `lane` of `from`.
HWY_INLINE void way_between(const Point_way& way, const Obb8& from, int lane, const Obb8& boxes, float* found)
{
  constexpr hn::CappedTag<double, 4> doubles;
  constexpr hn::Rebind<float, decltype(doubles)> narrow;
  for (std::size_t k = 0; k < 4; k += hn::Lanes(doubles)) {
    auto sum = hn::Load(doubles, way.offset + k);
    for (int j = 0; j < 3; ++j) {
      const double centre = double(from.origin[j]) + double(from.centre[j][lane]);
      sum = MulAdd(hn::Load(doubles, way.single[j] + k), hn::Set(doubles, centre), sum);
      sum = NegMulAdd(hn::Load(doubles, way.eight[j] + k), hn::Set(doubles, double(boxes.origin[j])), sum);
    }
    hn::StoreU(hn::DemoteTo(narrow, sum), narrow, found + k);
  }
}

/// Computes the single box of a test. Returns false where nothing is bounded.
HWY_INLINE bool find_single_box(const Sweep_test& test, Swept_box& single)
{
  const Obb8 &boxes = *test.boxes, &from = *test.from;
  const Box_map& map = *test.map;
  const Box_sweep& sweep = *test.sweep;
  const int lane = test.lane;
  const float size = (from.extent[0][lane] + from.extent[1][lane] + from.extent[2][lane]) * map.stretch() * rounded_up,
              farthest = test.known.farthest();
  Single_box& box = single.box;
  carry(boxes, map, from, lane, size, box);
  box.apex = test.apex;
  // The box's place in the middle of the span, for points at the origin of the eight. For other points it differs by at
  // most their distance from it.
  float moved[4];
  way_between(sweep.middle, from, lane, boxes, moved);
  way_between(sweep.half, from, lane, boxes, single.way);
  for (int i = 0; i < 3; ++i) box.centre[i] += moved[i];
  const double lost =
      sweep.rest + sweep_rounding * (sweep.middle.size + sweep.half.size) +
      sweep.middle.norm_of_eight * double(boxes.reach) +
      (sweep.middle.norm_of_single + double(farthest) * sweep.half.norm_of_single) * double(radius_of(from, lane));
  single.slack = gap_slack(box, boxes.reach, size);
  single.loss = float(lost) * (1 + radius_rounding) + box_underflow;
  single.turn = farthest * float(sweep.half.norm_of_eight) * (1 + radius_rounding);
  return map.is_similarity() && single.slack + single.loss + single.turn <= most_gap_slack;
}

inline HWY_ATTR void find_near_simd(Sweep_test* tests, std::size_t count)
{
  Swept_box single[most_sweep_tests];
  bool is_bounded[most_sweep_tests];
  for (std::size_t k = 0; k < count; ++k) is_bounded[k] = find_single_box(tests[k], single[k]);
  for (std::size_t k = 0; k < count; ++k) {
    Sweep_test& test = tests[k];
    test.near = is_bounded[k] ? 0 : (1u << test.boxes->lane_count) - 1;
    for (std::size_t first = 0; first < lanes; first += hn::Lanes(Float_tag()))
      if (is_bounded[k]) {
        test.near |= near_in_sweep(One_test{*test.boxes, single[k].box, first}, single[k], test);
      } else {
        hn::Store(hn::Set(Float_tag(), test.known.from), Float_tag(), test.times.from + first);
        hn::Store(hn::Set(Float_tag(), test.known.until), Float_tag(), test.times.until + first);
      }
  }
}

}  // namespace tetracone::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// Included again for the next target.
#undef TETRACONE_KERNEL_BOUND_OBB8_SWEEP_SIMD_INL
#endif
