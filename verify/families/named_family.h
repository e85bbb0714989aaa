#ifndef TETRACONE_VERIFY_FAMILIES_NAMED_FAMILY_H
#define TETRACONE_VERIFY_FAMILIES_NAMED_FAMILY_H

#include "verify/cases/case.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tetracone::verify {

/// The common part of all families. A family is a named generator of cases, (seed, index) -> case; its parameter sweeps
/// from far from degenerate to exactly degenerate. A case is equal on every machine and in any order of calls.
struct Named_family {
  std::string_view name;       ///< of lower-case words joined by '-'
  std::string_view what;       ///< what its cases have in common, in a line
  std::string_view parameter;  ///< what the parameter means; empty where there is none
  std::vector<double> sweep;   ///< the values that the parameter takes in turn
  int number = 0;              ///< from 1, among the families of one kind

  /// Returns the origin of case `index`, with its parameter.
  Origin origin(std::uint64_t seed, std::uint64_t index) const
  {
    return {std::string(name), seed, index, sweep.empty() ? 0 : sweep[index % sweep.size()]};
  }
};

/// Returns the families with their numbers, in order from `first`.
template <class Families>
Families numbered(Families families, int first = 1)
{
  for (auto& family : families) family.number = first++;
  return families;
}

/// Returns the family of this name; null when there is none.
template <class Family>
const Family* find_named(const std::vector<Family>& families, std::string_view name)
{
  const auto found = std::ranges::find(families, name, &Family::name);
  return found == families.end() ? nullptr : &*found;
}

}  // namespace tetracone::verify

#endif
