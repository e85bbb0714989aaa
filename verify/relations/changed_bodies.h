#ifndef TETRACONE_VERIFY_RELATIONS_CHANGED_BODIES_H
#define TETRACONE_VERIFY_RELATIONS_CHANGED_BODIES_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/number.h"
#include "verify/cases/exact_motion.h"
#include "verify/cases/random.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

/// Bodies made from another body, with the same surface or an exactly known one, for relations.
namespace tetracone::verify {

/// A body made from another, and for each face the face of which it is a part.
struct Changed_body {
  covering::Polyhedron body;
  std::vector<covering::Index> of_face;

  /// Adds a face that is `f` of the other body, or a part of it.
  template <class Loops>
  void add(covering::Index f, const Loops& loops)
  {
    body.add_face(loops);
    of_face.push_back(f);
  }
};

/// Returns the body in a form that cases share.
inline std::shared_ptr<const covering::Polyhedron> as_shared(covering::Polyhedron body)
{
  return std::make_shared<const covering::Polyhedron>(std::move(body));
}

/// Returns copies of a face's loops.
inline std::vector<std::vector<covering::Index>> loops_of(const covering::Polyhedron& polyhedron, covering::Index f)
{
  std::vector<std::vector<covering::Index>> loops;
  for (std::size_t l = 0; l < polyhedron.loop_count(f); ++l) {
    const auto loop = polyhedron.loop(f, l);
    loops.emplace_back(loop.begin(), loop.end());
  }
  return loops;
}

/// Brings a sequence into any order; equal seeds give equal orders on every machine.
template <class Sequence>
void shuffle(Sequence& sequence, Random& random)
{
  for (std::size_t k = sequence.size(); k > 1; --k) std::swap(sequence[k - 1], sequence[one_of(random, k)]);
}

/// Returns the body with vertices, faces and the first corners of loops in any order.
inline Changed_body reordered(const covering::Polyhedron& what, Random& random)
{
  std::vector<covering::Index> place(what.vertices.size()), order(what.face_count());
  std::iota(place.begin(), place.end(), covering::Index(0));
  std::iota(order.begin(), order.end(), covering::Index(0));
  shuffle(place, random);
  shuffle(order, random);
  Changed_body result;
  result.body.vertices.resize(place.size());
  for (std::size_t v = 0; v < place.size(); ++v) result.body.vertices[place[v]] = what.vertices[v];
  for (const covering::Index f : order) {
    auto loops = loops_of(what, f);
    for (auto& loop : loops) {
      for (covering::Index& v : loop) v = place[v];
      std::rotate(loop.begin(), loop.begin() + std::ptrdiff_t(one_of(random, loop.size())), loop.end());
    }
    result.add(f, loops);
  }
  return result;
}

/// Returns the body with all loops reversed.
inline Changed_body wound_backwards(const covering::Polyhedron& what)
{
  Changed_body result;
  result.body.vertices = what.vertices;
  for (covering::Index f = 0; f < what.face_count(); ++f) {
    auto loops = loops_of(what, f);
    for (auto& loop : loops) std::reverse(loop.begin(), loop.end());
    result.add(f, loops);
  }
  return result;
}

/// Returns the body with triangles split into three at an inner point of doubles, closed if it was. Nothing if no
/// triangle has such a point.
inline std::optional<Changed_body> split_inside(const covering::Polyhedron& what)
{
  Changed_body result;
  result.body.vertices = what.vertices;
  bool changed = false;
  for (covering::Index f = 0; f < what.face_count(); ++f) {
    const covering::Loop loop = what.loop(f, 0);
    const auto vertex = [&](std::size_t k) -> const kernel::Vertex& { return what.vertices[loop[k]]; };
    const auto side = what.is_triangle(f) ? exact_middle(vertex(0), vertex(1)) : std::nullopt;
    const auto inner = side ? exact_middle(*side, vertex(2)) : std::nullopt;
    if (!inner) {
      result.add(f, loops_of(what, f));
      continue;
    }
    const auto m = covering::Index(result.body.vertices.size());
    result.body.vertices.push_back(*inner);
    for (std::size_t k = 0; k < 3; ++k)
      result.add(f, std::vector<std::vector<covering::Index>>{{loop[k], loop[(k + 1) % 3], m}});
    changed = true;
  }
  return changed ? std::optional(std::move(result)) : std::nullopt;
}

/// Returns the body without a face; nothing when it has no other.
inline std::optional<covering::Polyhedron> without_a_face(const covering::Polyhedron& what, Random& random)
{
  if (what.face_count() < 2) return std::nullopt;
  const auto without = covering::Index(one_of(random, what.face_count()));
  covering::Polyhedron rest;
  rest.vertices = what.vertices;
  for (covering::Index f = 0; f < what.face_count(); ++f)
    if (f != without) rest.add_face(loops_of(what, f));
  return rest;
}

/// The least and the greatest coordinates of a body's vertices, and the longest side between them.
struct Corners {
  kernel::Vertex low, high;
  double extent = 0;

  explicit Corners(const covering::Polyhedron& what) : low(what.vertices[0]), high(low)
  {
    for (const kernel::Vertex& v : what.vertices)
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], v[k]);
        high[k] = std::max(high[k], v[k]);
      }
    for (std::size_t k = 0; k < 3; ++k) extent = std::max(extent, high[k] - low[k]);
  }
};

/// Returns the body with change(v) for each vertex v; nothing when one is no vertex of doubles.
template <class Change>
std::optional<covering::Polyhedron> with_vertices(const covering::Polyhedron& what, const Change& change)
{
  covering::Polyhedron result = what;
  for (kernel::Vertex& v : result.vertices) {
    const std::optional<kernel::Vertex> moved = change(v);
    if (!moved) return std::nullopt;
    v = *moved;
  }
  return result;
}

}  // namespace tetracone::verify

#endif
