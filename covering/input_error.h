#ifndef TETRACONE_COVERING_INPUT_ERROR_H
#define TETRACONE_COVERING_INPUT_ERROR_H

#include "kernel/input_error.h"

namespace tetracone::covering {

using kernel::Input_error;

}  // namespace tetracone::covering

#endif
