#ifndef TETRACONE_KERNEL_PREDICATE_TRIANGLE_CONTACT8_SIMD_INL
#define TETRACONE_KERNEL_PREDICATE_TRIANGLE_CONTACT8_SIMD_INL
// Included by kernel/predicate/triangle_contact8.h, once for each target.
#ifndef TETRACONE_SIMD_FILE
#undef TETRACONE_KERNEL_PREDICATE_TRIANGLE_CONTACT8_SIMD_INL  // that header includes this one, again and again
#include "tetracone/kernel/predicate/triangle_contact8.h"
#else

HWY_BEFORE_NAMESPACE();
namespace tetracone::kernel::HWY_NAMESPACE {
namespace triangle_lanes {

namespace hn = hwy::HWY_NAMESPACE;
using hn::Abs, hn::Add, hn::And, hn::Gt, hn::IfThenElse, hn::Lt, hn::Max, hn::Min, hn::Mul, hn::Neg, hn::Not, hn::Or,
    hn::Sub, hn::Xor;

using Tag = hn::CappedTag<double, Triangles8::count>;
using Doubles = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;
using Code_tag = hn::RebindToUnsigned<Tag>;
using Codes = hn::Vec<Code_tag>;

HWY_INLINE Doubles all(double x) { return hn::Set(Tag(), x); }

struct Vector {
  Doubles x, y, z;
};
HWY_INLINE Vector difference(const Vector& a, const Vector& b) { return {Sub(a.x, b.x), Sub(a.y, b.y), Sub(a.z, b.z)}; }
HWY_INLINE Vector cross(const Vector& a, const Vector& b)
{
  return {Sub(Mul(a.y, b.z), Mul(a.z, b.y)), Sub(Mul(a.z, b.x), Mul(a.x, b.z)), Sub(Mul(a.x, b.y), Mul(a.y, b.x))};
}
HWY_INLINE Doubles dot(const Vector& a, const Vector& b)
{
  return Add(Add(Mul(a.x, b.x), Mul(a.y, b.y)), Mul(a.z, b.z));
}
HWY_INLINE Vector select(Mask mask, const Vector& yes, const Vector& no)
{
  return {IfThenElse(mask, yes.x, no.x), IfThenElse(mask, yes.y, no.y), IfThenElse(mask, yes.z, no.z)};
}
HWY_INLINE void swap_where(Mask mask, Vector& a, Vector& b)
{
  const Vector first = select(mask, b, a);
  b = select(mask, a, b);
  a = first;
}

/// Triangles, with an upper bound of the error of their coordinates.
struct Placed {
  Vector corner[3];
  Doubles error;

  /// Places triangles as `Adaptive_points::placed` does. The error is the bound of the corners' largest coordinates.
  /// Their sum of terms is not below a corner's, since rounding keeps order. An error that is not known is infinite.
  HWY_INLINE Placed(const Triangles8& triangles, std::size_t lane, const Pose& pose)
  {
    const auto load = [&](int c, int k) HWY_ATTR { return hn::Load(Tag(), triangles.corner[c][k] + lane); };
    const auto largest = [&](int k) HWY_ATTR { return Max(Max(Abs(load(0, k)), Abs(load(1, k))), Abs(load(2, k))); };
    const Vector most = {largest(0), largest(1), largest(2)};
    const Doubles vertex = Max(Max(most.x, most.y), most.z);
    if (pose.is_identity()) {
      for (int c = 0; c < 3; ++c) corner[c] = {load(c, 0), load(c, 1), load(c, 2)};
      error = IfThenElse(hn::Le(vertex, all(magnitude_gate)), hn::Zero(Tag()), all(HUGE_VAL));
      return;
    }
    Doubles image[3][3], terms[3];
    for (int row = 0; row < 3; ++row) {
      const Doubles m0 = all(pose[4 * row]), m1 = all(pose[4 * row + 1]), m2 = all(pose[4 * row + 2]),
                    t = all(pose[4 * row + 3]);
      for (int c = 0; c < 3; ++c)
        image[c][row] = Add(Add(Add(Mul(m0, load(c, 0)), Mul(m1, load(c, 1))), Mul(m2, load(c, 2))), t);
      terms[row] = Add(Add(Add(Mul(Abs(m0), most.x), Mul(Abs(m1), most.y)), Mul(Abs(m2), most.z)), Abs(t));
    }
    for (int c = 0; c < 3; ++c) corner[c] = {image[c][0], image[c][1], image[c][2]};
    const Doubles sum = Max(Max(terms[0], terms[1]), terms[2]);
    const Mask is_known = hn::Le(Max(sum, vertex), all(magnitude_gate));
    error = IfThenElse(is_known, Add(Mul(all(adaptive_bound::image), sum), all(underflow_slack)), all(HUGE_VAL));
  }
};

/// Returns `adaptive_bound::volume_bound` for every determinant of differences of these corners. The extent along an
/// axis is not below any computed difference, since rounding keeps order. Each sign has the errors of two points.
HWY_INLINE Doubles volume_bound(const Placed& p, const Placed& q)
{
  const auto extent = [&](Doubles Vector::*k) HWY_ATTR {
    const Doubles a = p.corner[0].*k, b = p.corner[1].*k, c = p.corner[2].*k, d = q.corner[0].*k, e = q.corner[1].*k,
                  f = q.corner[2].*k;
    return Sub(Max(Max(Max(a, b), c), Max(Max(d, e), f)), Min(Min(Min(a, b), c), Min(Min(d, e), f)));
  };
  const Doubles mx = extent(&Vector::x), my = extent(&Vector::y), mz = extent(&Vector::z),
                error = Mul(all(2), Max(p.error, q.error));
  const Doubles Mx = Add(mx, error), My = Add(my, error), Mz = Add(mz, error);
  return Add(Add(Mul(all(adaptive_bound::volume), Mul(Mul(Mx, My), Mz)),
                 Mul(Mul(all(adaptive_bound::volume_motion), error), Add(Add(Mul(My, Mz), Mul(mx, Mz)), Mul(mx, my)))),
             all(underflow_slack));
}

/// A sign in each lane, or none where it is undecided. An undefined number is undecided.
struct Sign {
  Mask positive, negative;

  HWY_INLINE Sign(Doubles determinant, Doubles bound)
      : positive(Gt(determinant, bound)), negative(Lt(determinant, Neg(bound)))
  {}
  HWY_INLINE Mask is_decided() const { return Or(positive, negative); }
};

/// The corners of a triangle against the plane of another.
struct Sides {
  Sign side[3];

  HWY_INLINE Sides(const Placed& triangle, const Placed& points, Doubles bound)
      : Sides(cross(difference(triangle.corner[1], triangle.corner[0]),
                    difference(triangle.corner[2], triangle.corner[0])),
              triangle.corner[0], points, bound)
  {}
  HWY_INLINE Mask are_decided() const
  {
    return And(And(side[0].is_decided(), side[1].is_decided()), side[2].is_decided());
  }
  HWY_INLINE Mask are_all_beside() const
  {
    return Or(And(And(side[0].positive, side[1].positive), side[2].positive),
              And(And(side[0].negative, side[1].negative), side[2].negative));
  }

 private:
  HWY_INLINE Sides(const Vector& normal, const Vector& origin, const Placed& points, Doubles bound)
      : side{Sign(dot(normal, difference(points.corner[0], origin)), bound),
             Sign(dot(normal, difference(points.corner[1], origin)), bound),
             Sign(dot(normal, difference(points.corner[2], origin)), bound)}
  {}
};

/// A triangle turned so that its first corner is alone on its side of a plane. It is meaningful only if `sides` are
/// decided and not all equal.
struct Turned {
  Vector corner[3];
  Codes end[2];  // the edge from corner 0 to 1, to 2
  Mask flips;    // alone on the negative side

  HWY_INLINE Turned(const Placed& t, const Sides& sides)
  {
    const Mask n0 = sides.side[0].negative, n1 = sides.side[1].negative, n2 = sides.side[2].negative;
    const Mask second = Not(Xor(n0, n2)), third = Not(Xor(n0, n1));  // is alone; else the first
    const Vector &a = t.corner[0], &b = t.corner[1], &c = t.corner[2];
    corner[0] = select(third, c, select(second, b, a));
    corner[1] = select(third, a, select(second, c, b));
    corner[2] = select(third, b, select(second, a, c));
    const auto edge = [&](unsigned of_first, unsigned of_second, unsigned of_third) HWY_ATTR {
      const auto code = [](unsigned k) HWY_ATTR { return hn::Set(Code_tag(), 1u << k); };
      return IfThenElse(as_codes(third), code(of_third), IfThenElse(as_codes(second), code(of_second), code(of_first)));
    };
    end[0] = edge(0, 1, 2);
    end[1] = edge(2, 0, 1);
    flips = Or(And(third, n2), hn::AndNot(third, Or(And(second, n1), hn::AndNot(second, n0))));
  }
  HWY_INLINE void turn_over(Mask mask)
  {
    swap_where(mask, corner[1], corner[2]);
    const Codes first = IfThenElse(as_codes(mask), end[1], end[0]);
    end[1] = IfThenElse(as_codes(mask), end[0], end[1]);
    end[0] = first;
  }
  HWY_INLINE static hn::Mask<Code_tag> as_codes(Mask mask) { return hn::RebindMask(Code_tag(), mask); }
};

HWY_INLINE unsigned bits_of(Mask mask)
{
  std::uint8_t bits[8];
  hn::StoreMaskBits(Tag(), mask, bits);
  return bits[0];
}

}  // namespace triangle_lanes

/// Implements `triangle_contacts8`. It takes the signs of `detail::crossing_contact`, in their order. It does without
/// MulAdd, so that all versions give equal bits.
inline HWY_ATTR void triangle_contacts8_simd(const Triangles8& triangles_p, const Pose& pose_p,
                                             const Triangles8& triangles_q, const Pose& pose_q,
                                             Triangle_contacts8& found)
{
  using namespace triangle_lanes;
  found.apart = found.crossing = 0;
  for (std::size_t lane = 0; lane < Triangles8::count; lane += hn::Lanes(Tag())) {
    const Placed placed_p(triangles_p, lane, pose_p), placed_q(triangles_q, lane, pose_q);
    const Doubles bound = volume_bound(placed_p, placed_q);
    const Sides side_q(placed_p, placed_q, bound), side_p(placed_q, placed_p, bound);
    const Mask are_beside = Or(side_q.are_all_beside(), side_p.are_all_beside());
    const Mask are_turned = hn::AndNot(are_beside, And(side_q.are_decided(), side_p.are_decided()));

    Turned p(placed_p, side_p), q(placed_q, side_q);
    q.turn_over(p.flips);
    p.turn_over(q.flips);
    const Vector between = difference(q.corner[0], p.corner[0]);
    const Vector of_p1 = cross(difference(p.corner[1], p.corner[0]), between),
                 of_p2 = cross(difference(p.corner[2], p.corner[0]), between),
                 q1 = difference(q.corner[1], p.corner[0]), q2 = difference(q.corner[2], p.corner[0]);
    const Sign b1_a1(dot(of_p1, q1), bound), b2_a2(dot(of_p2, q2), bound), b1_a2(dot(of_p2, q1), bound),
        b2_a1(dot(of_p1, q2), bound);
    const Mask are_apart = Or(are_beside, And(are_turned, Or(b1_a1.positive, b2_a2.negative)));
    const Mask are_crossing =
        And(And(are_turned, And(b1_a1.negative, b2_a2.positive)), And(b1_a2.is_decided(), b2_a1.is_decided()));

    const auto on_q = [](Codes edge) HWY_ATTR { return hn::ShiftLeft<8>(edge); };
    const Codes first = IfThenElse(Turned::as_codes(b1_a2.positive), on_q(q.end[0]), p.end[1]),
                second = IfThenElse(Turned::as_codes(b2_a1.positive), p.end[0], on_q(q.end[1]));
    hn::Store(hn::Or(first, hn::ShiftLeft<16>(second)), Code_tag(), found.ends + lane);
    found.apart |= bits_of(are_apart) << lane;
    found.crossing |= bits_of(are_crossing) << lane;
  }
}

}  // namespace tetracone::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// Included again for the next target.
#undef TETRACONE_KERNEL_PREDICATE_TRIANGLE_CONTACT8_SIMD_INL
#endif
