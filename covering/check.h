#ifndef TETRACONE_COVERING_CHECK_H
#define TETRACONE_COVERING_CHECK_H

#include "tetracone/covering/covering.h"
#include "tetracone/covering/edge_uses.h"
#include "tetracone/covering/orient.h"
#include "tetracone/covering/planarity.h"
#include "tetracone/covering/polyhedron.h"
#include "tetracone/covering/union_find.h"
#include "tetracone/kernel/number/number.h"

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace tetracone::covering {

/// Returns the faces of a polyhedron by connected shells; faces that share a vertex are in one shell. The faces of each
/// shell ascend. The shells are in the order of their first faces.
inline std::vector<std::vector<Index>> shell_faces(const Polyhedron& polyhedron)
{
  Union_find sets(polyhedron.vertices.size());
  const auto some_vertex = [&polyhedron](Index f) { return polyhedron.loop(f, 0)[0]; };
  for (Index f = 0; f < polyhedron.face_count(); ++f)
    for (std::size_t k = 0; k < polyhedron.loop_count(f); ++k)
      for (const Index v : polyhedron.loop(f, k)) sets.join(v, some_vertex(f));
  return grouped_faces(polyhedron.face_count(), sets, some_vertex);
}

/// Returns the connected shells, each a polyhedron of its own with only the vertices that it uses.
inline std::vector<Polyhedron> shells(const Polyhedron& polyhedron)
{
  std::vector<Polyhedron> result;
  const std::vector<bool> as_it_stands(polyhedron.face_count());
  for (const auto& faces : shell_faces(polyhedron)) result.push_back(part(polyhedron, faces, as_it_stands));
  return result;
}

/// True when the faces, glued along their edges, are an oriented 2-manifold without border. Then every edge is used
/// once in each direction, and the corners around each vertex form one cycle. Vertices of no face do not count.
inline bool is_manifold(const Polyhedron& polyhedron)
{
  const auto uses = edge_uses(polyhedron);
  bool manifold = true;
  for_each_edge(uses,
                [&](std::span<const Edge_use> edge) { manifold = manifold && edge.size() == 2 && surplus(edge) == 0; });
  if (!manifold) return false;
  // Corner (a, v, b) leads from its outgoing edge (v, b) to the corner whose incoming edge is (b, v).
  struct Corner {
    Index from, vertex, to;
  };
  std::vector<Corner> corners;
  for (Index f = 0; f < polyhedron.face_count(); ++f)
    for (std::size_t k = 0; k < polyhedron.loop_count(f); ++k) {
      const Loop loop = polyhedron.loop(f, k);
      const std::size_t n = loop.size();
      for (std::size_t j = 0; j < n; ++j) corners.push_back({loop[(j + n - 1) % n], loop[j], loop[(j + 1) % n]});
    }
  const auto key = [](const Corner& corner) { return std::array{corner.vertex, corner.from}; };
  std::ranges::sort(corners, {}, key);
  for (std::size_t begin = 0, end = 0; begin < corners.size(); begin = end) {
    while (end < corners.size() && corners[end].vertex == corners[begin].vertex) ++end;
    std::size_t cycle = 0;
    std::size_t at = begin;
    do {
      const std::array next{corners[at].vertex, corners[at].to};
      const auto found = std::ranges::lower_bound(corners, next, {}, key);
      // An edge (a, a) has no use in `uses`.
      if (found == corners.end() || key(*found) != next) return false;
      at = static_cast<std::size_t>(found - corners.begin());
      ++cycle;
    } while (at != begin && cycle <= end - begin);
    if (cycle != end - begin) return false;
  }
  return true;
}

/// The orientation of a surface, by the sign of its signed volume. `mixed`: shells differ. `open`: it is not closed, or
/// has no face.
enum class Orientation { outward, inward, flat, mixed, open };

/// Returns the name of an orientation.
constexpr std::string_view to_string(Orientation orientation)
{
  constexpr std::array<std::string_view, 5> names = {"outward", "inward", "flat", "mixed", "open"};
  return names[std::size_t(orientation)];
}

/// The properties of one connected shell.
struct Shell {
  std::size_t vertices = 0, edges = 0, faces = 0, hole_loops = 0;
  bool closed = false;
  /// The Euler characteristic V - E + F - hole loops of the surface that the faces make when they are glued along their
  /// edges. A face with h hole loops counts 1 - h.
  std::ptrdiff_t euler = 0;
  std::optional<std::size_t> genus;        ///< of a 2-manifold without border
  std::optional<kernel::Rational> volume;  ///< `volume` of a closed shell
  Orientation orientation = Orientation::open;
};

/// A directed edge that is used more often than its reverse, and how often both are.
struct Open_edge {
  Index from, to;
  std::size_t uses, reverse_uses;
};

/// The properties of a polyhedron. Numbers of vertices and faces count from 0. Lists are complete and ascend.
struct Check {
  std::size_t vertices = 0;
  std::size_t used_vertices = 0;
  std::size_t faces = 0;
  std::size_t triangles = 0;  ///< faces of one loop of three corners
  std::size_t edges = 0;      ///< undirected, between two different vertex numbers
  std::size_t corners = 0;    ///< of all loops
  std::size_t hole_loops = 0;
  std::vector<Index> holed_faces;  ///< faces with hole loops

  bool closed = false;
  std::vector<Open_edge> open_edges;   ///< none where it is closed
  std::size_t border_edges = 0;        ///< edges used once
  std::size_t non_manifold_edges = 0;  ///< edges used more than twice

  std::vector<Shell> shells;                    ///< in the order of their first faces
  Orientation orientation = Orientation::open;  ///< of all shells; `mixed` where they differ
  std::optional<kernel::Rational> volume;       ///< `volume`, of a closed polyhedron

  std::vector<Off_plane> off_plane;                    ///< faces that are not exactly planar
  std::vector<Index> degenerate_faces;                 ///< faces with all corners on one line or in one point: area 0
  std::vector<std::array<Index, 2>> degenerate_edges;  ///< edges with both ends at equal coordinates, (a, a) among them
  std::vector<Index> repeated_vertices;                ///< vertices with the coordinates of one before them
  std::vector<Index> isolated_vertices;                ///< vertices of no face
};

/// Returns the counts of one connected shell, its genus, volume and orientation.
inline Shell check_shell(const Polyhedron& shell)
{
  Shell result;
  result.vertices = shell.vertices.size();
  result.faces = shell.face_count();
  const auto uses = edge_uses(shell);
  for_each_edge(uses, [&](std::span<const Edge_use>) { ++result.edges; });
  for (Index f = 0; f < shell.face_count(); ++f) result.hole_loops += shell.loop_count(f) - 1;
  result.closed = is_closed(shell);
  const auto signed_count = [](std::size_t n) { return static_cast<std::ptrdiff_t>(n); };
  result.euler = signed_count(result.vertices) - signed_count(result.edges) + signed_count(result.faces) -
                 signed_count(result.hole_loops);
  if (result.closed && is_manifold(shell)) result.genus = static_cast<std::size_t>((2 - result.euler) / 2);
  if (result.closed) {
    result.volume = volume(shell);
    const auto sign = CGAL::Sign(sgn(*result.volume));
    result.orientation = sign == CGAL::POSITIVE   ? Orientation::outward
                         : sign == CGAL::NEGATIVE ? Orientation::inward
                                                  : Orientation::flat;
  }
  return result;
}

namespace detail {

/// Counts faces and corners, and finds the faces and vertices that stand out.
inline void check_faces(const Polyhedron& polyhedron, Check& result)
{
  std::vector<bool> used(polyhedron.vertices.size());
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    if (polyhedron.is_triangle(f)) ++result.triangles;
    result.hole_loops += polyhedron.loop_count(f) - 1;
    if (polyhedron.loop_count(f) > 1) result.holed_faces.push_back(f);
    for_each_directed_edge(polyhedron, f, [&](Index a, Index b) {
      ++result.corners;
      used[a] = true;
      if (a == b) result.degenerate_edges.push_back({a, a});
    });
    switch (planarity(polyhedron, f)) {
      case Planarity::degenerate: result.degenerate_faces.push_back(f); break;
      case Planarity::planar: break;
      case Planarity::off_plane: result.off_plane.push_back(deviation(polyhedron, f)); break;
    }
  }
  result.used_vertices = static_cast<std::size_t>(std::ranges::count(used, true));
  for (Index v = 0; v < used.size(); ++v)
    if (!used[v]) result.isolated_vertices.push_back(v);
}

/// Returns the vertices with the coordinates of an earlier one, ascending.
inline std::vector<Index> repeated_vertices(const std::vector<Vertex>& vertices)
{
  const std::vector<Index> least = least_equal_vertices(vertices);
  std::vector<Index> repeated;
  for (Index v = 0; v < vertices.size(); ++v)
    if (least[v] != v) repeated.push_back(v);
  return repeated;
}

/// Counts edges, and finds the open, non-manifold and degenerate ones. `check_faces` has found the edges (a, a).
inline void check_edges(const Polyhedron& polyhedron, Check& result)
{
  const auto& vertices = polyhedron.vertices;
  const auto uses = edge_uses(polyhedron);
  for_each_edge(uses, [&](std::span<const Edge_use> edge) {
    ++result.edges;
    const Index a = edge[0].low, b = edge[0].high;
    if (edge.size() == 1) ++result.border_edges;
    if (edge.size() > 2) ++result.non_manifold_edges;
    if (vertices[a] == vertices[b]) result.degenerate_edges.push_back({a, b});
    const auto forward = static_cast<std::size_t>(std::ranges::count_if(edge, &Edge_use::forward));
    const std::size_t backward = edge.size() - forward;
    if (forward > backward) result.open_edges.push_back({a, b, forward, backward});
    if (forward < backward) result.open_edges.push_back({b, a, backward, forward});
  });
  std::ranges::sort(result.degenerate_edges);
  result.degenerate_edges.erase(std::unique(result.degenerate_edges.begin(), result.degenerate_edges.end()),
                                result.degenerate_edges.end());
  std::ranges::sort(result.open_edges, {}, [](const Open_edge& edge) { return std::array{edge.from, edge.to}; });
}

/// Returns the orientation that all shells have; `mixed` where they differ. Requires a shell.
inline Orientation common_orientation(const std::vector<Shell>& shells)
{
  const auto same = [&](const Shell& shell) { return shell.orientation == shells[0].orientation; };
  return std::ranges::all_of(shells, same) ? shells[0].orientation : Orientation::mixed;
}

}  // namespace detail

/// Returns all properties of a polyhedron that a user should know before collision queries, exactly. Requires only that
/// corners name existing vertices. In volumes, a face that is not planar is the fan of the covering from its W.
inline Check check(const Polyhedron& polyhedron)
{
  Check result;
  result.vertices = polyhedron.vertices.size();
  result.faces = polyhedron.face_count();
  detail::check_faces(polyhedron, result);
  result.repeated_vertices = detail::repeated_vertices(polyhedron.vertices);
  detail::check_edges(polyhedron, result);
  result.closed = result.open_edges.empty();

  for (const Polyhedron& shell : shells(polyhedron)) result.shells.push_back(check_shell(shell));
  if (result.closed) {
    result.volume = kernel::Rational(0);
    for (const Shell& shell : result.shells) *result.volume += *shell.volume;
    if (!result.shells.empty()) result.orientation = detail::common_orientation(result.shells);
  }
  return result;
}

}  // namespace tetracone::covering

#endif
