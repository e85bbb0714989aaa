#ifndef TETRACONE_VERIFY_CASES_SHAPE_GENERATORS_H
#define TETRACONE_VERIFY_CASES_SHAPE_GENERATORS_H

#include "tetracone/covering/polyhedron.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The objects of the experiments. All are closed, and outward unless stated otherwise.
namespace tetracone::verify {

using covering::Polyhedron;
using kernel::Vertex;

// Polyhedra of few, flat faces. Their coordinates are dyadic numbers of few bits and every face is exactly planar.

/// The box from corner `low` to corner `high`: 8 vertices, 6 faces. Requires low < high in each coordinate.
Polyhedron box(const Vertex& low, const Vertex& high);

/// The box from (0, 0, 0) to (1, 1, 1).
Polyhedron unit_cube();

/// Returns the box from (-1, -1, low) to (1, 1, high) in 4 n (n + 2) triangles. Its top and its bottom are cut into
/// n x n squares. Requires 0 < n and low < high.
inline Polyhedron plate(int n, double low, double high)
{
  Polyhedron body;
  for (const double z : {low, high})
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) body.vertices.push_back({2.0 * i / n - 1, 2.0 * j / n - 1, z});
  const auto number = [&](bool is_top, int i, int j) {
    return static_cast<covering::Index>(((is_top ? n + 1 : 0) + i) * (n + 1) + j);
  };
  const auto add = [&](covering::Index p, covering::Index q, covering::Index r, covering::Index s) {
    body.add_polygon({p, q, r});
    body.add_polygon({p, r, s});
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      add(number(false, i, j), number(false, i, j + 1), number(false, i + 1, j + 1), number(false, i + 1, j));
      add(number(true, i, j), number(true, i + 1, j), number(true, i + 1, j + 1), number(true, i, j + 1));
    }
  for (int k = 0; k < n; ++k) {
    const auto wall = [&](const std::array<int, 2>& p, const std::array<int, 2>& q) {
      add(number(false, p[0], p[1]), number(false, q[0], q[1]), number(true, q[0], q[1]), number(true, p[0], p[1]));
    };
    wall({k, 0}, {k + 1, 0});
    wall({k + 1, n}, {k, n});
    wall({0, k + 1}, {0, k});
    wall({n, k}, {n, k + 1});
  }
  return body;
}

/// The box [-outer, outer]^3 without the box (-inner, inner)^3: two shells, the inner one reversed.
/// Requires 0 < inner < outer.
Polyhedron box_with_cavity(double outer, double inner);

/// A box with a square tunnel from bottom to top: 16 vertices, 10 faces, two of them with a hole; genus 1.
Polyhedron prism_with_tunnel();

/// Returns the replacement of the paper's "complex polyhedron" (JS08 Fig. 15a). It has that one's counts, 32 vertices
/// and 18 faces, and a shape of our own: a three-armed wedge with a square and a triangular tunnel. Its genus is 2, and
/// two of its faces have nine corners and two holes, and are not convex. It is centred near 0, with a radius of 1.1.
Polyhedron complex_one();

/// The replacement of the paper's "complex polyhedron II" (JS08 Fig. 15b), with its counts, 44 vertices and 29 faces,
/// and a shape of our own. It is an L-shaped block with a slanted square tunnel, a triangular pit, an arrowhead boss
/// (not convex), a sunk pyramid and a raised one. Genus 1; five faces with six holes. Centred near 0, radius 1.
Polyhedron complex_two();

/// The union of the unit cubes (x, y, z) + [0, 1]^3 for which bits[x + nx (y + ny z)] is set. Its faces are unit
/// squares between set and unset cubes. Cubes that touch only in an edge or a corner share its vertices: the surface is
/// closed, but no manifold. Requires nx ny nz bits.
Polyhedron voxel_solid(const std::vector<bool>& bits, int nx, int ny, int nz);

// Triangle meshes of any size. Equal arguments give equal meshes on every machine.

/// A star-shaped body about 0 with radii between 0.5 and 1.5, of 8 n^2 triangles, for the nearest n. Requires at least
/// 8 triangles.
Polyhedron blob(std::size_t triangles, std::uint64_t seed);

/// A tube along the trefoil knot, far from star-shaped, of 16 n triangles for the nearest n, radius 1, genus 1.
/// Requires at least 640 triangles; with fewer the tube would meet itself.
Polyhedron torus_knot(std::size_t triangles);

/// The torus knot as a tube of about sqrt(triangles / 20) sides, rounder with more triangles; all triangles have about
/// one shape. The geometry is one at any size. The number of triangles differs from `triangles` by less than two per
/// ring. Requires at least 640 triangles.
Polyhedron round_torus_knot(std::size_t triangles);

// Real meshes.

/// Returns the mesh FOLDER/meshes/NAME.off, one of those that `fetch_models.sh FOLDER` downloads; nothing when it does
/// not exist. A caller without it reports that and names the script. Throws Input_error for a file that cannot be read.
std::optional<Polyhedron> demo_mesh(const std::filesystem::path& folder, const std::string& name);

/// Returns the mesh simplified to exactly `faces` triangles by edge collapses in the order of Lindstrom and Turk's cost
/// (CGAL's Surface_mesh_simplification). The result is deterministic, closed and of the same genus. It is a model of
/// its own and may intersect itself. Throws std::invalid_argument when the mesh is not a closed manifold of at least
/// `faces` triangles, or when `faces` is odd. It also throws it when no further edge can be collapsed.
Polyhedron decimate(const Polyhedron& mesh, std::size_t faces);

/// Returns the polyhedron moved and scaled, with rounding, so that `centroid` is about 0 and `radius` about 1.
Polyhedron normalised(const Polyhedron& polyhedron);

/// The replacements of the paper's meshes; nothing when `demo_mesh` has none. For its cat (JS08 Fig. 15c) of 760 faces:
/// the Stanford bunny, decimated and normalised. For its horse (Fig. 15d) of 7172 faces: a dinosaur on four legs.
std::optional<Polyhedron> small_mesh(const std::filesystem::path& folder);
std::optional<Polyhedron> large_mesh(const std::filesystem::path& folder);

/// Returns the mean of the vertices, rounded. Requires a vertex.
Vertex centroid(const Polyhedron& polyhedron);

/// Returns the distance from the centroid to the farthest vertex, rounded.
double radius(const Polyhedron& polyhedron);

}  // namespace tetracone::verify

#endif
