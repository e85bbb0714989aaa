#ifndef TETRACONE_KERNEL_NUMBER_INTERVAL_H
#define TETRACONE_KERNEL_NUMBER_INTERVAL_H

#include <CGAL/Interval_nt.h>

namespace tetracone::kernel {

/// An interval of doubles that encloses a number. Its arithmetic requires a block of upward rounding,
/// `CGAL::Protect_FPU_rounding<true>`. A sign that it does not tell throws `CGAL::Uncertain_conversion_exception`.
using Interval = CGAL::Interval_nt_advanced;

}  // namespace tetracone::kernel

#endif
