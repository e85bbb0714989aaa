#ifndef TETRACONE_KERNEL_SIMD_SHORT_VECTORS_H
#define TETRACONE_KERNEL_SIMD_SHORT_VECTORS_H

#include <cstdint>
#include <cstring>
#include <limits>

/// Vectors of 16 bytes, the compiler's own. They serve work so short that the call of a version chosen at run time (see
/// simd.h) would take longer. Operations are lane by lane, in the instructions that every processor of the architecture
/// has.
namespace tetracone::kernel {

using Four_floats [[gnu::vector_size(16)]] = float;
using Four_ints [[gnu::vector_size(16)]] = std::int32_t;
using Eight_shorts [[gnu::vector_size(16)]] = std::int16_t;
using Two_doubles [[gnu::vector_size(16)]] = double;
using Two_longs [[gnu::vector_size(16)]] = std::int64_t;

inline Four_floats magnitudes(Four_floats v)
{
  return reinterpret_cast<Four_floats>(reinterpret_cast<Four_ints>(v) & 0x7fffffff);
}
inline Two_doubles magnitudes(Two_doubles v)
{
  return reinterpret_cast<Two_doubles>(reinterpret_cast<Two_longs>(v) & 0x7fffffffffffffff);
}

inline Four_floats abs(Four_floats v) { return magnitudes(v); }

/// Return the vector with x in every lane.
inline Four_floats four_times(float x) { return Four_floats{x, x, x, x}; }
inline Two_doubles two_times(double x) { return Two_doubles{x, x}; }

/// Return, lane by lane, the smaller and the larger; a's where one is NaN.
inline Four_floats smaller(Four_floats a, Four_floats b) { return b < a ? b : a; }
inline Four_floats larger(Four_floats a, Four_floats b) { return a < b ? b : a; }
inline Two_doubles smaller(Two_doubles a, Two_doubles b) { return b < a ? b : a; }
inline Two_doubles larger(Two_doubles a, Two_doubles b) { return a < b ? b : a; }

/// Returns, in each lane, all bits where `v` has the sign bit, and none elsewhere.
inline Four_ints is_negative(Four_floats v) { return reinterpret_cast<Four_ints>(v) >> 31; }

/// Returns `v` with its signs changed where `signs` has the sign bit.
inline Four_floats with_signs_of(Four_floats v, Four_floats signs)
{
  constexpr std::int32_t sign_bit = std::numeric_limits<std::int32_t>::min();
  return reinterpret_cast<Four_floats>(reinterpret_cast<Four_ints>(v) ^
                                       (reinterpret_cast<Four_ints>(signs) & sign_bit));
}

/// Returns, lane by lane, `yes` where the mask has all bits and `no` where it has none.
inline Four_floats select(Four_ints mask, Four_floats yes, Four_floats no)
{
  return reinterpret_cast<Four_floats>((reinterpret_cast<Four_ints>(yes) & mask) |
                                       (reinterpret_cast<Four_ints>(no) & ~mask));
}

/// Returns the sum of the lanes, in every lane: that is (v0 + v1) + (v2 + v3).
inline Four_floats sum_of_lanes(Four_floats v)
{
  v += __builtin_shufflevector(v, v, 1, 0, 3, 2);
  return v + __builtin_shufflevector(v, v, 2, 3, 0, 1);
}
inline Four_ints sum_of_lanes(Four_ints v)
{
  v += __builtin_shufflevector(v, v, 1, 0, 3, 2);
  return v + __builtin_shufflevector(v, v, 2, 3, 0, 1);
}

/// Returns lane i in every lane.
template <int i>
Four_floats repeated(Four_floats v)
{
  return __builtin_shufflevector(v, v, i, i, i, i);
}

/// Returns the vector with 0 in the last lane.
inline Four_floats first_three(Four_floats v)
{
  return reinterpret_cast<Four_floats>(reinterpret_cast<Four_ints>(v) & Four_ints{-1, -1, -1, 0});
}

inline Two_doubles two_from(const double* p)
{
  Two_doubles v;
  std::memcpy(&v, p, sizeof v);
  return v;
}

inline Four_floats four_from(const float* p)
{
  Four_floats v;
  std::memcpy(&v, p, sizeof v);
  return v;
}

/// Returns four doubles, each rounded to the nearest float.
inline Four_floats rounded(Two_doubles first, Two_doubles last)
{
  return Four_floats{float(first[0]), float(first[1]), float(last[0]), float(last[1])};
}

}  // namespace tetracone::kernel

#endif
