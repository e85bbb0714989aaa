#ifndef TETRACONE_KERNEL_BOUND_OBB8_RAY_SIMD_INL
#define TETRACONE_KERNEL_BOUND_OBB8_RAY_SIMD_INL
// Included by kernel/bound/obb8_ray.h, once for each target.
#ifndef TETRACONE_SIMD_FILE
#undef TETRACONE_KERNEL_BOUND_OBB8_RAY_SIMD_INL  // that header includes this one, again and again
#include "tetracone/kernel/bound/obb8_ray.h"
#else

HWY_BEFORE_NAMESPACE();
namespace tetracone::kernel::HWY_NAMESPACE {

/// Sets `nearest` and returns the lanes met, as bits: `ray_lanes`, with `from` the ray's origin less that of the boxes.
inline HWY_ATTR unsigned ray_lanes_simd(const Obb8& boxes, const float* from, const float* direction, float limit,
                                        float* nearest)
{
  namespace hn = hwy::HWY_NAMESPACE;
  using hn::Abs, hn::Add, hn::Div, hn::IfThenElse, hn::Lt, hn::Max, hn::Min, hn::Mul, hn::MulAdd, hn::Sub;
  constexpr hn::CappedTag<float, lanes> tag{};
  unsigned met = 0;
  for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(tag)) {
    const auto load = [&](const float* first) HWY_ATTR { return hn::Load(tag, first + lane); };
    const auto all = [&](float x) HWY_ATTR { return hn::Set(tag, x); };
    const auto one = all(1), slack = all(Local_ray::slack), least_step = all(0x1p-30f);
    const auto x = Sub(all(from[0]), load(boxes.centre[0])), y = Sub(all(from[1]), load(boxes.centre[1])),
               z = Sub(all(from[2]), load(boxes.centre[2]));
    auto near = all(-Local_ray::slack), far = all(limit + Local_ray::slack);
    for (int i = 0; i < 3; ++i) {
      const auto u = load(boxes.axis[i][0]), v = load(boxes.axis[i][1]), w = load(boxes.axis[i][2]);
      const auto at = MulAdd(w, z, MulAdd(v, y, Mul(u, x)));
      const auto step = MulAdd(w, all(direction[2]), MulAdd(v, all(direction[1]), Mul(u, all(direction[0]))));
      const auto inverse = Div(one, IfThenElse(Lt(Abs(step), least_step), least_step, step));
      const auto middle = Mul(at, inverse), half = Mul(Add(load(boxes.extent[i]), slack), Abs(inverse));
      near = Max(near, Sub(hn::Neg(middle), half));
      far = Min(far, Sub(half, middle));
    }
    hn::StoreU(near, tag, nearest + lane);
    std::uint8_t apart[8] = {};
    hn::StoreMaskBits(tag, Lt(far, near), apart);
    met |= (~unsigned(apart[0]) & ((1u << hn::Lanes(tag)) - 1)) << lane;
  }
  return met & ((1u << boxes.lane_count) - 1);
}

}  // namespace tetracone::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// Included again for the next target.
#undef TETRACONE_KERNEL_BOUND_OBB8_RAY_SIMD_INL
#endif
