#ifndef TETRACONE_COVERING_ORIENT_H
#define TETRACONE_COVERING_ORIENT_H

#include "tetracone/covering/covering.h"
#include "tetracone/covering/edge_uses.h"
#include "tetracone/covering/polyhedron.h"
#include "tetracone/covering/union_find.h"

#include <cstddef>
#include <vector>

namespace tetracone::covering {

/// Returns the faces of a polyhedron in groups. Two faces are in one group where a chain of edges that are used exactly
/// twice leads from one to the other. (An edge with more uses does not say which of its faces go together.) The faces
/// of each group ascend. The groups are in the order of their first faces.
inline std::vector<std::vector<Index>> edge_groups(const Polyhedron& polyhedron)
{
  Union_find sets(polyhedron.face_count());
  const auto uses = edge_uses(polyhedron);
  for_each_edge(uses, [&](std::span<const Edge_use> edge) {
    if (edge.size() == 2) sets.join(edge[0].face, edge[1].face);
  });
  return grouped_faces(polyhedron.face_count(), sets, [](Index f) { return f; });
}

/// Returns which faces to turn so that the two uses of each edge that is used exactly twice run against each other. The
/// search is breadth-first from the first face of each group, which stays. In a group that cannot be oriented (a
/// Moebius band), the two uses of some edges still run the same way.
inline std::vector<bool> turns_across_edges(const Polyhedron& polyhedron)
{
  struct Neighbour {
    Index face;
    bool opposite;  // exactly one of the two is to be turned
  };
  std::vector<std::vector<Neighbour>> neighbours(polyhedron.face_count());
  const auto uses = edge_uses(polyhedron);
  for_each_edge(uses, [&neighbours](std::span<const Edge_use> edge) {
    if (edge.size() != 2 || edge[0].face == edge[1].face) return;
    const bool opposite = edge[0].forward == edge[1].forward;
    neighbours[edge[0].face].push_back({edge[1].face, opposite});
    neighbours[edge[1].face].push_back({edge[0].face, opposite});
  });
  std::vector<bool> turned(polyhedron.face_count()), reached(polyhedron.face_count());
  std::vector<Index> queue;
  for (Index seed = 0; seed < polyhedron.face_count(); ++seed) {
    if (reached[seed]) continue;
    reached[seed] = true;
    queue.assign(1, seed);
    for (std::size_t next = 0; next < queue.size(); ++next)
      for (const Neighbour& neighbour : neighbours[queue[next]])
        if (!reached[neighbour.face]) {
          reached[neighbour.face] = true;
          turned[neighbour.face] = turned[queue[next]] != neighbour.opposite;
          queue.push_back(neighbour.face);
        }
  }
  return turned;
}

/// Appends face `f` of `from` to `to`, with its loops turned round when `turn`. Vertices keep their numbers.
inline void append_face(Polyhedron& to, const Polyhedron& from, Index f, bool turn)
{
  to.add_face(face_loops(from, f, turn));
}

/// Returns a polyhedron of the faces `faces`, each turned round where `turned` says so. It has only the vertices that
/// they use, in their old order.
inline Polyhedron part(const Polyhedron& polyhedron, const std::vector<Index>& faces, const std::vector<bool>& turned)
{
  std::vector<Index> used;
  for (const Index f : faces)
    for (std::size_t k = 0; k < polyhedron.loop_count(f); ++k) {
      const Loop loop = polyhedron.loop(f, k);
      used.insert(used.end(), loop.begin(), loop.end());
    }
  std::ranges::sort(used);
  used.erase(std::unique(used.begin(), used.end()), used.end());
  Polyhedron result;
  for (const Index v : used) result.vertices.push_back(polyhedron.vertices[v]);
  for (const Index f : faces) {
    auto loops = face_loops(polyhedron, f, turned[f]);
    for (auto& loop : loops)
      for (Index& v : loop) v = static_cast<Index>(std::ranges::lower_bound(used, v) - used.begin());
    result.add_face(loops);
  }
  return result;
}

/// A polyhedron of which some faces have been turned round.
struct Oriented {
  Polyhedron polyhedron;
  std::vector<Index> turned;  ///< the faces that were turned, ascending
};

/// Returns the polyhedron oriented. `turned` says which faces to turn so that edges cancel in each of `edge_groups`.
/// - A group that is closed as it stands is left alone: inward, it may be a cavity.
/// - A group that becomes closed is turned outward: volume_of(group) is not negative.
/// - Any other group is turned as a whole where that leaves fewer of its faces changed.
template <class Volume_of>
Oriented apply_orientation(const Polyhedron& polyhedron, std::vector<bool> turned, const Volume_of& volume_of)
{
  const std::vector<bool> as_it_stands(polyhedron.face_count());
  for (const auto& faces : edge_groups(polyhedron)) {
    const auto turn_all = [&] {
      for (const Index f : faces) turned[f] = !turned[f];
    };
    if (is_closed(part(polyhedron, faces, as_it_stands))) {
      for (const Index f : faces) turned[f] = false;
      continue;
    }
    const Polyhedron group = part(polyhedron, faces, turned);
    if (is_closed(group)) {
      if (sgn(volume_of(group)) < 0) turn_all();
    } else {
      const auto changes = std::ranges::count_if(faces, [&](Index f) { return turned[f]; });
      if (2 * changes > std::ssize(faces)) turn_all();
    }
  }
  Oriented result;
  result.polyhedron.vertices = polyhedron.vertices;
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    append_face(result.polyhedron, polyhedron, f, turned[f]);
    if (turned[f]) result.turned.push_back(f);
  }
  return result;
}

/// Returns the polyhedron with faces turned to agree across their edges, edges of holes included. `apply_orientation`
/// says what becomes of each group, by `volume`.
inline Oriented orient_across_edges(const Polyhedron& polyhedron)
{
  return apply_orientation(polyhedron, turns_across_edges(polyhedron), volume);
}

}  // namespace tetracone::covering

#endif
