#ifndef TETRACONE_KERNEL_NUMBER_FLOATING_POINT_H
#define TETRACONE_KERNEL_NUMBER_FLOATING_POINT_H

#include "tetracone/kernel/number/error.h"

#include <cfenv>
#include <cfloat>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

// Every sign of this library rests on IEEE double arithmetic rounded to nearest, evaluated as written. Some options of
// clang define no macro (`-funsafe-math-optimizations` and its parts). `arithmetic_is_as_written` detects them when a
// tree is made.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "tetracone cannot be compiled with -ffast-math or -ffinite-math-only: exact signs rest on what they break"
#endif
#if defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error \
    "tetracone cannot be compiled with -funsafe-math-optimizations, -fassociative-math or -freciprocal-math: exact signs rest on what they break"
#endif
static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53);
static_assert(std::numeric_limits<float>::is_iec559 && std::numeric_limits<float>::digits == 24);
static_assert(FLT_EVAL_METHOD == 0, "doubles must be rounded at every operation (no x87)");

namespace tetracone::kernel {

/// The unit roundoff of the number type: half the distance from 1 to the next number.
template <class Number>
inline constexpr Number unit_roundoff = std::numeric_limits<Number>::epsilon() / 2;

/// The largest magnitude at which signs are decided in rounded arithmetic. It applies to coordinates, to the sum of
/// terms of an image's coordinate, and to entries in det M. Up to it no image, determinant or bound overflows.
inline constexpr double magnitude_gate = 0x1p110;

/// The term that bounds in double add for gradual underflow (verify/test/verify/proofs/bound_proofs.cpp). A product
/// loses at most 2^-1075 by underflow. The later factors, all within the gates, keep that far below this term.
inline constexpr double underflow_slack = 0x1p-800;

/// Upper bound of the error of 100 successive sums and products in double, relative to their terms' magnitudes:
/// verify/proofs/margin_proofs.h.
inline constexpr double few_roundings = 0x1p-40;

/// Returns the float nearest to a number. Use it where the float becomes a double again. At -O3, g++ 12 drops both
/// conversions of numbers that it converts two at once; the empty instruction hides them from each other.
[[gnu::always_inline]] constexpr float to_float(double x)
{
  float nearest = static_cast<float>(x);
#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ < 14
  if (!std::is_constant_evaluated()) {
#if defined(__SSE2__)
    asm("" : "+x"(nearest));
#else
    asm("" : "+m"(nearest));
#endif
  }
#endif
  return nearest;
}

/// Return the largest and the least of the numbers; NaN where any of them is, as IEEE 754-2019's maximum and minimum
/// do. Zeros of either sign are equal. std::max and std::min keep NaN or drop it by the order of their arguments. A
/// bound that has dropped it accepts values that it should reject.
template <class Number, std::same_as<Number>... Numbers>
[[gnu::always_inline]] inline Number maximum(Number first, Numbers... others)
{
  Number largest = first;
  ((largest = largest > others ? largest : others), ...);
  if constexpr (std::is_floating_point_v<Number>)
    if ((std::isunordered(first, others) || ...)) [[unlikely]]
      return std::numeric_limits<Number>::quiet_NaN();
  return largest;
}
template <class Number, std::same_as<Number>... Numbers>
[[gnu::always_inline]] inline Number minimum(Number first, Numbers... others)
{
  Number least = first;
  ((least = least < others ? least : others), ...);
  if constexpr (std::is_floating_point_v<Number>)
    if ((std::isunordered(first, others) || ...)) [[unlikely]]
      return std::numeric_limits<Number>::quiet_NaN();
  return least;
}

/// Returns the largest of numbers by one instruction each, which may keep or drop NaN. It serves for bounds that decide
/// nothing where one of these numbers is NaN: the value or its error is then NaN or infinite too.
template <class Number, std::same_as<Number>... Numbers>
[[gnu::always_inline]] inline Number maximum_of_defined(Number first, Numbers... others)
{
  ((first = first > others ? first : others), ...);
  return first;
}

/// True when the calling thread rounds to nearest and keeps denormals (neither flush-to-zero nor denormals-are-zero).
/// Both settings belong to a thread and are inherited by the threads it starts. A library linked with -ffast-math can
/// change them at load. The check takes a few cycles.
inline bool floating_point_is_sound()
{
#if defined(__x86_64__) && defined(__SSE2__)
  constexpr unsigned rounding = 0x6000, flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
  return (_mm_getcsr() & (rounding | flush_to_zero | denormals_are_zero)) == 0;
#elif defined(__aarch64__)
  constexpr std::uint64_t rounding = 3u << 22, flush_to_zero = 1u << 24;
  std::uint64_t control;
  asm volatile("mrs %0, fpcr" : "=r"(control));
  return (control & (rounding | flush_to_zero)) == 0;
#else
  volatile double denormal = std::numeric_limits<double>::min();
  denormal = denormal / 2;
  return std::fegetround() == FE_TONEAREST && denormal != 0;
#endif
}

/// True when the compiler evaluates sums, products and quotients as they are written, in the calling function. Then the
/// remainder of TwoSum is not folded to 0, and a product is rounded before it is added to. A quotient is no product
/// with a reciprocal.
[[gnu::always_inline]] inline bool arithmetic_is_as_written()
{
  volatile double one = 1, tiny = 0x1p-60;
  const double x = one, y = tiny, sum = x + y, part = sum - x;
  const double lost = (x - (sum - part)) + (y - part);

  // (1 + 2^-30)^2 rounds off 2^-60.
  volatile double factor = 1 + 0x1p-30, product = factor * factor;
  const double p = factor, q = factor;
  const double left = p * q - product;

  // 49 (1 / 49) is below 1. Compilers form a reciprocal only for several quotients.
  volatile double dividend = 49;
  const double divisor = dividend, first = dividend / divisor, second = dividend / divisor, third = dividend / divisor;
  return lost == 0x1p-60 && left == 0 && first == 1 && second == 1 && third == 1;
}

/// Thrown by functions that decide exactly, when floating point is not as required.
class Unsound_floating_point : public Error {
 public:
  using Error::Error;
};

/// Throws Unsound_floating_point when the calling thread's floating point is not sound. Every query that decides
/// exactly calls it. A caller of single signs calls it once a thread.
inline void require_sound_floating_point()
{
  if (!floating_point_is_sound()) [[unlikely]]
    throw Unsound_floating_point(
        "floating point: this thread does not round to nearest or flushes denormals to zero; "
        "expected the default environment, without which no answer is exact");
}

/// Throws Unsound_floating_point when floating point is not sound, and when the calling function is compiled with flags
/// that change the arithmetic. It is called where a model or a query object that decides exactly is made.
[[gnu::always_inline]] inline void require_exact_arithmetic()
{
  require_sound_floating_point();
  if (!arithmetic_is_as_written()) [[unlikely]]
    throw Unsound_floating_point(
        "floating point: compiled with flags that reorder or contract arithmetic; "
        "expected none of -funsafe-math-optimizations and its parts, and -ffp-contract=off");
}

}  // namespace tetracone::kernel

#endif
