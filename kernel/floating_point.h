#ifndef TETRACONE_KERNEL_FLOATING_POINT_H
#define TETRACONE_KERNEL_FLOATING_POINT_H

#include <cfenv>
#include <cfloat>
#include <limits>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

// Every sign of this library rests on IEEE double arithmetic rounded to nearest, evaluated as written.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "tetracone cannot be compiled with -ffast-math or -ffinite-math-only: exact signs rest on what they break"
#endif
static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53);
static_assert(std::numeric_limits<float>::is_iec559 && std::numeric_limits<float>::digits == 24);
static_assert(FLT_EVAL_METHOD == 0, "doubles must be rounded at every operation (no x87)");

namespace tetracone::kernel {

/// Unit roundoff of the number type: half the distance from 1 to the next number.
template <class Number>
inline constexpr Number unit_roundoff = std::numeric_limits<Number>::epsilon() / 2;

/// True when the calling thread rounds to nearest and keeps denormals (neither flush-to-zero nor denormals-are-zero).
/// Both are per thread and inherited by the threads it starts; a library linked with -ffast-math can change them at load.
/// Programs ask once per thread before they trust an answer.
inline bool floating_point_is_sound()
{
  if (std::fegetround() != FE_TONEAREST) return false;
#if defined(__SSE2__)
  constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
  if ((_mm_getcsr() & (flush_to_zero | denormals_are_zero)) != 0) return false;
#endif
  volatile double denormal = std::numeric_limits<double>::min();
  denormal = denormal / 2;
  return denormal != 0;
}

}  // namespace tetracone::kernel

#endif
