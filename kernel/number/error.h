#ifndef TETRACONE_KERNEL_NUMBER_ERROR_H
#define TETRACONE_KERNEL_NUMBER_ERROR_H

#include <stdexcept>

namespace tetracone {

/// An error of a caller or of a file. `what()` is one line, "what is wrong; what was expected". Every exception that
/// the library throws is an Error, except std::bad_alloc.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace tetracone

#endif
