#ifndef TETRACONE_VERIFY_FAMILIES_DISTANCE_FAMILIES_H
#define TETRACONE_VERIFY_FAMILIES_DISTANCE_FAMILIES_H

#include "verify/families/families.h"

#include <string_view>
#include <vector>

namespace tetracone::verify {

/// Families of bodies apart, on the object level alone, on which distances are degenerate: many pairs of features are
/// the nearest, or two that differ by a little; their numbers follow those of `families()`.
const std::vector<Family>& distance_families();

/// The family of this name; null when there is none.
const Family* find_distance_family(std::string_view name);

}  // namespace tetracone::verify

#endif
