#ifndef TETRACONE_KERNEL_BOUND_OBB8_DISTANCE_SIMD_INL
#define TETRACONE_KERNEL_BOUND_OBB8_DISTANCE_SIMD_INL
// Included by kernel/bound/obb8_distance.h, once for each target.
#ifndef TETRACONE_SIMD_FILE
#undef TETRACONE_KERNEL_BOUND_OBB8_DISTANCE_SIMD_INL  // that header includes this one, again and again
#include "tetracone/kernel/bound/obb8_distance.h"
#else

HWY_BEFORE_NAMESPACE();
namespace tetracone::kernel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// The errors of lower bounds are proved from these functions, run over other numbers than vectors
// (verify/proofs/obb8_distance_proofs.h).

/// Returns the distance of the centres along an axis of a frame, less an extent.
template <class Floats>
HWY_INLINE Floats room_along(const Floats& t, const Floats& e, const Floats& slack)
{
  return Sub(Sub(Abs(t), e), slack);
}

/// Returns `room` less the support of the other box, which has extents `f` and edges with components r along the axis.
template <class Floats>
HWY_INLINE Floats gap_of_room(const Floats& room, const Floats (&f)[3], const Floats (&r)[3])
{
  return NegMulAdd(f[2], Abs(r[2]), NegMulAdd(f[1], Abs(r[1]), NegMulAdd(f[0], Abs(r[0]), room)));
}

/// Returns the gap along a vector of components +-g_i along a frame's axes, times its length. Along it the other box
/// has a smaller support than the axis-parallel box about it.
template <class Floats>
HWY_INLINE Floats gap_of_way(const Floats (&g)[3], const Floats (&room)[3], const Floats (&way)[3],
                             const Floats (&f)[3], const Floats (&r)[3][3])
{
  Floats gap = MulAdd(g[2], room[2], MulAdd(g[1], room[1], Mul(g[0], room[0])));
  for (int j = 0; j < 3; ++j)
    gap = NegMulAdd(f[j], Abs(MulAdd(way[2], r[2][j], MulAdd(way[1], r[1][j], Mul(way[0], r[0][j])))), gap);
  return gap;
}

/// Returns a lower bound of the squared distance of a box from another, in the frame of its axes i. `t` leads from
/// centre to centre, `e` are the extents. The other box has edges j of extents `f` with components r[i][j].
///
/// The first bound is by the axis-parallel box about the other one: g_i = |t_i| - e_i - sum_j f_j |r_ij|, 0 where that
/// is negative. The second is the gap along this vector, over its length.
template <class Floats>
HWY_INLINE Floats squared_way(const Floats (&t)[3], const Floats (&e)[3], const Floats (&f)[3], const Floats (&r)[3][3],
                              Floats slack)
{
  const Floats zero = Sub(slack, slack);
  Floats room[3], g[3], way[3];
  for (int i = 0; i < 3; ++i) {
    room[i] = room_along(t[i], e[i], slack);
    g[i] = Max(gap_of_room(room[i], f, r[i]), zero);
    way[i] = hn::CopySign(g[i], t[i]);
  }
  const Floats square = MulAdd(g[2], g[2], MulAdd(g[1], g[1], Mul(g[0], g[0])));
  const Floats gap = gap_of_way(g, room, way, f, r);
  // Used where neither is near underflow.
  const Floats numerator = Mul(gap, Max(gap, zero));
  const auto is_sound = hn::Ge(hn::Min(numerator, square), hn::Set(hn::DFromV<Floats>(), 0x1p-100f));
  return Max(hn::IfThenElseZero(is_sound, hn::Div(numerator, square)), square);
}

/// Components along the axes i of the eight and, for a similarity, along the edges j of the single box.
template <class Floats>
struct Ways_in_frames {
  Floats t[3], r[3][3];  ///< t from centre to centre, r of the edges
  Floats s[3];           ///< t along the edges
};
template <bool similarity, class Test>
HWY_INLINE auto ways_in_frames(const Test& test)
{
  using Floats = typename Test::Floats;
  const auto& boxes = test.boxes;
  const auto& box = test.box;
  const Floats x = Sub(test.all(box.centre[0]), test.load(boxes.centre[0])),
               y = Sub(test.all(box.centre[1]), test.load(boxes.centre[1])),
               z = Sub(test.all(box.centre[2]), test.load(boxes.centre[2]));
  Ways_in_frames<Floats> ways;
  for (int i = 0; i < 3; ++i) {
    const Floats a0 = test.load(boxes.axis[i][0]), a1 = test.load(boxes.axis[i][1]), a2 = test.load(boxes.axis[i][2]);
    ways.t[i] = MulAdd(a2, z, MulAdd(a1, y, Mul(a0, x)));
    for (int j = 0; j < 3; ++j) {
      const auto& edge = box.edge[j];
      ways.r[i][j] = MulAdd(a2, test.all(edge[2]), MulAdd(a1, test.all(edge[1]), Mul(a0, test.all(edge[0]))));
    }
  }
  if constexpr (similarity)
    for (int j = 0; j < 3; ++j) {
      const auto& edge = box.edge[j];
      ways.s[j] = MulAdd(z, test.all(edge[2]), MulAdd(y, test.all(edge[1]), Mul(x, test.all(edge[0]))));
    }
  return ways;
}

/// Returns lower bounds of the squared distances of the test's lanes, up to the axes' defect. A lane is undefined where
/// its numbers are.
template <bool similarity, class Test>
HWY_INLINE auto squared_gaps(const Test& test, const typename Test::Floats slack)
{
  using Floats = typename Test::Floats;
  const auto& boxes = test.boxes;
  const auto& box = test.box;
  const auto ways = ways_in_frames<similarity>(test);
  const Floats e[3] = {test.load(boxes.extent[0]), test.load(boxes.extent[1]), test.load(boxes.extent[2])};
  const Floats f[3] = {test.all(box.extent[0]), test.all(box.extent[1]), test.all(box.extent[2])};
  const Floats own = squared_way(ways.t, e, f, ways.r, slack);
  if constexpr (!similarity) return own;
  const auto& r = ways.r;
  const Floats turned[3][3] = {{r[0][0], r[1][0], r[2][0]}, {r[0][1], r[1][1], r[2][1]}, {r[0][2], r[1][2], r[2][2]}};
  return Max(own, squared_way(ways.s, f, e, turned, slack));
}

/// Stores the gaps of the test's lanes, with the single box already carried.
template <bool similarity>
HWY_INLINE void store_gaps(Gap_test& test, const Single_box& box, float slack)
{
  const Float_tag tag;
  const auto all = [&](float value) HWY_ATTR { return hn::Set(tag, value); };
  const Obb8& boxes = *test.boxes;
  const Gap_question& question = test.question;
  unsigned nearer = 0;
  for (std::size_t first = 0; first < lanes; first += hn::Lanes(tag)) {
    const auto load = [&](const float* lane) HWY_ATTR { return hn::Load(tag, lane + first); };
    const auto square = squared_gaps<similarity>(One_test{boxes, box, first}, all(slack));
    // An infinite or undefined value is no bound.
    const auto is_known = hn::Lt(square, all(0x1p120f));
    const auto low =
        Max(Mul(hn::Sqrt(hn::IfThenElseZero(is_known, square)), all(question.stretch)), all(question.known));
    const auto sum = hn::Add(load(boxes.extent[0]), hn::Add(load(boxes.extent[1]), load(boxes.extent[2])));
    const auto x = Sub(all(box.centre[0]), load(boxes.centre[0])), y = Sub(all(box.centre[1]), load(boxes.centre[1])),
               z = Sub(all(box.centre[2]), load(boxes.centre[2]));
    hn::Store(low, tag, test.gaps.low.data() + first);
    hn::Store(Max(Mul(sum, all(question.size)), all(std::numeric_limits<float>::min())), tag,
              test.gaps.size.data() + first);
    const auto between = MulAdd(z, z, MulAdd(y, y, Mul(x, x)));
    hn::Store(Mul(between, all(question.stretch * question.stretch)), tag, test.gaps.between.data() + first);
    std::uint8_t bits[8];
    hn::StoreMaskBits(tag, hn::Le(low, all(question.limit)), bits);
    nearer |= unsigned(bits[0]) << first;
  }
  test.nearer = nearer & ((1u << boxes.lane_count) - 1);
}

inline HWY_ATTR void find_gaps_simd(Gap_test* tests, std::size_t count)
{
  Single_box box[most_gap_tests];
  float slack[most_gap_tests];
  for (std::size_t k = 0; k < count; ++k) {
    const Obb8 &boxes = *tests[k].boxes, &from = *tests[k].from;
    const Box_map& map = *tests[k].map;
    const int lane = tests[k].lane;
    float size = (from.extent[0][lane] + from.extent[1][lane] + from.extent[2][lane]) * map.stretch();
    if (map.is_similarity()) {
      carry(boxes, map, from, lane, size, box[k]);
    } else {
      box[k] = map(boxes, from, lane);
      size = box[k].extent[0] + box[k].extent[1] + box[k].extent[2];
    }
    const float way = std::abs(box[k].centre[0]) + std::abs(box[k].centre[1]) + std::abs(box[k].centre[2]);
    // Both slacks include the position's error.
    slack[k] = float(distance_rounding) * (way + boxes.reach + size) * (1 + 0x1p-20f) + box[k].slack;
  }
  for (std::size_t k = 0; k < count; ++k) {
    if (tests[k].map->is_similarity())
      store_gaps<true>(tests[k], box[k], slack[k]);
    else
      store_gaps<false>(tests[k], box[k], slack[k]);
  }
}

}  // namespace tetracone::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// Included again for the next target.
#undef TETRACONE_KERNEL_BOUND_OBB8_DISTANCE_SIMD_INL
#endif
