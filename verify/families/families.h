#ifndef TETRACONE_VERIFY_FAMILIES_FAMILIES_H
#define TETRACONE_VERIFY_FAMILIES_FAMILIES_H

#include "verify/cases/case.h"
#include "verify/cases/random.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace tetracone::verify {

/// A named generator of cases on both levels: (seed, index) -> case. Its parameter sweeps from far from degenerate to
/// exactly degenerate.
struct Family {
  int number;                  ///< from 1
  std::string_view name;       ///< of lower-case words joined by '-'
  std::string_view what;       ///< what its cases have in common, in a line
  std::string_view parameter;  ///< what the parameter means
  std::vector<double> sweep;   ///< the values that the parameter takes in turn

  Predicate_case (*predicate)(Random& random, double parameter);
  Object_case (*object)(Random& random, double parameter);

  /// Case `index` of the family. Its parameter is the sweep's value `index` modulo its length; everything else is drawn
  /// from (seed, number, level, index). The case is equal on every machine and in any order of calls.
  Predicate_case predicate_case(std::uint64_t seed, std::uint64_t index) const;
  Object_case object_case(std::uint64_t seed, std::uint64_t index) const;
};

/// Returns all families, in the order of their numbers.
const std::vector<Family>& families();

/// Returns the family of this name; null when there is none.
const Family* find_family(std::string_view name);

}  // namespace tetracone::verify

#endif
