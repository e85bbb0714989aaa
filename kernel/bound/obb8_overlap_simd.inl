#ifndef TETRACONE_KERNEL_BOUND_OBB8_OVERLAP_SIMD_INL
#define TETRACONE_KERNEL_BOUND_OBB8_OVERLAP_SIMD_INL
// Included by kernel/bound/obb8_overlap.h, once for each target.
#ifndef TETRACONE_SIMD_FILE
#undef TETRACONE_KERNEL_BOUND_OBB8_OVERLAP_SIMD_INL  // that header includes this one, again and again
#include "tetracone/kernel/bound/obb8_overlap.h"
#else

HWY_BEFORE_NAMESPACE();
namespace tetracone::kernel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// The comparison uses these operations alone, so that it also runs over other numbers than vectors. Its error is proved
// that way (verify/proofs/obb8_proofs.h).
using hn::Abs, hn::Add, hn::Gt, hn::Max, hn::Mul, hn::MulAdd, hn::Neg, hn::NegMulAdd, hn::Not, hn::Or, hn::Sub;

/// As many of the eight lanes as the instruction set compares at once.
using Float_tag = hn::CappedTag<float, lanes>;

/// A single box against the lanes of boxes from `first` on.
struct One_test {
  static constexpr Float_tag tag{};
  using Floats = hn::Vec<Float_tag>;
  const Obb8& boxes;
  const Single_box& box;
  std::size_t first = 0;

  HWY_INLINE Floats load(const float* lane) const { return hn::Load(tag, lane + first); }
  HWY_INLINE Floats all(const float& x) const { return hn::Set(tag, x); }

  /// True when the single box holds a triangle to which it can be cut down. Below that width, products underflow.
  HWY_INLINE bool holds_triangle() const { return box.apex != no_apex && box.extent[2] > 0x1p-41f; }
};

/// Components along the axes 0, 1, 2 of the eight: t from their centres to the single box's, and its edges 1 and 2.
template <class Floats>
struct Relative_edges {
  Floats t0, t1, t2;
  Floats r01, r11, r21;  ///< edge 1
  Floats r02, r12, r22;  ///< edge 2
};

/// The distances of lanes beyond the triangle's two edges at its apex, along these edges' outward normals.
/// `left_length` and `right_length` are upper bounds of the normals' lengths: sums of coordinates along the single
/// box's edges. `left_normal` and `right_normal` are the opposite vectors, which lead from the lanes to the triangle.
template <class Floats, class Number>
struct Beyond_triangle {
  Floats left, right;
  Number left_length, right_length;
  Floats left_normal[3], right_normal[3];  ///< along the eight's axes
};

/// Returns the distances of the lanes' boxes, which have the extents e0, e1 and e2. The outward normals are (-base,
/// left) and (base, right) along the single box's edges 1 and 2. They are no unit vectors.
template <class Test, class Floats>
HWY_INLINE auto beyond_triangle(const Test& test, const Relative_edges<Floats>& of, Floats e0, Floats e1, Floats e2)
{
  const auto& box = test.box;
  using Number = std::decay_t<decltype(box.slack)>;
  const Number length = box.extent[1], width = box.extent[2], base = Number(2) * width,
               left = length * (Number(1) + box.apex), right = length * (Number(1) - box.apex);
  const auto number = [&](const Number& value) HWY_ATTR { return test.all(value); };
  const Floats d1 = Mul(number(base), MulAdd(of.t2, of.r21, MulAdd(of.t1, of.r11, Mul(of.t0, of.r01)))),
               d2 = MulAdd(of.t2, of.r22, MulAdd(of.t1, of.r12, Mul(of.t0, of.r02)));
  const Floats b0 = Mul(number(base), of.r01), b1 = Mul(number(base), of.r11), b2 = Mul(number(base), of.r21);
  const auto beyond = [&](Floats distance, const Number& reach, const Floats(&n)[3]) HWY_ATTR {
    return NegMulAdd(e2, Abs(n[2]), NegMulAdd(e1, Abs(n[1]), NegMulAdd(e0, Abs(n[0]), Sub(distance, number(reach)))));
  };
  // t leads from the eight to the single box: their centres are at (-d1, -d2) / (base, 1).
  const Floats l = number(left), r = number(right);
  const Floats of_left[3] = {NegMulAdd(l, of.r02, b0), NegMulAdd(l, of.r12, b1), NegMulAdd(l, of.r22, b2)},
               of_right[3] = {MulAdd(r, of.r02, b0), MulAdd(r, of.r12, b1), MulAdd(r, of.r22, b2)};
  return Beyond_triangle<Floats, Number>{beyond(NegMulAdd(l, d2, d1), width * right, of_left),
                                         beyond(NegMulAdd(r, d2, Neg(d1)), width * left, of_right),
                                         base + left,
                                         base + right,
                                         {of_left[0], of_left[1], of_left[2]},
                                         {Neg(of_right[0]), Neg(of_right[1]), Neg(of_right[2])}};
}

/// Returns the slack along a triangle's sides, relative to their normals' lengths. It is twice the slack along other
/// axes, for two more roundings a term. The apex's tolerance is added twice, for the roundings of the extents.
template <class Box, class Number>
HWY_INLINE Number side_slack(const Box& box, const Number& slack)
{
  return Number(2) * slack + Number(2 * apex_tolerance) * (box.extent[1] + box.extent[2]);
}

/// Returns the lanes whose box, with extents e0, e1 and e2, lies beyond one of the triangle's two edges at its apex.
template <class Test, class Floats>
HWY_INLINE auto beside_triangle(const Test& test, const Relative_edges<Floats>& of, Floats e0, Floats e1, Floats e2)
{
  const auto sides = beyond_triangle(test, of, e0, e1, e2);
  const auto slack = side_slack(test.box, test.box.slack);
  return Or(Gt(sides.left, test.all(slack * sides.left_length)), Gt(sides.right, test.all(slack * sides.right_length)));
}

/// A policy of `largest_gap` that keeps the gap alone. Its other arguments are the distance of the centres along the
/// axis, and the axis' components n along the eight's axes.
struct Gap_alone {
  template <class Floats>
  HWY_INLINE Floats operator()(Floats gap, Floats, Floats, Floats, Floats) const
  {
    return gap;
  }
};

/// The kept part of the largest gap, and the edges for the comparison with a triangle.
template <class Kept, class Floats>
struct Largest_gap {
  Kept kept;
  Relative_edges<Floats> edges;
};

/// Computes the components along axis i of the eight: t of the vector (x, y, z) between centres, and r of the single
/// box's edges.
template <class Test, class Floats>
HWY_INLINE void along_own_axis(const Test& test, int i, Floats x, Floats y, Floats z, Floats& t, Floats& r0, Floats& r1,
                               Floats& r2)
{
  const Floats a0 = test.load(test.boxes.axis[i][0]), a1 = test.load(test.boxes.axis[i][1]),
               a2 = test.load(test.boxes.axis[i][2]);
  const auto dot = [&](const auto& v) HWY_ATTR {
    return MulAdd(a2, test.all(v[2]), MulAdd(a1, test.all(v[1]), Mul(a0, test.all(v[0]))));
  };
  t = MulAdd(a2, z, MulAdd(a1, y, Mul(a0, x)));
  r0 = dot(test.box.edge[0]);
  r1 = dot(test.box.edge[1]);
  r2 = dot(test.box.edge[2]);
}

/// A policy for comparisons along all axes.
struct Undecided {
  template <class What>
  HWY_INLINE bool operator()(const What&) const
  {
    return false;
  }
};

/// Returns the kept part of the largest gap of the single box and each lane. The separating axes are the normals of
/// both and the 9 cross products of edges. A gap is |distance| minus the supports of both. Where `decides` is true of
/// the normals, no other axes are tried.
template <bool similarity, class Test, class Kept, class Decides = Undecided>
HWY_INLINE auto largest_gap(const Test& test, const Kept& kept, const Decides& decides = Decides())
{
  using Floats = typename Test::Floats;
  const auto& boxes = test.boxes;
  const auto& box = test.box;
  using Number = std::decay_t<decltype(box.slack)>;
  const auto load = [&](const auto& lane) HWY_ATTR { return test.load(lane); };
  const auto all = [&](const Number& x) HWY_ATTR { return test.all(x); };

  const Floats x = Sub(all(box.centre[0]), load(boxes.centre[0])), y = Sub(all(box.centre[1]), load(boxes.centre[1])),
               z = Sub(all(box.centre[2]), load(boxes.centre[2]));
  const Floats e0 = load(boxes.extent[0]), e1 = load(boxes.extent[1]), e2 = load(boxes.extent[2]);
  const Floats f0 = all(box.extent[0]), f1 = all(box.extent[1]), f2 = all(box.extent[2]);
  Floats t0, t1, t2, r00, r01, r02, r10, r11, r12, r20, r21, r22;
  along_own_axis(test, 0, x, y, z, t0, r00, r01, r02);
  along_own_axis(test, 1, x, y, z, t1, r10, r11, r12);
  along_own_axis(test, 2, x, y, z, t2, r20, r21, r22);
  const Floats s00 = Abs(r00), s01 = Abs(r01), s02 = Abs(r02), s10 = Abs(r10), s11 = Abs(r11), s12 = Abs(r12),
               s20 = Abs(r20), s21 = Abs(r21), s22 = Abs(r22);

  // The normals of the eight.
  const auto own = [&](Floats t, Floats e, Floats s0, Floats s1, Floats s2)
                       HWY_ATTR { return NegMulAdd(f2, s2, NegMulAdd(f1, s1, NegMulAdd(f0, s0, Sub(Abs(t), e)))); };
  const Floats one = all(Number(1)), zero = all(Number(0));
  auto gap = Max(kept(own(t0, e0, s00, s01, s02), t0, one, zero, zero),
                 Max(kept(own(t1, e1, s10, s11, s12), t1, zero, one, zero),
                     kept(own(t2, e2, s20, s21, s22), t2, zero, zero, one)));

  // n_ij = a_i . normal_j, and its magnitude. For a similarity the normals are the edges themselves.
  Floats n00 = s00, n01 = s01, n02 = s02, n10 = s10, n11 = s11, n12 = s12, n20 = s20, n21 = s21, n22 = s22;
  const auto other = [&](Floats m0, Floats m1, Floats m2, Floats reach, Floats s0, Floats s1, Floats s2) HWY_ATTR {
    const Floats distance = MulAdd(t2, m2, MulAdd(t1, m1, Mul(t0, m0)));
    return kept(NegMulAdd(e2, s2, NegMulAdd(e1, s1, NegMulAdd(e0, s0, Sub(Abs(distance), reach)))), distance, m0, m1,
                m2);
  };
  if constexpr (similarity) {
    gap = Max(gap, Max(other(r00, r10, r20, f0, s00, s10, s20),
                       Max(other(r01, r11, r21, f1, s01, s11, s21), other(r02, r12, r22, f2, s02, s12, s22))));
  } else {
    const auto normals = [&](int j, Floats& n0, Floats& n1, Floats& n2) HWY_ATTR {
      const auto dot = [&](int i) HWY_ATTR {
        const auto& v = box.normal[j];
        return MulAdd(load(boxes.axis[i][2]), all(v[2]),
                      MulAdd(load(boxes.axis[i][1]), all(v[1]), Mul(load(boxes.axis[i][0]), all(v[0]))));
      };
      using std::abs;
      const Number height =
          box.edge[j][0] * box.normal[j][0] + box.edge[j][1] * box.normal[j][1] + box.edge[j][2] * box.normal[j][2];
      const Floats m0 = dot(0), m1 = dot(1), m2 = dot(2);
      n0 = Abs(m0);
      n1 = Abs(m1);
      n2 = Abs(m2);
      gap = Max(gap, other(m0, m1, m2, all(box.extent[j] * abs(height)), n0, n1, n2));
    };
    normals(0, n00, n10, n20);
    normals(1, n01, n11, n21);
    normals(2, n02, n12, n22);
  }

  using Largest = Largest_gap<std::decay_t<decltype(gap)>, Floats>;
  if (decides(gap)) return Largest{gap, {t0, t1, t2, r01, r11, r21, r02, r12, r22}};

  // a_i x edge_j has the components 0, -r[m][j], r[l][j] along a_i, a_l, a_m. Edges k of the single box have the same
  // support along it as a_i has along the box's normals.
  const auto crossed = [&](Floats tm, Floats rl, Floats tl, Floats rm, Floats el, Floats sm, Floats em, Floats sl,
                           Floats fk, Floats no, Floats fo, Floats nk, Floats m0, Floats m1, Floats m2) HWY_ATTR {
    const Floats distance = NegMulAdd(tl, rm, Mul(tm, rl));
    return kept(NegMulAdd(fo, nk, NegMulAdd(fk, no, NegMulAdd(em, sl, NegMulAdd(el, sm, Abs(distance))))), distance, m0,
                m1, m2);
  };
  const auto across0 = Max(crossed(t2, r10, t1, r20, e1, s20, e2, s10, f1, n02, f2, n01, zero, Neg(r20), r10),
                           Max(crossed(t2, r11, t1, r21, e1, s21, e2, s11, f2, n00, f0, n02, zero, Neg(r21), r11),
                               crossed(t2, r12, t1, r22, e1, s22, e2, s12, f0, n01, f1, n00, zero, Neg(r22), r12)));
  const auto across1 = Max(crossed(t0, r20, t2, r00, e2, s00, e0, s20, f1, n12, f2, n11, r20, zero, Neg(r00)),
                           Max(crossed(t0, r21, t2, r01, e2, s01, e0, s21, f2, n10, f0, n12, r21, zero, Neg(r01)),
                               crossed(t0, r22, t2, r02, e2, s02, e0, s22, f0, n11, f1, n10, r22, zero, Neg(r02))));
  const auto across2 = Max(crossed(t1, r00, t0, r10, e0, s10, e1, s00, f1, n22, f2, n21, Neg(r10), r00, zero),
                           Max(crossed(t1, r01, t0, r11, e0, s11, e1, s01, f2, n20, f0, n22, Neg(r11), r01, zero),
                               crossed(t1, r02, t0, r12, e0, s12, e1, s02, f0, n21, f1, n20, Neg(r12), r02, zero)));
  return Largest{Max(Max(gap, across0), Max(across1, across2)), {t0, t1, t2, r01, r11, r21, r02, r12, r22}};
}

/// Returns the lanes whose box is not found apart from the single box. With an infinite slack that is every lane,
/// whatever overflowed. For a similarity, a single box that holds a triangle is cut down to it.
template <bool similarity, class Test>
HWY_INLINE auto together(const Test& test)
{
  const auto largest = largest_gap<similarity>(test, Gap_alone());
  const auto apart = Gt(largest.kept, test.all(test.box.slack));
  if constexpr (similarity) {
    if (test.holds_triangle())
      return Not(Or(apart, beside_triangle(test, largest.edges, test.load(test.boxes.extent[0]),
                                           test.load(test.boxes.extent[1]), test.load(test.boxes.extent[2]))));
  }
  return Not(apart);
}

/// Returns the lanes whose box may meet the single box.
template <bool similarity>
HWY_INLINE unsigned overlapping(const Obb8& boxes, const Single_box& box)
{
  unsigned found = 0;
  for (std::size_t first = 0; first < lanes; first += hn::Lanes(Float_tag())) {
    std::uint8_t bits[8];
    hn::StoreMaskBits(Float_tag(), together<similarity>(One_test{boxes, box, first}), bits);
    found |= unsigned(bits[0]) << first;
  }
  return found;
}

/// Returns the axis (a0, a1, a2) turned by the columns of a rotation.
template <class Floats>
HWY_INLINE Floats carried_edge(Floats c0, Floats c1, Floats c2, Floats a0, Floats a1, Floats a2)
{
  return MulAdd(c2, a2, MulAdd(c1, a1, Mul(c0, a0)));
}

/// Returns the image of the point (p0, p1, p2) by the columns of a map; the last is its offset.
template <class Doubles>
HWY_INLINE Doubles carried_point(Doubles c0, Doubles c1, Doubles c2, Doubles offset, Doubles p0, Doubles p1, Doubles p2)
{
  return MulAdd(c2, p2, MulAdd(c1, p1, MulAdd(c0, p0, offset)));
}

/// Writes box `lane` of `from`, carried into the frame of `boxes` by a similarity. `size` is an upper bound of the sum
/// of its extents there.
HWY_INLINE void carry(const Obb8& boxes, const Box_map& map, const Obb8& from, int lane, float size, Single_box& box)
{
  constexpr hn::CappedTag<float, 4> tag;
  constexpr hn::CappedTag<double, 4> doubles;
  for (std::size_t k = 0; k < 4; k += hn::Lanes(tag)) {
    const auto c0 = hn::Load(tag, map.direction(0) + k), c1 = hn::Load(tag, map.direction(1) + k),
               c2 = hn::Load(tag, map.direction(2) + k);
    for (int j = 0; j < 3; ++j) {
      const auto edge = carried_edge(c0, c1, c2, hn::Set(tag, from.axis[j][0][lane]),
                                     hn::Set(tag, from.axis[j][1][lane]), hn::Set(tag, from.axis[j][2][lane]));
      hn::Store(edge, tag, box.edge[j] + k);
    }
  }
  for (int j = 0; j < 3; ++j) box.extent[j] = from.extent[j][lane] * map.stretch();

  double centre[3];
  alignas(32) double at[4];
  for (int i = 0; i < 3; ++i) centre[i] = double(from.origin[i]) + double(from.centre[i][lane]);
  for (std::size_t k = 0; k < 4; k += hn::Lanes(doubles)) {
    const auto column = [&](int j) HWY_ATTR { return hn::Load(doubles, map.column(j) + k); };
    const auto all = [&](double x) HWY_ATTR { return hn::Set(doubles, x); };
    hn::Store(carried_point(column(0), column(1), column(2), column(3), all(centre[0]), all(centre[1]), all(centre[2])),
              doubles, at + k);
  }
  for (int i = 0; i < 3; ++i) box.centre[i] = float(at[i] - double(boxes.origin[i]));
  box.slack = map.slack(boxes.reach, size);
}
HWY_INLINE Single_box carried(const Obb8& boxes, const Box_map& map, const Obb8& from, int lane, float size)
{
  Single_box box;
  carry(boxes, map, from, lane, size, box);
  return box;
}

inline HWY_ATTR unsigned overlapping_simd(const Obb8& boxes, const Single_box& box, bool similarity)
{
  return similarity ? overlapping<true>(boxes, box) : overlapping<false>(boxes, box);
}

inline HWY_ATTR unsigned overlapping_mapped_simd(const Obb8& boxes, const Box_map& map, const Obb8& from, int lane)
{
  if (!map.is_similarity()) return overlapping<false>(boxes, map(boxes, from, lane));
  const float size = (from.extent[0][lane] + from.extent[1][lane] + from.extent[2][lane]) * map.stretch();
  return overlapping<true>(boxes, carried(boxes, map, from, lane, size * rounded_up));
}

}  // namespace tetracone::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// Included again for the next target.
#undef TETRACONE_KERNEL_BOUND_OBB8_OVERLAP_SIMD_INL
#endif
