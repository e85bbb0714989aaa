#ifndef TETRACONE_VERIFY_CASES_CASE_NUMBERS_H
#define TETRACONE_VERIFY_CASES_CASE_NUMBERS_H

#include "verify/cases/case.h"

#include <array>
#include <cstddef>
#include <vector>

namespace tetracone::verify {

/// The numbers of a case of either level: the points of both bodies, in their frames, and the poses.
struct Case_numbers {
  std::array<std::vector<kernel::Vertex>, 2> points;
  std::array<kernel::Pose, 2> poses;
};

Case_numbers numbers_of(const Object_case& c);
Case_numbers numbers_of(const Predicate_case& c);

/// The case with other numbers, as many as it has. Bodies whose points stay are shared with `c`; nothing is known about
/// its answers.
Object_case with_numbers(const Object_case& c, const Case_numbers& numbers);
Predicate_case with_numbers(const Predicate_case& c, const Case_numbers& numbers);

/// How long a number is: its binary digits from the first one to the last one that are set, and those of the exponent
/// of the last. 0 for 0, 1 for 1, 2 for 3 and for 1/2; of a fraction, the digits of both parts.
std::size_t bits(double x);
std::size_t bits(const kernel::Rational& x);

/// The bits of all coordinates, and of the entries of the poses that differ from the identity's.
std::size_t bits(const Case_numbers& numbers);

/// |x| = mantissa * 2^exponent with an odd mantissa; zeros for 0.
struct Odd {
  std::uint64_t mantissa = 0;
  int exponent = 0;
};
Odd odd(double x);

}  // namespace tetracone::verify

#endif
