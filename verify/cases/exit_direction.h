#ifndef TETRACONE_VERIFY_CASES_EXIT_DIRECTION_H
#define TETRACONE_VERIFY_CASES_EXIT_DIRECTION_H

#include "verify/cases/case.h"

#include <array>
#include <string>

namespace tetracone::verify {

/// Returns the direction in which a case's first body is to leave the second, which is not 0. The family's is taken if
/// it knows exits along one. Else the case's number chooses: an axis, small integers, the normal of a face, an edge, or
/// the vector between two vertices.
std::array<kernel::Rational, 3> exit_direction(const Object_case& c);

/// Returns a direction as a query takes it.
std::array<std::string, 3> as_texts(const std::array<kernel::Rational, 3>& direction);

}  // namespace tetracone::verify

#endif
