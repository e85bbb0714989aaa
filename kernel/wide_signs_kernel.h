#ifndef TETRACONE_KERNEL_WIDE_SIGNS_KERNEL_H
#define TETRACONE_KERNEL_WIDE_SIGNS_KERNEL_H
// Included by kernel/wide_signs.h, once for each target.
#ifndef TETRACONE_SIMD_KERNEL
#undef TETRACONE_KERNEL_WIDE_SIGNS_KERNEL_H  // that header includes this one, again and again
#include "kernel/wide_signs.h"
#else

HWY_BEFORE_NAMESPACE();
namespace tetracone::kernel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Sign_lanes = hn::CappedTag<double, 8>;  // no more lanes than a byte has bits

/// The signs of the points from `k` on, one for each lane: the expressions of Adaptive::filtered_volume_sign, in their order.
HWY_ATTR inline Wide_signs filtered_volume_signs_of_lanes(const Wide_triangle& triangle, const Wide_points& points, std::size_t k)
{
  const Sign_lanes tag;
  const auto& [a, b, c, error_of_a, error_of_b_and_c] = triangle;
  const double bx = b[0] - a[0], by = b[1] - a[1], bz = b[2] - a[2];
  const double cx = c[0] - a[0], cy = c[1] - a[1], cz = c[2] - a[2];
  const auto all = [tag](double x) HWY_ATTR { return hn::Set(tag, x); };
  const auto larger = [all](double x, double y) HWY_ATTR { return all(std::max(std::abs(x), std::abs(y))); };

  const auto dx = hn::LoadU(tag, points.x + k) - all(a[0]);
  const auto dy = hn::LoadU(tag, points.y + k) - all(a[1]);
  const auto dz = hn::LoadU(tag, points.z + k) - all(a[2]);
  const auto determinant = all(by * cz - bz * cy) * dx + all(bz * cx - bx * cz) * dy + all(bx * cy - by * cx) * dz;
  const auto mx = hn::Max(larger(bx, cx), hn::Abs(dx));
  const auto my = hn::Max(larger(by, cy), hn::Abs(dy));
  const auto mz = hn::Max(larger(bz, cz), hn::Abs(dz));
  const auto error = all(error_of_a) + hn::Max(all(error_of_b_and_c), hn::LoadU(tag, points.error + k));
  const auto Mx = mx + error, My = my + error, Mz = mz + error;
  const auto bound = all(Adaptive::volume_rounding) * (Mx * My * Mz) +
                     all(Adaptive::volume_motion) * error * (My * Mz + mx * Mz + mx * my) + all(Adaptive::underflow);

  std::uint8_t positive[8], negative[8];  // StoreMaskBits may write as many
  hn::StoreMaskBits(tag, determinant > bound, positive);
  hn::StoreMaskBits(tag, determinant < hn::Neg(bound), negative);
  return {positive[0], negative[0]};
}

inline HWY_ATTR void filtered_volume_signs_kernel(const Wide_triangle& triangle, const Wide_points& points, Wide_signs* signs)
{
  for (std::size_t word = 0; 64 * word < points.count; ++word) {
    const std::size_t first = 64 * word, here = std::min<std::size_t>(64, points.count - first);
    Wide_signs& found = signs[word] = {};
    for (std::size_t k = 0; k < here; k += hn::Lanes(Sign_lanes())) {
      const Wide_signs of_lanes = filtered_volume_signs_of_lanes(triangle, points, first + k);
      found.positive |= of_lanes.positive << k;
      found.negative |= of_lanes.negative << k;
    }
    const std::uint64_t asked = ~std::uint64_t(0) >> (64 - here);
    found.positive &= asked, found.negative &= asked;
  }
}

}  // namespace tetracone::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// Included again for the next target.
#undef TETRACONE_KERNEL_WIDE_SIGNS_KERNEL_H
#endif
