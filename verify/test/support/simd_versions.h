#ifndef TETRACONE_VERIFY_TEST_SUPPORT_SIMD_VERSIONS_H
#define TETRACONE_VERIFY_TEST_SUPPORT_SIMD_VERSIONS_H

#include "tetracone/kernel/simd/simd.h"

#include <type_traits>
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

/// The versions of a function of this unit, by its name, that this processor supports.
#define TETRACONE_VERSIONS_HERE(function)                                                               \
  ::tetracone::verify::versions_here<std::remove_reference_t<decltype(HWY_STATIC_DISPATCH(function))>>( \
      TETRACONE_SIMD_VERSIONS(function))

#endif
