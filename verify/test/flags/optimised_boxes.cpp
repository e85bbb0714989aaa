// Parts that touch, and are tiny beside their body, must meet under all optimisations that users may choose. One of
// them made boxes that did not hold their elements.
#include "tetracone/tetratree/query/bvh8_collision.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <random>

namespace {

using tetracone::covering::Polyhedron;
using tetracone::covering::Vertex;

void add_tetrahedron(Polyhedron& to, const std::array<Vertex, 4>& corners)
{
  const auto first = tetracone::covering::Index(to.vertices.size());
  to.vertices.insert(to.vertices.end(), corners.begin(), corners.end());
  to.add_polygon({first, first + 1, first + 2});
  to.add_polygon({first, first + 3, first + 1});
  to.add_polygon({first, first + 2, first + 3});
  to.add_polygon({first + 1, first + 3, first + 2});
}

}  // namespace

int main()
{
  std::mt19937_64 random(1);
  const auto corners = [&] {
    std::array<Vertex, 4> made;
    for (Vertex& v : made)
      for (double& x : v) x = double(random() % 7);
    return made;
  };
  int asked = 0, missed = 0;
  for (int exponent = 10; exponent <= 40; ++exponent)
    for (int k = 0; k < 20; ++k) {
      const std::array<Vertex, 4> near = corners();
      std::array<Vertex, 4> far = near, other = corners();
      for (Vertex& v : far) v[std::size_t(k % 3)] += std::ldexp(1.0, exponent);
      other[0] = near[0];
      Polyhedron a, b;
      add_tetrahedron(a, near);
      add_tetrahedron(a, far);
      add_tetrahedron(b, other);
      const tetracone::tetratree::Bvh8 tree_a(a), tree_b(b);
      tetracone::tetratree::Bvh8_collision<> query(tree_a, tree_b);
      ++asked;
      missed += !query({}, {}, tetracone::kernel::Question::surface);
    }
  std::printf("%d of %d contacts missed\n", missed, asked);
  return missed == 0 ? 0 : 1;
}
