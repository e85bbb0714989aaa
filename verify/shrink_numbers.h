#ifndef TETRACONE_VERIFY_SHRINK_NUMBERS_H
#define TETRACONE_VERIFY_SHRINK_NUMBERS_H

#include "kernel/number.h"
#include "kernel/pose.h"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace tetracone::verify {

/// The numbers of a case: the points of both bodies, in their frames, and the poses.
struct Case_numbers {
  std::array<std::vector<kernel::Vertex>, 2> points;
  std::array<kernel::Pose, 2> poses;
};

/// How long a number is: its binary digits from the first one to the last one that are set, and those of the exponent of the last.
/// 0 for 0, 1 for 1, 2 for 3 and for 1/2; of a fraction, the digits of both parts.
std::size_t bits(double x);
std::size_t bits(const kernel::Rational& x);
std::size_t bits(const Case_numbers& numbers);

/// Tries everything that makes the numbers simpler, and keeps whatever `accept` accepts. True when it accepted something.
/// `accept` is asked of numbers with fewer `bits` only; all are finite, det M may be 0.
bool simplify(Case_numbers& numbers, const std::function<bool(const Case_numbers&)>& accept);

}  // namespace tetracone::verify

#endif
