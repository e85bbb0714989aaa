#ifndef TETRACONE_COVERING_COVERING_H
#define TETRACONE_COVERING_COVERING_H

#include "tetracone/covering/edge_uses.h"
#include "tetracone/covering/polyhedron.h"
#include "tetracone/covering/union_find.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/volume.h"
#include "tetracone/kernel/predicate/plane_basis.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <numeric>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace tetracone::covering {

inline constexpr Index none = std::numeric_limits<Index>::max();  ///< stands for no vertex, edge or face

/// One triangle W_i Q_j-1 Q_j of the covering of a face F_i (JS08 Definition 1). With the origin O of the polyhedron it
/// spans the tetrahedron S_ij = O W_i Q_j-1 Q_j of Theorem 1, whose sign is its orientation.
struct Covering_triangle {
  Index face;
  std::array<Index, 3> corner;  ///< W, from, to: vertex numbers
  std::array<Index, 3> edge;    ///< numbers in `Covering::edges` of its sides W-from, from-to and to-W; `none` for a
                                ///< side that is no edge of the polyhedron
};

/// The grain of parallel work: this many faces, elements or corners of a body, or fewer, are not shared among threads.
inline constexpr Index most_in_part = 8192;

/// A reference to a callable without arguments. The callable must outlive it.
class Thing {
 public:
  template <std::invocable What>
  Thing(const What& what) : what_(&what), call_([](const void* called) { (*static_cast<const What*>(called))(); })
  {}

  void operator()() const { call_(what_); }

 private:
  const void* what_;
  void (*call_)(const void*);
};

/// A way to do two things: one after the other by default, else by way(one, other). A `way` with threads may do both at
/// once; it returns when both are done. `way` must outlive this.
class Both {
 public:
  Both() = default;
  template <std::invocable<const Thing&, const Thing&> Way>
  Both(const Way& way)
      : way_(&way), call_([](const void* called, const Thing& one, const Thing& other) {
          (*static_cast<const Way*>(called))(one, other);
        })
  {}

  /// True when the two things are done one after the other.
  bool is_in_turn() const { return call_ == nullptr; }

  void operator()(const Thing& one, const Thing& other) const
  {
    if (call_ != nullptr) {
      call_(way_, one, other);
      return;
    }
    one();
    other();
  }

 private:
  const void* way_ = nullptr;
  void (*call_)(const void*, const Thing&, const Thing&) = nullptr;
};

/// Calls what(begin, end) for parts of the numbers from `first` to below `last`. Each part has at most `most` numbers;
/// together they are all. The calls are in turn, or at once where `both` does two things at once.
template <class What>
void in_parts(Index first, Index last, const Both& both, const What& what, Index most = most_in_part)
{
  if (last - first <= most) {
    what(first, last);
    return;
  }
  const Index middle = first + (last - first) / 2;
  both([&] { in_parts(first, middle, both, what, most); }, [&] { in_parts(middle, last, both, what, most); });
}

/// Returns the sum of what(begin, end) over the parts of `in_parts`. Sums of later parts are added to those of earlier
/// ones: sum.add(later).
template <class What>
auto sum_of_parts(Index first, Index last, const Both& both, const What& what) -> decltype(what(first, last))
{
  if (last - first <= most_in_part) return what(first, last);
  const Index middle = first + (last - first) / 2;
  std::optional<decltype(what(first, last))> sum, later;
  both([&] { sum.emplace(sum_of_parts(first, middle, both, what)); },
       [&] { later.emplace(sum_of_parts(middle, last, both, what)); });
  sum->add(*later);
  return *sum;
}

/// An allocator that leaves new elements uninitialised, so that the threads that fill memory are the first to touch it.
template <class T>
struct Unset : std::allocator<T> {
  template <class Other>
  struct rebind {
    using other = Unset<Other>;
  };

  template <class Made>
  void construct(Made* at)
  {
    ::new (static_cast<void*>(at)) Made;
  }
  template <class Made, class... Arguments>
  void construct(Made* at, Arguments&&... arguments)
  {
    std::construct_at(at, std::forward<Arguments>(arguments)...);
  }
};
/// A vector of such elements.
template <class T>
using Unset_vector = std::vector<T, Unset<T>>;

/// The covering of a polyhedron, with its real edges and its connected parts. For each face it has the triangles that
/// join the origin W of the face to its directed edges (JS08 Theorem 1, Definitions 1 and 2).
///
/// W is the first corner of the face. It is exactly on the plane, where a rounded centroid is not, and a triangle
/// becomes its own covering, one tetrahedron instead of three. (Departure from the paper, which proposes the centroid;
/// Theorem 1 allows any point.) Edges that end in W span no triangle; they are sides of the triangles beside them.
/// Where a face has no such triangle, a flat one carries them. Each real edge is therefore on some triangle of its
/// face.
class Covering {
 public:
  /// Computes the covering. `both` says whether parts of the work may run at once, which does not change the result.
  explicit Covering(const Polyhedron& polyhedron, const Both& both = {})
  {
    both(
        [&] {
          collect_corners(polyhedron);
          both([&] { collect_shells(polyhedron); }, [&] { span_faces(polyhedron, both); });
        },
        [&] { collect_edges(polyhedron); });
    cover_faces(both);
    edge_begin_.clear();
    edge_begin_.shrink_to_fit();
  }

  /// Returns the triangles of all faces, face after face.
  std::span<const Covering_triangle> triangles() const { return triangles_; }

  /// Returns the real edges, undirected: pairs of vertex numbers, the smaller first, sorted, each once.
  const std::vector<std::array<Index, 2>>& edges() const { return edges_; }

  /// Returns the starts of the directed edges of the loops of face `f`, loop after loop. Edge k leads from `from(f)[k]`
  /// to `to(f)[k]`. from(f)[0] is W.
  std::span<const Index> from(Index f) const { return part(from_, f); }
  std::span<const Index> to(Index f) const { return part(to_, f); }

  /// Returns three vertices of face `f` that span its plane; nothing when all its corners are on one line.
  std::optional<std::array<Index, 3>> plane_basis(Index f) const
  {
    if (spanned_[f] == by_none) return std::nullopt;
    if (spanned_[f] == by_others) return plane_bases_.find(f)->second;
    const auto corners = from(f);
    return std::array{corners[0], corners[spanned_[f] / 16], corners[spanned_[f] % 16]};
  }

  /// Returns one vertex of each connected part of the surface. A part is a maximal set of loops connected through
  /// shared vertices. Loops count, not faces, since a face of several loops need not be connected.
  const std::vector<Index>& shell_vertices() const { return shell_vertices_; }

 private:
  // Codes for a face's plane basis beside the usual one. The usual code names two of the next fourteen corners after
  // the first, four bits each.
  static constexpr std::uint8_t by_none = 0,  ///< all corners are on one line
      by_others = 255;                        ///< other corners, in `plane_bases_`

  std::span<const Index> part(const std::vector<Index>& of, Index f) const
  {
    return std::span(of).subspan(face_corner_begin_[f], face_corner_begin_[f + 1] - face_corner_begin_[f]);
  }

  static std::array<Index, 2> undirected(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

  void collect_corners(const Polyhedron& polyhedron)
  {
    from_.reserve(polyhedron.corner_count());
    to_.reserve(polyhedron.corner_count());
    face_corner_begin_.reserve(polyhedron.face_count() + 1);
    face_corner_begin_.push_back(0);
    for (Index f = 0; f < polyhedron.face_count(); ++f) {
      for_each_directed_edge(polyhedron, f, [&](Index from, Index to) {
        from_.push_back(from);
        to_.push_back(to);
      });
      face_corner_begin_.push_back(Index(from_.size()));
    }
  }

  /// The edges are sorted by their first vertices in two passes, which is faster than sorting them all.
  void collect_edges(const Polyhedron& polyhedron)
  {
    const auto for_edges = [&](const auto& what) {
      for (Index f = 0; f < polyhedron.face_count(); ++f)
        for_each_directed_edge(polyhedron, f, [&](Index from, Index to) { what(undirected(from, to)); });
    };
    std::vector<std::size_t> end(polyhedron.vertices.size() + 1, 0);
    for_edges([&](const std::array<Index, 2>& edge) { ++end[edge[0] + 1]; });
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<Index> others(end.back());
    for_edges([&](const std::array<Index, 2>& edge) { others[end[edge[0]]++] = edge[1]; });
    edges_.reserve(others.size() / 2 + 1);
    edge_begin_.reserve(polyhedron.vertices.size() + 1);
    for (Index v = 0; v < polyhedron.vertices.size(); ++v) {
      edge_begin_.push_back(Index(edges_.size()));
      const auto first = others.begin() + std::ptrdiff_t(v == 0 ? 0 : end[v - 1]),
                 last = others.begin() + std::ptrdiff_t(end[v]);
      std::sort(first, last);
      for (auto other = first; other != last; ++other)
        if (other == first || *other != *(other - 1)) edges_.push_back({v, *other});
    }
    edge_begin_.push_back(Index(edges_.size()));
  }

  Index edge_number(Index a, Index b) const
  {
    const auto edge = undirected(a, b);
    const auto first = edges_.begin();
    return Index(std::lower_bound(first + edge_begin_[edge[0]], first + edge_begin_[edge[0] + 1], edge) - first);
  }

  /// Covers the faces in parts. If every face of n corners has n - 2 triangles, their positions follow from the corners
  /// before them.
  void cover_faces(const Both& both)
  {
    const auto faces = Index(face_corner_begin_.size() - 1);
    const auto corners = [&](Index f) { return face_corner_begin_[f + 1] - face_corner_begin_[f]; };
    std::atomic<bool> is_regular = true;
    in_parts(0, faces, both, [&](Index first, Index last) {
      for (Index f = first; f < last; ++f)
        if (corners(f) < 3) is_regular = false;
    });
    if (is_regular) {
      triangles_.resize(from_.size() - 2 * std::size_t(faces));
      in_parts(0, faces, both, [&](Index first, Index last) {
        Neighbours neighbours;
        for (Index f = first; f < last; ++f) {
          const Index begin = face_corner_begin_[f] - 2 * f, most = corners(f) - 2;
          Index count = 0;
          cover_face(f, neighbours, [&](const Covering_triangle& t) {
            if (count < most) triangles_[begin + count] = t;
            ++count;
          });
          if (count != most) is_regular = false;
        }
      });
    }
    if (is_regular) return;
    triangles_.clear();
    Neighbours neighbours;
    for (Index f = 0; f < faces; ++f)
      cover_face(f, neighbours, [&](const Covering_triangle& t) { triangles_.push_back(t); });
  }

  /// The neighbours of the corner W along a face's edges, each with whether a triangle has that side.
  using Neighbours = std::vector<std::pair<Index, bool>>;

  /// Calls add(triangle) for each triangle of the face. `neighbours` is scratch memory.
  template <class Add>
  void cover_face(Index f, Neighbours& neighbours, const Add& add) const
  {
    const std::size_t first = face_corner_begin_[f], last = face_corner_begin_[f + 1];
    const Index w = from_[first];
    if (last - first == 3) {  // the usual case; the rest gives the same result
      const Index a = to_[first], b = to_[first + 1];
      if (a != w && b != w && a != b && to_[first + 2] == w) {
        add({f, {w, a, b}, {edge_number(w, a), edge_number(a, b), edge_number(b, w)}});
        return;
      }
    }
    neighbours.clear();
    for (std::size_t k = first; k < last; ++k) {
      if (from_[k] == w) neighbours.push_back({to_[k], false});
      if (to_[k] == w) neighbours.push_back({from_[k], false});
    }
    const auto side = [&](Index v) {
      Index edge = none;
      for (auto& [neighbour, has_triangle] : neighbours)
        if (neighbour == v) {
          has_triangle = true;
          edge = edge_number(w, v);
        }
      return edge;
    };
    for (std::size_t k = first; k < last; ++k) {
      const Index a = from_[k], b = to_[k];
      if (a != w && b != w) add({f, {w, a, b}, {side(a), edge_number(a, b), side(b)}});
    }
    for (const auto& [neighbour, has_triangle] : neighbours) {
      const Index v = neighbour;
      if (has_triangle) continue;
      const Index edge = edge_number(w, v);
      add({f, {w, v, v}, {edge, v == w ? edge : none, edge}});
      side(v);
    }
  }

  void span_faces(const Polyhedron& polyhedron, const Both& both)
  {
    const auto faces = Index(polyhedron.face_count());
    spanned_.resize(faces);
    in_parts(0, faces, both, [&](Index first, Index last) {
      for (Index f = first; f < last; ++f) {
        const auto basis = find_basis(polyhedron, f);
        if (!basis)
          spanned_[f] = by_none;
        else if (const auto [k, second, third] = *basis; k == 0 && second < 15 && third < 15)
          spanned_[f] = std::uint8_t(16 * second + third);
        else
          spanned_[f] = by_others;
      }
    });
    for (Index f = 0; f < faces; ++f)
      if (spanned_[f] == by_others) {
        const auto basis = *find_basis(polyhedron, f);
        const auto corners = from(f);
        plane_bases_[f] = {corners[basis[0]], corners[basis[1]], corners[basis[2]]};
      }
  }

  std::optional<std::array<std::size_t, 3>> find_basis(const Polyhedron& polyhedron, Index f) const
  {
    const auto corners = from(f);
    return kernel::plane_basis(corners.size(),
                               [&](std::size_t k) -> const Vertex& { return polyhedron.vertices[corners[k]]; });
  }

  void collect_shells(const Polyhedron& polyhedron)
  {
    Union_find sets(polyhedron.vertices.size());
    for (Index f = 0; f < polyhedron.face_count(); ++f)
      for (std::size_t k = 1; k < from(f).size(); ++k)  // the last edge ends where its loop began
        sets.join(from(f)[k - 1], to(f)[k - 1]);
    std::vector<bool> seen(polyhedron.vertices.size(), false);
    for (const Index v : from_) {
      if (!seen[sets.root(v)]) shell_vertices_.push_back(v);
      seen[sets.root(v)] = true;
    }
  }

  Unset_vector<Covering_triangle> triangles_;
  std::vector<std::array<Index, 2>> edges_;
  std::vector<Index> edge_begin_;  // during construction: where the edges of each vertex begin
  std::vector<Index> from_, to_;
  std::vector<Index> face_corner_begin_;
  std::vector<std::uint8_t> spanned_;                            // codes of plane bases
  std::unordered_map<Index, std::array<Index, 3>> plane_bases_;  // of the faces with `by_others`
  std::vector<Index> shell_vertices_;
};

/// Returns the signed volume, exactly, positive for outward faces. It is 1/6 of the sum of the determinants of the
/// covering's tetrahedra (JS08 Theorem 1). It does not depend on any W when faces are planar, nor on O when the
/// polyhedron is closed; here O is the first vertex.
inline kernel::Rational volume(const Polyhedron& polyhedron)
{
  kernel::Volume_sum sum;
  const auto vertex = [&](Index v) -> const Vertex& { return polyhedron.vertices[v]; };
  const Covering covering(polyhedron);
  for (const Covering_triangle& t : covering.triangles())
    sum.add(vertex(0), vertex(t.corner[0]), vertex(t.corner[1]), vertex(t.corner[2]));
  return sum.value() / 6;
}

}  // namespace tetracone::covering

#endif
