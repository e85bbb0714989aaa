#ifndef TETRACONE_COVERING_POLYHEDRON_H
#define TETRACONE_COVERING_POLYHEDRON_H

#include "tetracone/kernel/number/vertex.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

namespace tetracone::covering {

using kernel::Vertex;

/// The number of a vertex or of a face of a polyhedron, from 0.
using Index = std::uint32_t;

/// A closed loop of vertex numbers, each followed by the next and the last by the first.
using Loop = std::span<const Index>;

/// Vertices, and faces of one or more closed loops. The first loop of a face is its outer boundary. The others are its
/// holes, which run the other way round. There is no other requirement: open or closed, several shells, non-manifold,
/// degenerate and repeated elements are all representable (see `check.h`). Every coordinate is a finite double and is
/// taken exactly.
class Polyhedron {
 public:
  std::vector<Vertex> vertices;  ///< by their numbers; faces may leave some unused

  /// Appends a face; the first loop is the outer one. Requires at least one loop, no loop empty.
  template <class Loops>
  void add_face(const Loops& loops)
  {
    for (const auto& loop : loops) {
      assert(loop.size() > 0);
      corners_.insert(corners_.end(), loop.begin(), loop.end());
      loop_end_.push_back(Index(corners_.size()));
    }
    assert(face_end_.empty() ? !loop_end_.empty() : loop_end_.size() > face_end_.back());
    face_end_.push_back(Index(loop_end_.size()));
    assert(corners_.size() <= std::numeric_limits<Index>::max());
  }
  /// Appends a face of loops in braces: `add_face({{0, 1, 2, 3}, {4, 5, 6}})`.
  void add_face(std::initializer_list<std::initializer_list<Index>> loops) { add_face<decltype(loops)>(loops); }

  /// Appends a face of one loop.
  template <class Corners>
  void add_polygon(const Corners& loop)
  {
    add_face(std::span<const Corners, 1>(&loop, 1));
  }
  /// Appends a face of one loop in braces: `add_polygon({0, 1, 2})`.
  void add_polygon(std::initializer_list<Index> loop) { add_polygon<std::initializer_list<Index>>(loop); }

  /// Reserves memory for faces with `corners` corners in all.
  void reserve_faces(std::size_t faces, std::size_t corners)
  {
    corners_.reserve(corners);
    loop_end_.reserve(faces);
    face_end_.reserve(faces);
  }

  /// Replaces the number v of each corner by new_number(v).
  template <class New_number>
  void renumber(const New_number& new_number)
  {
    for (Index& v : corners_) v = new_number(v);
  }

  /// Calls what(array) for each of the arrays of the polyhedron, to save them in a file or to fill them from one.
  template <class What>
  void for_arrays(const What& what) const
  {
    for_arrays_of(*this, what);
  }
  /// Calls what(array) likewise, where it may change the arrays. Requires that they are a polyhedron's afterwards.
  template <class What>
  void for_arrays(const What& what)
  {
    for_arrays_of(*this, what);
  }

  /// True when arrays from a file are loops and faces, and vertices have numbers below 2^32 - 1. Then no loop is empty,
  /// each face has a loop, and the ends of loops and faces ascend to the ends of the arrays. Corners may still name
  /// vertices that do not exist.
  bool has_legal_loops() const
  {
    const auto ascend_to = [](const std::vector<Index>& ends, std::size_t last) {
      Index before = 0;
      for (const Index end : ends) {
        if (end <= before) return false;
        before = end;
      }
      return before == last;
    };
    return vertices.size() < std::numeric_limits<Index>::max() && ascend_to(loop_end_, corners_.size()) &&
           ascend_to(face_end_, loop_end_.size());
  }

  /// Returns the number of faces.
  std::size_t face_count() const { return face_end_.size(); }

  /// Returns the number of corners of all faces; a vertex counts as often as loops name it.
  std::size_t corner_count() const { return corners_.size(); }

  /// Returns the number of loops of face `f`: 1, and one more for each hole.
  std::size_t loop_count(Index f) const { return face_end_[f] - first_loop(f); }

  /// Returns loop `k` of face `f`; loop 0 is the outer one.
  Loop loop(Index f, std::size_t k) const
  {
    assert(k < loop_count(f));
    const std::size_t l = first_loop(f) + k;
    const std::size_t begin = l == 0 ? 0 : loop_end_[l - 1];
    return Loop(corners_).subspan(begin, loop_end_[l] - begin);
  }

  /// True when face `f` is one loop of three corners.
  bool is_triangle(Index f) const { return loop_count(f) == 1 && loop(f, 0).size() == 3; }

 private:
  template <class Self, class What>
  static void for_arrays_of(Self& self, const What& what)
  {
    what(self.vertices);
    what(self.corners_);
    what(self.loop_end_);
    what(self.face_end_);
  }

  std::size_t first_loop(Index f) const { return f == 0 ? 0 : face_end_[f - 1]; }

  std::vector<Index> corners_;   // all loops, one after the other
  std::vector<Index> loop_end_;  // loop l is corners_[loop_end_[l-1] .. loop_end_[l])
  std::vector<Index> face_end_;  // face f is loops face_end_[f-1] .. face_end_[f]
};

/// Returns the loops of face `f`, each turned round when `turned`.
inline std::vector<std::vector<Index>> face_loops(const Polyhedron& polyhedron, Index f, bool turned = false)
{
  std::vector<std::vector<Index>> loops;
  for (std::size_t k = 0; k < polyhedron.loop_count(f); ++k) {
    const Loop loop = polyhedron.loop(f, k);
    loops.emplace_back(loop.begin(), loop.end());
    if (turned) std::ranges::reverse(loops.back());
  }
  return loops;
}

/// Appends the vertices and the faces of `what` to `to`, with every loop turned round when `turned`. Requires two
/// different polyhedra.
inline void append(Polyhedron& to, const Polyhedron& what, bool turned = false)
{
  assert(&to != &what);
  const Index first = static_cast<Index>(to.vertices.size());
  to.vertices.insert(to.vertices.end(), what.vertices.begin(), what.vertices.end());
  for (Index f = 0; f < what.face_count(); ++f) {
    auto loops = face_loops(what, f, turned);
    for (auto& loop : loops)
      for (Index& v : loop) v += first;
    to.add_face(loops);
  }
}

/// A triangle that is part of a face; its corners are vertices of the polyhedron.
struct Face_triangle {
  Index face;                   ///< the face that it is part of
  std::array<Index, 3> corner;  ///< numbers of vertices, in the face's direction
};

/// Returns for each vertex the least number of a vertex of equal coordinates.
inline std::vector<Index> least_equal_vertices(const std::vector<Vertex>& vertices)
{
  std::vector<Index> order(vertices.size()), least(vertices.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::ranges::sort(order,
                    [&](Index v, Index w) { return vertices[v] != vertices[w] ? vertices[v] < vertices[w] : v < w; });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool repeats = k > 0 && vertices[order[k]] == vertices[order[k - 1]];
    least[order[k]] = repeats ? least[order[k - 1]] : order[k];
  }
  return least;
}

/// Returns a polyhedron of these vertices. Its faces are the triangles, in their order, then each face that has no
/// triangle.
inline Polyhedron each_triangle_a_face(const Polyhedron& polyhedron, std::span<const Face_triangle> triangles)
{
  Polyhedron result;
  result.vertices = polyhedron.vertices;
  std::vector<bool> has_triangles(polyhedron.face_count(), false);
  for (const Face_triangle& t : triangles) {
    has_triangles[t.face] = true;
    result.add_polygon(t.corner);
  }
  for (Index f = 0; f < polyhedron.face_count(); ++f)
    if (!has_triangles[f]) result.add_face(face_loops(polyhedron, f));
  return result;
}

}  // namespace tetracone::covering

#endif
