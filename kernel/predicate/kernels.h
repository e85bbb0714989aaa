#ifndef TETRACONE_KERNEL_PREDICATE_KERNELS_H
#define TETRACONE_KERNEL_PREDICATE_KERNELS_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/predicate/adaptive.h"
#include "tetracone/kernel/predicate/tolerant.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/gmpxx.h>

namespace tetracone::kernel {

// The kernels under study: the template parameter K of every predicate, covering and tree of this library.
using Float = CGAL::Simple_cartesian<float>;
using Double = CGAL::Simple_cartesian<double>;
using Epick = CGAL::Epick;
using Epeck = CGAL::Epeck;
using Rational_kernel = CGAL::Simple_cartesian<Rational>;

/// The properties of a kernel K that the algorithms need beyond CGAL's own functors.
/// - `exact_signs`: the sign of unmoved points is the exact expression's.
/// - `exact_motion`: a placed point is the exact image, so that signs of placed points are exact too.
/// - `Bound`: the number type of bounding volumes. Kernels with exact signs bound in double, rounded outward, so that
///   no answer depends on a rounded bound. The kernels that round bound without slack, in double; `Float` bounds in
///   float.
/// - `Fixed`: the kernel for signs of points that no pose moves, when a model is prepared. It is K itself, or one that
///   gives the same answers at less cost.
template <class K>
struct Kernel_traits {
  static constexpr bool exact_signs = true, exact_motion = true;
  using Bound = double;
  using Fixed = K;
};
template <>
struct Kernel_traits<Rational_kernel> {
  static constexpr bool exact_signs = true, exact_motion = true;
  using Bound = double;
  using Fixed = Adaptive;  // exact as well
};
template <>
struct Kernel_traits<Epick> {
  static constexpr bool exact_signs = true, exact_motion = false;
  using Bound = double;
  using Fixed = Epick;
};
template <>
struct Kernel_traits<Double> {
  static constexpr bool exact_signs = false, exact_motion = false;
  using Bound = double;
  using Fixed = Double;
};
template <>
struct Kernel_traits<Tolerant> {
  static constexpr bool exact_signs = false, exact_motion = false;
  using Bound = double;
  using Fixed = Tolerant;
};
template <>
struct Kernel_traits<Float> {
  static constexpr bool exact_signs = false, exact_motion = false;
  using Bound = float;
  using Fixed = Float;
};

}  // namespace tetracone::kernel

#endif
