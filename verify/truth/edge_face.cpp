#include "verify/truth/edge_face.h"

#include "verify/truth/shared_shape.h"

#include <CGAL/intersections.h>

#include <algorithm>
#include <vector>

namespace tetracone::verify {

namespace {

// Returns the kind of contact in the one common point `p` of the edge and the face; none when it is not on the face.
Contact contact_in(const Exact::Point_3& p, const Exact::Point_3& from, const Exact::Point_3& to,
                   const Planar_face& face)
{
  const bool end = p == from || p == to;
  switch (face.locate(p)) {
    case Place::vertex: return end ? Contact::vertex_vertex : Contact::vertex_edge;
    case Place::edge: return end ? Contact::vertex_edge : Contact::edge_edge;
    case Place::face: return end ? Contact::vertex_face : Contact::edge_face;
    case Place::outside: break;
  }
  return Contact::none;
}

// Returns the ends of the edge and all ends of its intersections with the loops' edges, in the edge's order, each once.
// Between two consecutive ones, the edge is entirely in the face or entirely out of it.
std::vector<Exact::Point_3> find_cuts(const Exact::Segment_3& edge, const Planar_face& face)
{
  std::vector<Exact::Point_3> cuts = {edge.source(), edge.target()};
  for (const auto& loop : face.loops())
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Exact::Point_3& p = loop[k];
      const Exact::Point_3& q = loop[(k + 1) % loop.size()];
      if (edge.has_on(p)) cuts.push_back(p);
      if (p == q) continue;
      const auto shared = CGAL::intersection(edge, Exact::Segment_3(p, q));
      // A shared segment ends in ends of the two.
      if (!shared) continue;
      if (const auto* point = shape_in<Exact::Point_3>(shared)) cuts.push_back(*point);
    }
  const auto along = [&](const Exact::Point_3& p) { return kernel::Rational((p - edge.source()) * edge.to_vector()); };
  std::sort(cuts.begin(), cuts.end(), [&](const auto& p, const auto& q) { return along(p) < along(q); });
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

}  // namespace

Contact edge_face(const Exact::Point_3& from, const Exact::Point_3& to, const Planar_face& face)
{
  if (from == to) return contact_in(from, from, to, face);
  if (face.base()) {
    const CGAL::Sign side_from = face.side(from), side_to = face.side(to);
    if (side_from == side_to && side_from != CGAL::ZERO) return Contact::none;
    if (side_from == CGAL::ZERO && side_to != CGAL::ZERO) return contact_in(from, from, to, face);
    if (side_from != CGAL::ZERO && side_to == CGAL::ZERO) return contact_in(to, from, to, face);
    if (side_from != CGAL::ZERO) {
      const auto& [p, q, r] = *face.base();
      const auto shared = CGAL::intersection(Exact::Line_3(from, to), Exact::Plane_3(p, q, r));
      return contact_in(*shape_in<Exact::Point_3>(shared), from, to, face);
    }
  }
  // The edge lies in the face's plane, or the face is on a line.
  const std::vector<Exact::Point_3> cuts = find_cuts({from, to}, face);
  for (std::size_t k = 1; k < cuts.size(); ++k)
    if (face.locate(CGAL::midpoint(cuts[k - 1], cuts[k])) != Place::outside) return Contact::coplanar_overlap;
  Contact kind = Contact::none;
  for (const Exact::Point_3& cut : cuts) {
    const Contact here = contact_in(cut, from, to, face);
    if (here == Contact::none) continue;
    if (kind != Contact::none) return Contact::coplanar_overlap;
    kind = here;
  }
  return kind;
}

}  // namespace tetracone::verify
