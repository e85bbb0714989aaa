#ifndef TETRACONE_KERNEL_PREDICATE_TOLERANT_H
#define TETRACONE_KERNEL_PREDICATE_TOLERANT_H

#include "tetracone/kernel/predicate/tolerance.h"

#include <CGAL/Simple_cartesian.h>

namespace tetracone::kernel {

/// Double with a tolerance, the way robust codes are usually written: each sign is computed in double and is ZERO
/// within the tolerance. It is a kernel under study, and the only place of this library where an epsilon decides.
/// Everything else is CGAL::Simple_cartesian<double>.
class Tolerant : public CGAL::Type_equality_wrapper<CGAL::Cartesian_base_no_ref_count<double, Tolerant>, Tolerant> {
 public:
  /// Returns the calling thread's tolerance, which a caller may set.
  static Tolerance& tolerance()
  {
    static thread_local Tolerance value;
    return value;
  }
};

}  // namespace tetracone::kernel

#endif
