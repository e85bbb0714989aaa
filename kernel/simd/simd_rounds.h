#ifndef TETRACONE_KERNEL_SIMD_SIMD_ROUNDS_H
#define TETRACONE_KERNEL_SIMD_SIMD_ROUNDS_H
// Includes the file that TETRACONE_SIMD_FILE names once for each target: see kernel/simd/simd.h. It is included again
// for every such file.
#include "tetracone/kernel/simd/simd.h"

#ifdef TETRACONE_SIMD_FILE
#ifndef TETRACONE_SIMD_NO_SSSE3
#undef HWY_TARGET
#define HWY_TARGET HWY_SSSE3
#include <hwy/ops/set_macros-inl.h>
#include TETRACONE_SIMD_FILE
#endif
#ifndef TETRACONE_SIMD_NO_AVX2
#undef HWY_TARGET
#define HWY_TARGET HWY_AVX2
#include <hwy/ops/set_macros-inl.h>
#include TETRACONE_SIMD_FILE
#endif
#ifndef TETRACONE_SIMD_NO_AVX3
#undef HWY_TARGET
#define HWY_TARGET HWY_AVX3
#include <hwy/ops/set_macros-inl.h>
#include TETRACONE_SIMD_FILE
#endif
#undef HWY_TARGET
#define HWY_TARGET HWY_STATIC_TARGET
#include <hwy/ops/set_macros-inl.h>
#include TETRACONE_SIMD_FILE
#undef TETRACONE_SIMD_FILE
#endif

// Included again for the next target.
#undef TETRACONE_KERNEL_SIMD_SIMD_ROUNDS_H
#endif
