#ifndef TETRACONE_VERIFY_TEST_SUPPORT_PRINT_OUTCOME_H
#define TETRACONE_VERIFY_TEST_SUPPORT_PRINT_OUTCOME_H

#include "verify/subjects/object_subject.h"

#include <array>
#include <cstddef>
#include <ostream>

namespace tetracone::verify {

/// For Boost.Test's messages.
inline std::ostream& operator<<(std::ostream& out, Outcome outcome)
{
  constexpr std::array names = {"no", "yes", "not asked", "failed"};
  return out << names[static_cast<std::size_t>(outcome)];
}

}  // namespace tetracone::verify

#endif
