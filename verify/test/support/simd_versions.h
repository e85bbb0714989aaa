#ifndef TETRACONE_VERIFY_TEST_SUPPORT_SIMD_VERSIONS_H
#define TETRACONE_VERIFY_TEST_SUPPORT_SIMD_VERSIONS_H

#include "tetracone/kernel/simd/simd.h"

#include <vector>

namespace tetracone::verify {

/// Returns the versions that this processor supports.
template <class Function>
std::vector<Function*> versions_here(const std::vector<kernel::Simd_version<Function>>& versions)
{
  std::vector<Function*> found;
  for (const auto& version : versions)
    if (version.target & (hwy::SupportedTargets() | HWY_STATIC_TARGET)) found.push_back(version.function);
  return found;
}

}  // namespace tetracone::verify

#endif
