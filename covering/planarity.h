#ifndef TETRACONE_COVERING_PLANARITY_H
#define TETRACONE_COVERING_PLANARITY_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/number/nearest_root.h"
#include "tetracone/kernel/number/number.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cassert>
#include <cstddef>
#include <vector>

namespace tetracone::covering {

/// The planarity of a face.
enum class Planarity {
  degenerate,  ///< all corners on one line or in one point
  planar,      ///< all corners exactly on one plane
  off_plane    ///< some corner off the plane of others
};

/// Returns the vertices of all loops of face `f`, in their order, each as often as loops name it.
inline std::vector<Index> corners(const Polyhedron& polyhedron, Index f)
{
  std::vector<Index> result;
  for (std::size_t k = 0; k < polyhedron.loop_count(f); ++k) {
    const Loop loop = polyhedron.loop(f, k);
    result.insert(result.end(), loop.begin(), loop.end());
  }
  return result;
}

/// Returns the planarity of face `f`, exactly (CGAL's filtered predicates), whatever the order of the corners.
inline Planarity planarity(const Polyhedron& polyhedron, Index f)
{
  using K = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto point = [&polyhedron](Index v) {
    const Vertex& p = polyhedron.vertices[v];
    return K::Point_3(p[0], p[1], p[2]);
  };
  const std::vector<Index> all = corners(polyhedron, f);
  const K::Point_3 p = point(all[0]);
  std::size_t k = 1;
  while (k < all.size() && point(all[k]) == p) ++k;
  if (k == all.size()) return Planarity::degenerate;
  const K::Point_3 q = point(all[k]);
  while (k < all.size() && CGAL::collinear(p, q, point(all[k]))) ++k;
  if (k == all.size()) return Planarity::degenerate;
  const K::Point_3 r = point(all[k]);
  for (; k < all.size(); ++k)
    if (!CGAL::coplanar(p, q, r, point(all[k]))) return Planarity::off_plane;
  return Planarity::planar;
}

/// The deviation of a face from being planar.
struct Off_plane {
  Index face;
  Index vertex;                       ///< the one farthest from the plane, the first of equals
  kernel::Rational squared_distance;  ///< of that vertex, exact
  double distance;                    ///< the double nearest to its square root
};

/// Returns the largest distance of a corner of face `f` from the plane through three of its corners p, q, r. p is the
/// first corner of the face, and q is the farthest from p. r spans the largest triangle with p and q. Each is the first
/// of equals. The plane is therefore spanned by a large triangle, exact, and depends on nothing but the face. Requires
/// `Planarity::off_plane`.
inline Off_plane deviation(const Polyhedron& polyhedron, Index f)
{
  using kernel::cross, kernel::dot, kernel::Rational;
  using Vector = kernel::Rational_point;
  const std::vector<Index> all = corners(polyhedron, f);
  const auto exact = [&](Index v) { return kernel::exact_point(polyhedron.vertices[v]); };
  std::vector<Vector> offset;
  offset.reserve(all.size());
  for (const Index v : all) offset.push_back(kernel::difference(exact(v), exact(all[0])));

  Vector q{}, normal{};
  Rational largest = 0;
  for (const Vector& candidate : offset)
    if (Rational length = dot(candidate, candidate); length > largest) {
      largest = length;
      q = candidate;
    }
  largest = 0;
  for (const Vector& candidate : offset) {
    const Vector product = cross(q, candidate);
    if (Rational area = dot(product, product); area > largest) {
      largest = area;
      normal = product;
    }
  }
  assert(largest != 0);
  Off_plane result{f, all[0], 0, 0};
  Rational height = 0;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (Rational candidate = abs(dot(normal, offset[k])); candidate > height) {
      height = candidate;
      result.vertex = all[k];
    }
  result.squared_distance = height * height / largest;
  result.distance = kernel::nearest_root(result.squared_distance);
  return result;
}

}  // namespace tetracone::covering

#endif
