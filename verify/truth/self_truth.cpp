#include "verify/truth/self_truth.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <set>

namespace tetracone::verify {
namespace {

using covering::Index;

/// The vertices and edges of a face, by coordinates.
struct Own_features {
  std::set<Exact_point> vertices;
  std::set<Exact_segment> edges;

  Own_features(const covering::Polyhedron& body, Index f)
  {
    const auto exact = [&](Index v) {
      const auto& x = body.vertices[v];
      return Exact_point{x[0], x[1], x[2]};
    };
    for (std::size_t l = 0; l < body.loop_count(f); ++l) {
      const auto loop = body.loop(f, l);
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Exact_point a = exact(loop[k]), b = exact(loop[(k + 1) % loop.size()]);
        vertices.insert(a);
        edges.insert({std::min(a, b), std::max(a, b)});
      }
    }
  }
};

/// True when one segment holds another: the union of the two is the first.
bool holds(const Exact_segment& whole, const Exact_segment& part)
{
  return maximal_segments({whole, part}) == std::vector<Exact_segment>{whole};
}

}  // namespace

Contact_forms improper_pieces(const Contact_forms& all, const covering::Polyhedron& body)
{
  Contact_forms improper;
  for (const Contact_piece_form& piece : all) {
    if (piece.face_a >= piece.face_b) continue;
    const Own_features a(body, piece.face_a), b(body, piece.face_b);
    std::vector<Exact_segment> common;
    std::ranges::set_intersection(a.edges, b.edges, std::back_inserter(common));
    if (piece.kind == kernel::Piece::point)
      for (const Exact_point& v : a.vertices)
        if (b.vertices.contains(v)) common.push_back({v, v});
    const auto held = [&](const Exact_segment& s) { return holds(s, piece.border[0]); };
    if (piece.kind == kernel::Piece::polygon || !std::ranges::any_of(maximal_segments(common), held))
      improper.push_back(piece);
  }
  return improper;
}

Object_case with_itself(const covering::Polyhedron& body)
{
  Object_case c;
  c.a = c.b = std::make_shared<const covering::Polyhedron>(body);
  return c;
}

}  // namespace tetracone::verify
