// Makes a small body and up to eight points and rays from raw bytes. The locator's positions and the tree's hits must
// be those of all pairs of elements in rational arithmetic.

#include "tetracone/tetratree/locator/point_locator.h"
#include "tetracone/tetratree/query/bvh8_rays.h"
#include "verify/fuzz/doubles.h"
#include "verify/fuzz/fuzz_body.h"
#include "verify/fuzz/fuzz_targets.h"
#include "verify/truth/point_truth.h"
#include "verify/truth/ray_truth.h"

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <vector>

using namespace tetracone;
using kernel::Vertex;

namespace {

/// Any doubles, or a vertex of the body, or a point between two, as doubles have it.
Vertex point(verify::Doubles& doubles, const covering::Polyhedron& body)
{
  const auto vertex = [&]() -> const Vertex& { return body.vertices[doubles.byte() % body.vertices.size()]; };
  const int kind = doubles.byte() % 4;
  if (kind == 0) return vertex();
  Vertex p;
  if (kind == 1) {
    const Vertex &from = vertex(), &to = vertex();
    for (std::size_t k = 0; k < 3; ++k) p[k] = from[k] / 2 + to[k] / 2;
    return p;
  }
  for (double& x : p) x = doubles.next();
  return p;
}

}  // namespace

void tetracone::verify::fuzz_points(const std::uint8_t* data, std::size_t size)
{
  verify::Doubles doubles(data, size, 0x1p1023);
  const covering::Polyhedron body = verify::fuzz_body(doubles);
  const tetratree::Bvh8 tree(body);
  const tetratree::Point_locator locator(tree.model());
  tetratree::Bvh8_rays caster(tree);
  const verify::Point_truth place(body);
  const verify::Ray_truth meets(body);
  for (int k = 0; k < 8 && (k == 0 || !doubles.empty()); ++k) {
    const Vertex from = point(doubles, body);
    same(int(locator.locate(from)) == place(from));
    const Vertex to = point(doubles, body);
    const bool is_way = doubles.byte() % 2 == 0;
    Vertex direction = to;
    if (is_way)
      for (std::size_t i = 0; i < 3; ++i) direction[i] = to[i] / 2 - from[i] / 2;
    if (direction == Vertex{0, 0, 0}) continue;
    const tetratree::Ray ray{from, direction};
    std::vector<tetratree::Ray_hit> hits;
    for (const auto& [t, face] : meets(from, direction)) hits.push_back({face, kernel::nearest_double(t)});
    same(caster.all(ray) == hits);
    same(caster.first(ray) == (hits.empty() ? std::nullopt : std::optional(hits[0])));
  }
}
