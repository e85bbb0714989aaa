#ifndef TETRACONE_VERIFY_SHRINK_SHRINK_NUMBERS_H
#define TETRACONE_VERIFY_SHRINK_SHRINK_NUMBERS_H

#include "verify/cases/case_numbers.h"

#include <functional>

namespace tetracone::verify {

/// Tries everything that makes the numbers simpler, and keeps whatever `accept` accepts. True when it accepted
/// something. `accept` is asked of numbers with fewer `bits` only; all are finite, det M may be 0.
bool simplify(Case_numbers& numbers, const std::function<bool(const Case_numbers&)>& accept);

}  // namespace tetracone::verify

#endif
