#ifndef TETRACONE_KERNEL_BOUND_OBB8_RAY_SIMD_INL
#define TETRACONE_KERNEL_BOUND_OBB8_RAY_SIMD_INL
// Included by kernel/bound/obb8_ray.h, once for each target.
#ifndef TETRACONE_SIMD_FILE
#undef TETRACONE_KERNEL_BOUND_OBB8_RAY_SIMD_INL  // that header includes this one, again and again
#include "tetracone/kernel/bound/obb8_ray.h"
#else

HWY_BEFORE_NAMESPACE();
namespace tetracone::kernel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// The rounded arithmetic uses these operations alone. Its error is proved from it (verify/proofs/obb8_ray_proofs.h).
using hn::Abs, hn::Add, hn::Mul, hn::MulAdd, hn::Neg, hn::Sub;

/// Returns the scalar product of an axis (u, v, w) and a vector (x, y, z).
template <class Floats>
HWY_INLINE Floats along_axis(Floats u, Floats v, Floats w, Floats x, Floats y, Floats z)
{
  return MulAdd(w, z, MulAdd(v, y, Mul(u, x)));
}

/// Returns the s at which a ray enters or leaves the slab of half width `reach` about 0. The ray starts at `at` along
/// the axis, and `inverse` is the inverse of its step.
template <class Floats>
HWY_INLINE Floats entry_of_slab(Floats at, Floats inverse, Floats reach)
{
  return Sub(Neg(Mul(at, inverse)), Mul(reach, Abs(inverse)));
}
template <class Floats>
HWY_INLINE Floats exit_of_slab(Floats at, Floats inverse, Floats reach)
{
  return Sub(Mul(reach, Abs(inverse)), Mul(at, inverse));
}

/// Implements `ray_lanes`.
inline HWY_ATTR unsigned ray_lanes_simd(const Obb8& boxes, const Local_ray& ray, double limit, float* nearest)
{
  using hn::Div, hn::IfThenElse, hn::Lt, hn::Max, hn::Min;
  constexpr hn::CappedTag<float, lanes> tag{};
  float from[3], direction[3];
  for (int k = 0; k < 3; ++k) {
    from[k] = float(ray.origin[k] - double(boxes.origin[k]));
    direction[k] = float(ray.direction[k]);
  }
  const float last = float(limit) + Local_ray::slack;
  unsigned met = 0;
  for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(tag)) {
    const auto load = [&](const float* first) HWY_ATTR { return hn::Load(tag, first + lane); };
    const auto all = [&](float x) HWY_ATTR { return hn::Set(tag, x); };
    const auto one = all(1), slack = all(Local_ray::slack), least_step = all(Local_ray::least_step);
    const auto x = Sub(all(from[0]), load(boxes.centre[0])), y = Sub(all(from[1]), load(boxes.centre[1])),
               z = Sub(all(from[2]), load(boxes.centre[2]));
    auto near = all(-Local_ray::slack), far = all(last);
    for (int i = 0; i < 3; ++i) {
      const auto u = load(boxes.axis[i][0]), v = load(boxes.axis[i][1]), w = load(boxes.axis[i][2]);
      const auto at = along_axis(u, v, w, x, y, z);
      const auto step = along_axis(u, v, w, all(direction[0]), all(direction[1]), all(direction[2]));
      const auto inverse = Div(one, IfThenElse(Lt(Abs(step), least_step), least_step, step));
      const auto reach = Add(load(boxes.extent[i]), slack);
      near = Max(near, entry_of_slab(at, inverse, reach));
      far = Min(far, exit_of_slab(at, inverse, reach));
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
