#ifndef TETRACONE_KERNEL_SIMD_SIMD_OPERATIONS_H
#define TETRACONE_KERNEL_SIMD_SIMD_OPERATIONS_H
// One round of kernel/simd/simd.h: Highway's operations for HWY_TARGET.
#include <hwy/highway.h>
#ifdef HWY_TARGET_TOGGLE
#undef HWY_TARGET_TOGGLE
#else
#define HWY_TARGET_TOGGLE
#endif

// Included again for the next target.
#undef TETRACONE_KERNEL_SIMD_SIMD_OPERATIONS_H
#endif
