#ifndef TETRACONE_VERIFY_SHRINK_SHRINK_NUMBERS_H
#define TETRACONE_VERIFY_SHRINK_SHRINK_NUMBERS_H

#include "verify/cases/case_numbers.h"

#include <functional>

namespace tetracone::verify {

/// Tries every simplification of the numbers, and keeps those that `accept` accepts. True when it accepted one.
/// `accept` is asked only of numbers with fewer `bits`; all are finite, det M may be 0.
bool simplify(Case_numbers& numbers, const std::function<bool(const Case_numbers&)>& accept);

}  // namespace tetracone::verify

#endif
