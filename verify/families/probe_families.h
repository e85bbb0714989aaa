#ifndef TETRACONE_VERIFY_FAMILIES_PROBE_FAMILIES_H
#define TETRACONE_VERIFY_FAMILIES_PROBE_FAMILIES_H

#include "verify/cases/probe_case.h"
#include "verify/cases/random.h"

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

namespace tetracone::verify {

/// A body with the data by which points and rays are placed.
struct Probed_body {
  std::shared_ptr<const covering::Polyhedron> body;
  kernel::Vertex origin{};       ///< of its covering
  kernel::Vertex low{}, high{};  ///< its box
};

/// A point, and the direction of the ray from it; 0 for a point alone.
struct Probe {
  kernel::Vertex from{}, direction{};
};

/// A named generator of points or rays in degenerate positions to a body: (seed, index) -> case.
struct Probe_family {
  int number;                  ///< from 1, points and rays together
  std::string_view name;       ///< of lower-case words joined by '-'; the first is point or ray
  std::string_view what;       ///< what its cases have in common, in a line
  std::string_view parameter;  ///< what the parameter means
  std::vector<double> sweep;   ///< the values that the parameter takes in turn
  std::vector<std::string_view>
      from;  ///< the object families that bodies are taken from; none: from all but the largest

  Probe (*make)(Random& random, const Probed_body& body, double parameter);

  /// Case `index` of the family. `cases_a_body` consecutive cases share one body of at most `most_faces` faces, which
  /// is closed for cases about points. The case is equal on every machine and in any order of calls.
  Probe_case probe_case(std::uint64_t seed, std::uint64_t index) const;

  static constexpr std::uint64_t cases_a_body = 16;
  static constexpr std::size_t most_faces = 300;
};

/// Returns the families of points, in the order of their numbers.
const std::vector<Probe_family>& point_families();

/// Returns the families of rays, in the order of their numbers.
const std::vector<Probe_family>& ray_families();

/// Returns the family of points or rays of this name; null when there is none.
const Probe_family* find_probe_family(std::string_view name);

}  // namespace tetracone::verify

#endif
