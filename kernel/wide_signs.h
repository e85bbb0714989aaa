#ifndef TETRACONE_KERNEL_WIDE_SIGNS_H
#define TETRACONE_KERNEL_WIDE_SIGNS_H

#include "kernel/adaptive.h"
#include "kernel/simd.h"
#include "kernel/wide_points.h"

#include <algorithm>
#include <cmath>

#define TETRACONE_SIMD_KERNEL "kernel/wide_signs_kernel.h"
#include "kernel/simd_rounds.h"

namespace tetracone::kernel {

/// The first stage of Adaptive's volume sign, of one triangle a, b, c and many points d at once: sign k is that of
/// Adaptive::filtered_volume_sign(a, b, c, d_k), the same operations on the same doubles in every lane, or undecided.
/// Writes words_of(points.count) words.
inline void filtered_volume_signs(const Adaptive::Point_3& a, const Adaptive::Point_3& b, const Adaptive::Point_3& c, const Wide_points& points,
                                  Wide_signs* signs)
{
  static Filtered_volume_signs* const fastest = fastest_version<Filtered_volume_signs>(TETRACONE_SIMD_VERSIONS(filtered_volume_signs_kernel));
  fastest({a.image, b.image, c.image, a.error, std::max(b.error, c.error)}, points, signs);
}

}  // namespace tetracone::kernel

#endif
