#ifndef TETRACONE_VERIFY_FAMILIES_DISTANCE_FAMILIES_H
#define TETRACONE_VERIFY_FAMILIES_DISTANCE_FAMILIES_H

#include "verify/families/families.h"

#include <string_view>
#include <vector>

namespace tetracone::verify {

/// Returns the families of separate bodies with degenerate distances, on the object level only: many pairs of features
/// are nearest, or two that differ slightly. They are numbered from 50, apart from `families()`.
const std::vector<Family>& distance_families();

}  // namespace tetracone::verify

#endif
