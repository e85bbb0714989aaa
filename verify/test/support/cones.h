#ifndef TETRACONE_VERIFY_TEST_SUPPORT_CONES_H
#define TETRACONE_VERIFY_TEST_SUPPORT_CONES_H

#include "tetracone/tetratree/paper/tetra_cone.h"
#include "verify/test/support/scenes.h"

#include <utility>
#include <vector>

/// Cones about an origin.
namespace tetracone::verify::scenes {

/// Returns a random cone of this level. Requires level >= 1, the octants'.
inline tetratree::Tetra_cone random_cone(Random& random, int level)
{
  tetratree::Tetra_cone cone = tetratree::Tetra_cone::octant(integer(random, 0, 7));
  for (; level > 1; --level) cone = cone.child(integer(random, 0, 3));
  return cone;
}

/// Returns all cones of this level. Requires level >= 1.
inline std::vector<tetratree::Tetra_cone> cones_of_level(int level)
{
  std::vector<tetratree::Tetra_cone> cones;
  for (int k = 0; k < 8; ++k) cones.push_back(tetratree::Tetra_cone::octant(k));
  for (int l = 1; l < level; ++l) {
    std::vector<tetratree::Tetra_cone> finer;
    for (const tetratree::Tetra_cone& cone : cones)
      for (int k = 0; k < 4; ++k) finer.push_back(cone.child(k));
    cones = std::move(finer);
  }
  return cones;
}

/// Returns a ray of the cone, counted modulo three.
inline rationals::Vector ray(const tetratree::Tetra_cone& cone, int k)
{
  const tetratree::Direction& d = cone.ray[k % 3];
  return {d[0], d[1], d[2]};
}

/// Returns the determinant of the cone's rays.
inline Rational determinant(const tetratree::Tetra_cone& cone)
{
  return rationals::determinant(ray(cone, 0), ray(cone, 1), ray(cone, 2));
}

}  // namespace tetracone::verify::scenes

#endif
