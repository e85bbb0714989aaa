#ifndef TETRACONE_VERIFY_FUZZ_FUZZ_BODY_H
#define TETRACONE_VERIFY_FUZZ_FUZZ_BODY_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/pose.h"
#include "verify/fuzz/doubles.h"

#include <array>
#include <cstddef>

namespace tetracone::verify {

/// A closed surface of triangles on four to six vertices, flat or not, or one triangle and its back.
inline covering::Polyhedron fuzz_body(Doubles& doubles)
{
  constexpr int apexes_about[] = {0, 3, 3, 4};
  const int kind = doubles.byte() % 4, corners = apexes_about[kind];
  covering::Polyhedron body;
  body.vertices.resize(kind == 0 ? 3 : kind == 1 ? 4 : std::size_t(corners) + 2);
  for (kernel::Vertex& v : body.vertices)
    for (double& x : v) x = doubles.next();
  if (kind == 0) {
    body.add_polygon({0, 1, 2});
    body.add_polygon({0, 2, 1});
    return body;
  }
  // A ring of corners about an axis, closed by one apex and a triangle or by two apexes.
  for (covering::Index k = 0; k < covering::Index(corners); ++k) {
    const covering::Index next = (k + 1) % covering::Index(corners), top = covering::Index(corners);
    body.add_polygon({k, next, top});
    if (kind != 1) body.add_polygon({next, k, top + 1});
  }
  if (kind == 1) body.add_polygon({0, 2, 1});
  return body;
}

/// A pose of any twelve entries. In one case of four they are divided by 3 times a power of two. Their nearest doubles
/// may all be 0 then. det M may be 0.
inline kernel::Pose fuzz_pose(Doubles& doubles)
{
  std::array<double, 12> entries;
  for (double& x : entries) x = doubles.next();
  if (doubles.byte() % 4 != 3) return kernel::Pose(entries);
  mpz_class divisor = 3;
  divisor <<= 16 * doubles.byte();
  std::array<kernel::Rational, 12> fractions;
  for (std::size_t k = 0; k < 12; ++k) fractions[k] = kernel::Rational(entries[k]) / divisor;
  return kernel::Pose(fractions);
}

}  // namespace tetracone::verify

#endif
