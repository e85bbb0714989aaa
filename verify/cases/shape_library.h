#ifndef TETRACONE_VERIFY_CASES_SHAPE_LIBRARY_H
#define TETRACONE_VERIFY_CASES_SHAPE_LIBRARY_H

#include "tetracone/covering/polyhedron.h"
#include "verify/cases/exact_map.h"
#include "verify/cases/random.h"

#include <array>
#include <memory>
#include <vector>

/// The bodies of the object families. Each is made once: cases share it, and with it a subject's prepared trees.
namespace tetracone::verify {

/// True when `fetch_models.sh` has left `elephant.off`, which stands for all its meshes, under .cache/models of the
/// source folder. The cases of a seed depend on this; a campaign records it.
bool real_meshes_available();

}  // namespace tetracone::verify

namespace tetracone::verify::object_family {

using covering::Index;
using Body = std::shared_ptr<const covering::Polyhedron>;

/// A triangle of a face.
struct Face_triangle {
  Index face;
  std::array<Index, 3> corners;
};

/// An edge between two faces that both support the body. Let a plane through the edge have any positive combination of
/// their normals as normal. The plane leaves the whole body on one side. It meets the body only on the edge's line,
/// where other edges may lie.
struct Hull_edge {
  Index from, to;
  std::array<Index, 2> faces;
};

/// A body with the features where a plane may touch it.
struct Shape {
  explicit Shape(Body body);

  Body body;
  std::vector<Exact_vector> normals;  ///< of each face, outward where the body is, of no particular length; zero of a
                                      ///< flat face
  std::vector<Face_triangle> triangles;  ///< of all faces that are not flat
  std::vector<std::size_t> hull;   ///< numbers of the triangles whose plane leaves the whole body on its inner side
  std::vector<std::size_t> inner;  ///< numbers of the others: in hollows, of cavities and tunnels
  std::vector<std::array<Index, 2>> edges;  ///< undirected, each once
  std::vector<Hull_edge> hull_edges;
  bool is_box = false;  ///< a box of axis-parallel faces

  Exact_vector vertex(Index v) const { return exact(body->vertices[v]); }
};

/// Blocks of few flat faces, of size about 1, on a grid of 1/64. They are boxes, a tetrahedron, an octahedron, a roof,
/// an L, an arrowhead, and faces with holes. Others are a cavity and voxel solids with edges of four faces.
const std::vector<Shape>& blocks();

/// The numbers of some blocks.
inline constexpr std::size_t unit_cube_block = 0, tetrahedron_block = 2, roof_block = 4, tunnel_block = 7,
                             complex_block = 8, cavity_block = 10;

/// Small convex blocks and an L, of size about 1/8, that fit into the cavities and tunnels of the blocks.
const std::vector<Shape>& pebbles();

/// Triangle meshes of 72 to 200 triangles, of size about 1; the last is a knot of 640. With `real_meshes_available()`,
/// some are decimated scans and parts; without, generated bodies replace them.
const std::vector<Shape>& meshes();

/// Returns a block, or sometimes a mesh.
const Shape& any_shape(Random& random);
/// Returns such a shape that has an edge on its hull.
const Shape& with_hull_edges(Random& random);
/// Returns any block.
const Shape& any_block(Random& random);
/// Returns any pebble.
const Shape& any_pebble(Random& random);
/// Returns a block that is its own hull.
const Shape& any_convex(Random& random);

/// Returns the shape's body with coordinate i of each vertex mapped x -> 2^exponents[i] x + shift and rounded. Equal
/// arguments return the same object. Requires that faces stay planar, as they do if the result is exact.
Body moved_copy(const Shape& shape, const std::array<int, 3>& exponents, double shift = 0);
inline Body moved_copy(const Shape& shape, int exponent, double shift = 0)
{
  return moved_copy(shape, std::array{exponent, exponent, exponent}, shift);
}

/// Returns the vertices whose dot product with `direction` is least, exactly, in ascending order.
std::vector<Index> lowest(const std::vector<kernel::Vertex>& vertices, const Exact_vector& direction);

// Bodies of a single case.

/// Returns the tetrahedron, outward if it has a volume.
Body tetrahedron(const std::array<kernel::Vertex, 4>& corners);

/// Returns the pyramid over an exactly planar base, outward if the base runs clockwise seen from the apex.
Body pyramid(const std::vector<kernel::Vertex>& base, const kernel::Vertex& apex);

/// Returns the polyhedron as a body.
Body shared(covering::Polyhedron polyhedron);

}  // namespace tetracone::verify::object_family

#endif
