#ifndef TETRACONE_VERIFY_TEST_SUPPORT_SAID_H
#define TETRACONE_VERIFY_TEST_SUPPORT_SAID_H

#include "tetracone/tetratree/door/tetracone.h"

#include <string>

namespace tetracone::verify {

/// Returns the message of the Error that `ask` throws; empty when there is none.
template <class Ask>
std::string said(const Ask& ask)
{
  try {
    ask();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace tetracone::verify

#endif
