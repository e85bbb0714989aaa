#ifndef TETRACONE_KERNEL_BOUND_TRIANGLE_DISTANCE_SIMD_INL
#define TETRACONE_KERNEL_BOUND_TRIANGLE_DISTANCE_SIMD_INL
// Included by kernel/bound/triangle_distance.h, once for each target.
#ifndef TETRACONE_SIMD_FILE
#undef TETRACONE_KERNEL_BOUND_TRIANGLE_DISTANCE_SIMD_INL  // that header includes this one, again and again
#include "tetracone/kernel/bound/triangle_distance.h"
#else

HWY_BEFORE_NAMESPACE();
namespace tetracone::kernel::HWY_NAMESPACE {

/// Finds the nearest points of each edge of A, a lane each, and the edge of B nearest to it. It does without MulAdd, so
/// that all versions give equal bits.
inline HWY_ATTR void nearest_on_edges_simd(const Edged_triangle& a, const Edged_triangle& b,
                                           triangle_distance::Near_edges& near)
{
  namespace hn = hwy::HWY_NAMESPACE;
  using hn::Add, hn::Div, hn::Gt, hn::IfThenElse, hn::IfThenElseZero, hn::Lt, hn::Mul, hn::Sub;
  constexpr hn::CappedTag<double, 4> tag{};
  const auto all = [&](double x) HWY_ATTR { return hn::Set(tag, x); };
  const auto dot = [](const auto& x, const auto& y, const auto& z, const auto& u, const auto& v, const auto& w)
                       HWY_ATTR { return Add(Add(Mul(x, u), Mul(y, v)), Mul(z, w)); };
  for (std::size_t lane = 0; lane < 4; lane += hn::Lanes(tag)) {
    const auto load = [&](const auto& lanes) HWY_ATTR { return hn::Load(tag, lanes + lane); };
    const auto zero = hn::Zero(tag), one = all(1);
    // An undefined value becomes 0.
    const auto clamped = [&](const auto& x)
                             HWY_ATTR { return IfThenElseZero(Gt(x, zero), IfThenElse(Lt(x, one), x, one)); };
    const auto x = load(a.at[0]), y = load(a.at[1]), z = load(a.at[2]), ex = load(a.way[0]), ey = load(a.way[1]),
               ez = load(a.way[2]);
    const auto ee = dot(ex, ey, ez, ex, ey, ez), per_ee = Div(one, ee);
    auto best = all(HUGE_VAL), best_s = zero, best_t = zero, best_j = zero;
    for (int j = 0; j < 3; ++j) {
      const auto fx = all(b.way[0][j]), fy = all(b.way[1][j]), fz = all(b.way[2][j]);
      const auto rx = Sub(x, all(b.at[0][j])), ry = Sub(y, all(b.at[1][j])), rz = Sub(z, all(b.at[2][j]));
      const auto ff = dot(fx, fy, fz, fx, fy, fz), ef = dot(ex, ey, ez, fx, fy, fz), er = dot(ex, ey, ez, rx, ry, rz),
                 fr = dot(fx, fy, fz, rx, ry, rz), per_ff = Div(one, ff);
      auto s = clamped(Div(Sub(Mul(ef, fr), Mul(ff, er)), Sub(Mul(ee, ff), Mul(ef, ef))));
      const auto t = clamped(Mul(Add(Mul(ef, s), fr), per_ff));
      s = clamped(Mul(Sub(Mul(ef, t), er), per_ee));
      const auto dx = Add(rx, Sub(Mul(s, ex), Mul(t, fx))), dy = Add(ry, Sub(Mul(s, ey), Mul(t, fy))),
                 dz = Add(rz, Sub(Mul(s, ez), Mul(t, fz)));
      const auto square = dot(dx, dy, dz, dx, dy, dz);
      const auto nearer = Lt(square, best);
      best = IfThenElse(nearer, square, best);
      best_s = IfThenElse(nearer, s, best_s);
      best_t = IfThenElse(nearer, t, best_t);
      best_j = IfThenElse(nearer, all(j), best_j);
    }
    hn::Store(best, tag, near.square + lane);
    hn::Store(best_s, tag, near.s + lane);
    hn::Store(best_t, tag, near.t + lane);
    hn::Store(best_j, tag, near.of_b + lane);
  }
}

}  // namespace tetracone::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// Included again for the next target.
#undef TETRACONE_KERNEL_BOUND_TRIANGLE_DISTANCE_SIMD_INL
#endif
