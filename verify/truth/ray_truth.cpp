#include "verify/truth/ray_truth.h"

#include "verify/truth/shared_shape.h"

#include <CGAL/intersections.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::verify {

namespace {

// Calls see(p) for the ends of the intersection of the line and the element.
template <class See>
void meet(const Exact::Line_3& line, const Brute_body& face, const Element& element, const See& see)
{
  const auto corner = [&](int k) -> const Exact::Point_3& { return face.points()[element.corners[k]]; };
  const auto see_all = [&](const auto& shared) {
    if (!shared) return;
    if (const auto* p = shape_in<Exact::Point_3>(shared)) see(*p);
    if (const auto* s = shape_in<Exact::Segment_3>(shared)) {
      see(s->source());
      see(s->target());
    }
  };
  switch (element.dimension) {
    case 0:
      if (line.has_on(corner(0))) see(corner(0));
      break;
    case 1: see_all(CGAL::intersection(line, Exact::Segment_3(corner(0), corner(1)))); break;
    default: see_all(CGAL::intersection(line, Exact::Triangle_3(corner(0), corner(1), corner(2))));
  }
}

}  // namespace

Ray_truth::Ray_truth(const covering::Polyhedron& polyhedron)
{
  for (Index f = 0; f < polyhedron.face_count(); ++f) faces_.emplace_back(face_alone(polyhedron, f));
}

std::vector<std::pair<kernel::Rational, Index>> Ray_truth::operator()(const kernel::Vertex& o,
                                                                      const kernel::Vertex& d) const
{
  const Exact::Point_3 origin(o[0], o[1], o[2]);
  const Exact::Vector_3 direction(d[0], d[1], d[2]);
  const Exact::Line_3 line(origin, direction);
  std::vector<std::pair<kernel::Rational, Index>> met;
  for (Index f = 0; f < faces_.size(); ++f) {
    std::optional<kernel::Rational> least;
    for (const Element& element : faces_[f].elements()) {
      std::vector<kernel::Rational> ends;
      meet(line, faces_[f], element, [&](const Exact::Point_3& p) {
        ends.push_back(kernel::Rational((p - origin) * direction) / kernel::Rational(direction.squared_length()));
      });
      std::sort(ends.begin(), ends.end());
      if (ends.empty() || ends.back() < 0) continue;
      const kernel::Rational t = ends.front() < 0 ? kernel::Rational(0) : ends.front();
      if (!least || t < *least) least = t;
    }
    if (least) met.emplace_back(*least, f);
  }
  std::sort(met.begin(), met.end());
  return met;
}

}  // namespace tetracone::verify
