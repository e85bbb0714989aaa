#ifndef TETRACONE_VERIFY_TEST_SUPPORT_INTEGER_FORMS_H
#define TETRACONE_VERIFY_TEST_SUPPORT_INTEGER_FORMS_H

#include "tetracone/kernel/motion/integer_form.h"

#include <array>
#include <cstddef>

namespace tetracone::verify {

/// Returns the form with these coefficients.
template <std::size_t N>
kernel::Integer_form form(const std::array<int, N>& coefficients)
{
  kernel::Integer_form f;
  for (const int c : coefficients) f.push_back(c);
  return f;
}

}  // namespace tetracone::verify

#endif
