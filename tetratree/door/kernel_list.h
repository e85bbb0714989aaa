#ifndef TETRACONE_TETRATREE_DOOR_KERNEL_LIST_H
#define TETRACONE_TETRATREE_DOOR_KERNEL_LIST_H

/// The one list of kernels. Names, help, error lines, compiled solvers, Python's `kernels` and the harness's subjects
/// are made from it; CMake reads it too, for the units of tetratree/solver/. A row is X(enumerator of `Kernel`, name,
/// class in tetracone::kernel, whether every answer is exact).
#define TETRACONE_FOR_EACH_KERNEL(X)           \
  X(adaptive, "adaptive", Adaptive, true)      \
  X(double_, "double", Double, false)          \
  X(float_, "float", Float, false)             \
  X(double_eps, "double-eps", Tolerant, false) \
  X(epick, "epick", Epick, false)              \
  X(epeck, "epeck", Epeck, true)               \
  X(rational, "rational", Rational_kernel, true)

#endif
