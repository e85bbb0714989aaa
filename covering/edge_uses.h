#ifndef TETRACONE_COVERING_EDGE_USES_H
#define TETRACONE_COVERING_EDGE_USES_H

#include "tetracone/covering/polyhedron.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <span>
#include <tuple>
#include <vector>

namespace tetracone::covering {

/// One use of the edge {low, high} by a loop of a face: from low to high when `forward`. low < high.
struct Edge_use {
  Index low, high, face;
  bool forward;
};

/// Calls `visit(from, to)` for each directed edge of face `f`, over all its loops. A loop of one corner has the edge
/// (a, a).
template <class Visit>
void for_each_directed_edge(const Polyhedron& polyhedron, Index f, Visit visit)
{
  for (std::size_t k = 0; k < polyhedron.loop_count(f); ++k) {
    const Loop loop = polyhedron.loop(f, k);
    for (std::size_t j = 0; j < loop.size(); ++j) visit(loop[j], loop[j + 1 < loop.size() ? j + 1 : 0]);
  }
}

/// Sorts uses by (low, high, face, forward); `vertices` is the number of vertices. Where there are no more vertices
/// than uses, it makes a bucket for each lower vertex and sorts within buckets, which is faster.
inline void sort_uses(std::vector<Edge_use>& uses, std::size_t vertices)
{
  const auto is_before = [](const Edge_use& x, const Edge_use& y) {
    return std::tie(x.low, x.high, x.face, x.forward) < std::tie(y.low, y.high, y.face, y.forward);
  };
  const bool are_legal = std::ranges::all_of(uses, [&](const Edge_use& use) { return use.low < vertices; });
  if (vertices > uses.size() || !are_legal) {
    std::ranges::sort(uses, is_before);
    return;
  }
  std::vector<std::size_t> end(vertices + 1, 0);
  for (const Edge_use& use : uses) ++end[use.low + 1];
  for (std::size_t v = 0; v < vertices; ++v) end[v + 1] += end[v];
  std::vector<Edge_use> sorted(uses.size());
  for (const Edge_use& use : uses) sorted[end[use.low]++] = use;
  for (std::size_t v = 0; v < vertices; ++v)
    std::sort(sorted.begin() + std::ptrdiff_t(v == 0 ? 0 : end[v - 1]), sorted.begin() + std::ptrdiff_t(end[v]),
              is_before);
  uses.swap(sorted);
}

/// Returns all uses of all edges, sorted by (low, high, face). Edges (a, a) are left out: each is its own reverse.
inline std::vector<Edge_use> edge_uses(const Polyhedron& polyhedron)
{
  std::vector<Edge_use> uses;
  for (Index f = 0; f < polyhedron.face_count(); ++f)
    for_each_directed_edge(polyhedron, f, [&](Index a, Index b) {
      if (a != b) uses.push_back({std::min(a, b), std::max(a, b), f, a < b});
    });
  sort_uses(uses, polyhedron.vertices.size());
  return uses;
}

/// Calls `visit(uses)` with the uses of each edge in turn. Requires the order of `edge_uses`.
template <class Visit>
void for_each_edge(std::span<const Edge_use> uses, Visit visit)
{
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    while (end < uses.size() && uses[end].low == uses[begin].low && uses[end].high == uses[begin].high) ++end;
    visit(uses.subspan(begin, end - begin));
  }
}

/// Returns how often an edge is used from low to high minus how often from high to low; 0 where its uses cancel.
inline std::ptrdiff_t surplus(std::span<const Edge_use> uses)
{
  const auto forward = std::ranges::count_if(uses, &Edge_use::forward);
  return 2 * forward - static_cast<std::ptrdiff_t>(uses.size());
}

/// True when over all loops every directed edge (a, b) occurs exactly as often as (b, a).
inline bool is_closed(const Polyhedron& polyhedron)
{
  // The uses of an edge cancel when as many lead from its low to its high vertex as back.
  const std::size_t vertices = polyhedron.vertices.size();
  bool is_legal = true;
  const auto for_edges = [&](const auto& what) {
    for (Index f = 0; f < polyhedron.face_count(); ++f)
      for_each_directed_edge(polyhedron, f, [&](Index a, Index b) {
        if (a >= vertices || b >= vertices)
          is_legal = false;
        else if (a != b)
          what(a < b, std::min(a, b), std::max(a, b));
      });
  };
  std::array<std::vector<Index>, 2> ends{std::vector<Index>(vertices + 1, 0), std::vector<Index>(vertices + 1, 0)};
  for_edges([&](bool forward, Index low, Index) { ++ends[forward][low + 1]; });
  if (!is_legal) {
    bool closed = true;
    const auto uses = edge_uses(polyhedron);
    for_each_edge(uses, [&closed](std::span<const Edge_use> edge) { closed = closed && surplus(edge) == 0; });
    return closed;
  }
  if (ends[0] != ends[1]) return false;
  for (std::vector<Index>& end : ends) std::partial_sum(end.begin(), end.end(), end.begin());
  std::array<std::vector<Index>, 2> higher{std::vector<Index>(ends[0].back()), std::vector<Index>(ends[1].back())};
  for_edges([&](bool forward, Index low, Index high) { higher[forward][ends[forward][low]++] = high; });
  for (std::size_t v = 0; v < vertices; ++v) {
    const auto sorted = [&](int way) {
      const auto first = higher[way].begin() + (v == 0 ? 0 : ends[way][v - 1]),
                 last = higher[way].begin() + ends[way][v];
      std::sort(first, last);
      return std::span(first, last);
    };
    if (!std::ranges::equal(sorted(0), sorted(1))) return false;
  }
  return true;
}

}  // namespace tetracone::covering

#endif
