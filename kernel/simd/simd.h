#ifndef TETRACONE_KERNEL_SIMD_SIMD_H
#define TETRACONE_KERNEL_SIMD_SIMD_H

// AVX3_DL gains nothing here over AVX-512's first set. Where it is the static target, Highway 1.0.3 does not compile.
#ifndef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS HWY_AVX3_DL
#endif
#include <hwy/detect_targets.h>

#include <cstdint>
#include <initializer_list>
#include <type_traits>

/// Vectors of numbers by Highway. A function is compiled for what every processor of the architecture has (x86-64:
/// SSE2), for SSSE3, AVX2 and AVX-512. Its version is chosen at run time.
///
/// A vector function is an inline one of the namespace HWY_NAMESPACE within its folder's, in a file NAME_simd.inl.
/// NAME.h includes that file once for each target and chooses a version. Example: kernel/bound/obb8_overlap_simd.inl
/// and obb8_overlap.h.
///
///     #define TETRACONE_SIMD_FILE "tetracone/FOLDER/ROOM/NAME_simd.inl"
///     #include "tetracone/kernel/simd/simd_rounds.h"
///
///     inline double name(double x)
///     {
///       static auto* const fastest = TETRACONE_SIMD_FASTEST(name_simd);
///       return fastest(x);
///     }
///
/// Vectors never cross a call. No vector function is a friend defined in a class template. g++ compiles such a friend
/// for the static target, and without optimisation it takes vectors from other registers. Signs are the same bits in
/// all versions: functions that decide them use neither MulAdd nor sums over lanes.
///
/// Highway generates the operations of a target once in a translation unit. A unit that has Highway code of its own may
/// include this header after all of them (where HWY_ONCE is true). It then uses the operations that are there. Or it
/// includes this header before them; then its own code is compiled for its static target only.

#ifdef HIGHWAY_HWY_FOREACH_TARGET_H_
#if !HWY_ONCE
#error "tetracone's headers in a round of hwy/foreach_target.h: include them before it, or under #if HWY_ONCE"
#endif
#define TETRACONE_SIMD_HAS_OPERATIONS
#endif

// Which targets, and where their versions of a function are. HWY_TARGETS is narrowed below.
#if (HWY_TARGETS & HWY_SSSE3) && HWY_STATIC_TARGET != HWY_SSSE3
#define TETRACONE_SIMD_SSSE3(function) {HWY_SSSE3, &N_SSSE3::function},
#else
#define TETRACONE_SIMD_SSSE3(function)
#define TETRACONE_SIMD_NO_SSSE3
#endif
#if (HWY_TARGETS & HWY_AVX2) && HWY_STATIC_TARGET != HWY_AVX2
#define TETRACONE_SIMD_AVX2(function) {HWY_AVX2, &N_AVX2::function},
#else
#define TETRACONE_SIMD_AVX2(function)
#define TETRACONE_SIMD_NO_AVX2
#endif
#if (HWY_TARGETS & HWY_AVX3) && HWY_STATIC_TARGET != HWY_AVX3
#define TETRACONE_SIMD_AVX3(function) {HWY_AVX3, &N_AVX3::function},
#else
#define TETRACONE_SIMD_AVX3(function)
#define TETRACONE_SIMD_NO_AVX3
#endif

/// The versions of a function that this translation unit has, the fastest first.
#define TETRACONE_SIMD_VERSIONS(function)                                                      \
  {                                                                                            \
    TETRACONE_SIMD_AVX3(function) TETRACONE_SIMD_AVX2(function) TETRACONE_SIMD_SSSE3(function) \
    {                                                                                          \
      HWY_STATIC_TARGET, &HWY_STATIC_DISPATCH(function)                                        \
    }                                                                                          \
  }

/// The version of a function that this processor takes: see `fastest_version`.
#define TETRACONE_SIMD_FASTEST(function)                                                                  \
  ::tetracone::kernel::fastest_version<std::remove_reference_t<decltype(HWY_STATIC_DISPATCH(function))>>( \
      TETRACONE_SIMD_VERSIONS(function))

#ifndef TETRACONE_SIMD_HAS_OPERATIONS
// The rounds are made here, not by hwy/foreach_target.h, which would repeat the file that includes this one. Highway
// sees a unit of one target, whose rounds are over.
#define HIGHWAY_HWY_FOREACH_TARGET_H_
#undef HWY_TARGETS
#define HWY_TARGETS HWY_STATIC_TARGET
#undef HWY_ONCE
#define HWY_ONCE 1
#ifdef HWY_HIGHWAY_INCLUDED  // the static target's operations are there: the toggle's next state makes the others'
#define HWY_TARGET_TOGGLE
#define TETRACONE_SIMD_HAS_STATIC_OPERATIONS
#endif
#endif

#ifndef TETRACONE_SIMD_HAS_OPERATIONS
// Highway's operations for each target; the toggle tells it one round from the next.
#ifndef TETRACONE_SIMD_NO_SSSE3
#undef HWY_TARGET
#define HWY_TARGET HWY_SSSE3
#include "tetracone/kernel/simd/simd_operations.h"
#endif
#ifndef TETRACONE_SIMD_NO_AVX2
#undef HWY_TARGET
#define HWY_TARGET HWY_AVX2
#include "tetracone/kernel/simd/simd_operations.h"
#endif
#ifndef TETRACONE_SIMD_NO_AVX3
#undef HWY_TARGET
#define HWY_TARGET HWY_AVX3
#include "tetracone/kernel/simd/simd_operations.h"
#endif
#ifndef TETRACONE_SIMD_HAS_STATIC_OPERATIONS
#undef HWY_TARGET
#define HWY_TARGET HWY_STATIC_TARGET
#include "tetracone/kernel/simd/simd_operations.h"
#endif
#endif

// As after one round: highway.h has nothing left to do, and headers that are toggled are made for the static target.
#undef HWY_TARGET
#define HWY_TARGET HWY_STATIC_TARGET
#undef HWY_TARGET_TOGGLE
#undef HWY_HIGHWAY_PER_TARGET
#define HWY_HIGHWAY_PER_TARGET
#include <hwy/ops/set_macros-inl.h>

namespace tetracone::kernel {

/// A vector function compiled for a target of Highway's.
template <class Function>
struct Simd_version {
  std::int64_t target;
  Function* function;
};

/// Returns the first of the versions whose target this processor has and Highway has not been told to leave out. Else
/// it returns the last one, for the static target.
template <class Function>
Function* fastest_version(std::initializer_list<Simd_version<Function>> versions)
{
  const std::int64_t supported = hwy::SupportedTargets();
  for (const auto& version : versions)
    if (version.target & supported) return version.function;
  return (versions.end() - 1)->function;
}

}  // namespace tetracone::kernel

#endif
