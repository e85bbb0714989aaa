#ifndef TETRACONE_VERIFY_FAMILIES_PROBE_FAMILIES_H
#define TETRACONE_VERIFY_FAMILIES_PROBE_FAMILIES_H

#include "verify/cases/probe_case.h"
#include "verify/cases/random.h"
#include "verify/families/named_family.h"

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

/// Returns a body with these data. Requires a vertex.
Probed_body probed(std::shared_ptr<const covering::Polyhedron> body);

/// A point, and the direction of the ray from it; 0 for a point alone.
struct Probe {
  kernel::Vertex from{}, direction{};
};

/// A family of points or rays in degenerate positions to a body. Points and rays are numbered together, and the first
/// word of a name is point or ray.
struct Probe_family : Named_family {
  std::vector<std::string_view>
      from;  ///< the object families that bodies are taken from; none: from all but the largest

  Probe (*make)(Random& random, const Probed_body& body, double parameter);

  /// Case `index` of the family. `cases_a_body` consecutive cases share one body of at most `most_faces` faces, which
  /// is closed for cases about points.
  Probe_case probe_case(std::uint64_t seed, std::uint64_t index) const;

  static constexpr std::uint64_t cases_a_body = 16;
  static constexpr std::size_t most_faces = 300;
};

/// Returns the families of points, in the order of their numbers.
const std::vector<Probe_family>& point_families();

/// Returns the families of rays, in the order of their numbers.
const std::vector<Probe_family>& ray_families();

}  // namespace tetracone::verify

#endif
