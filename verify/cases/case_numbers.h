#ifndef TETRACONE_VERIFY_CASES_CASE_NUMBERS_H
#define TETRACONE_VERIFY_CASES_CASE_NUMBERS_H

#include "tetracone/kernel/contact/corner_point.h"
#include "verify/cases/case.h"

#include <array>
#include <cstddef>
#include <vector>

namespace tetracone::verify {

/// The numbers of a case of either level: the points of both bodies in their own frames, and the poses.
struct Case_numbers {
  std::array<std::vector<kernel::Vertex>, 2> points;
  std::array<kernel::Pose, 2> poses;
};

Case_numbers numbers_of(const Object_case& c);
Case_numbers numbers_of(const Predicate_case& c);

/// Returns the case with other numbers, equally many. Bodies whose points do not change are shared with `c`. The
/// answers of the result are unknown.
Object_case with_numbers(const Object_case& c, const Case_numbers& numbers);
Predicate_case with_numbers(const Predicate_case& c, const Case_numbers& numbers);

/// Returns the exact images of the triangles v1 v2 v3 and p q r.
std::array<std::array<kernel::Number_point<kernel::Rational>, 3>, 2> placed_triangles(const Predicate_case& c);

/// Returns the length of a number. It is its binary digits from the first to the last one that is set, plus the digits
/// of the last one's exponent. It is 0 for 0, 1 for 1, 2 for 3 and for 1/2; for a fraction, the digits of both parts.
std::size_t bits(double x);
std::size_t bits(const kernel::Rational& x);

/// Returns the total length of all coordinates, and of the entries of the poses that differ from the identity's.
std::size_t bits(const Case_numbers& numbers);

/// |x| = mantissa * 2^exponent with an odd mantissa; zeros for 0.
struct Odd {
  std::uint64_t mantissa = 0;
  int exponent = 0;
};
Odd odd(double x);

}  // namespace tetracone::verify

#endif
