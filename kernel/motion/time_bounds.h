#ifndef TETRACONE_KERNEL_MOTION_TIME_BOUNDS_H
#define TETRACONE_KERNEL_MOTION_TIME_BOUNDS_H

namespace tetracone::kernel {

/// The doubles that enclose a time: lo <= t <= hi. lo = hi where t is that double; else hi is the next double after lo.
struct Time_bounds {
  double lo, hi;
};

}  // namespace tetracone::kernel

#endif
