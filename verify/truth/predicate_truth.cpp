#include "verify/truth/predicate_truth.h"

#include "verify/truth/shared_shape.h"

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::verify {
namespace {

using Exact = CGAL::Simple_cartesian<kernel::Rational>;
using Number = Exact::FT;
using Plane = Exact::Plane_3;
using Point = Exact::Point_3;
using Ray = Exact::Ray_3;
using Segment = Exact::Segment_3;
using Tetrahedron = Exact::Tetrahedron_3;
using Triangle = Exact::Triangle_3;

/// The seven points, placed by their poses.
struct Points {
  std::array<Point, 4> v;
  Point p, q, r;

  explicit Points(const Predicate_case& c)
  {
    const auto map = [](const kernel::Pose& pose) {
      const auto m = [&](int k) { return pose.exact(k); };
      return Exact::Aff_transformation_3(m(0), m(1), m(2), m(3), m(4), m(5), m(6), m(7), m(8), m(9), m(10), m(11));
    };
    const auto point = [](const kernel::Vertex& x) { return Point(Number(x[0]), Number(x[1]), Number(x[2])); };
    const auto a = map(c.pose_a), b = map(c.pose_b);
    for (int k = 0; k < 4; ++k) v[k] = a.transform(point(c.v[k]));
    p = b.transform(point(c.p));
    q = b.transform(point(c.q));
    r = b.transform(point(c.r));
  }
};

/// The shape spanned by any three or two corners: CGAL's own triangles and segments must not be degenerate.
struct Simplex {
  int dimension;
  std::array<Point, 3> corner;  ///< dimension + 1 of them mean something

  explicit Simplex(std::array<Point, 3> corners) : dimension(2), corner(std::move(corners))
  {
    if (!CGAL::collinear(corner[0], corner[1], corner[2])) return;
    // On a line the order of the coordinates is that of the line.
    std::sort(corner.begin(), corner.end());
    corner[1] = corner[2];
    dimension = corner[0] == corner[1] ? 0 : 1;
  }
  Simplex(const Point& p, const Point& q) : Simplex(std::array{p, q, q}) {}

  /// Calls what(shape) with the point, segment or triangle.
  template <class What>
  bool with_shape(What&& what) const
  {
    if (dimension == 0) return what(corner[0]);
    if (dimension == 1) return what(Segment(corner[0], corner[1]));
    return what(Triangle(corner[0], corner[1], corner[2]));
  }

  bool meets(const Simplex& other) const
  {
    return with_shape([&](const auto& here) {
      return other.with_shape([&](const auto& there) -> bool { return Exact().do_intersect_3_object()(here, there); });
    });
  }
};

bool coplanar(const Points& x) { return CGAL::coplanar(x.v[0], x.v[1], x.v[2], x.v[3]); }

/// Returns minus the side of p of the plane v1 v2 v3, whose positive side sees v1 v2 v3 counterclockwise. There
/// det[v1-p, v2-p, v3-p] is negative.
int orientation(const Points& x)
{
  if (CGAL::collinear(x.v[1], x.v[2], x.v[3])) return 0;
  return -Plane(x.v[1], x.v[2], x.v[3]).oriented_side(x.p);
}

/// True when the ray from the apex through p runs through the triangle between the cone's own rays.
bool is_in_cone(const Points& x)
{
  return x.p == x.v[0] || CGAL::do_intersect(Ray(x.v[0], x.p), Triangle(x.v[1], x.v[2], x.v[3]));
}

int place_in_solid(const Points& x)
{
  if (!coplanar(x)) return Tetrahedron(x.v[0], x.v[1], x.v[2], x.v[3]).bounded_side(x.p);
  for (int k = 0; k < 4; ++k)
    if (Simplex({x.v[k], x.v[(k + 1) % 4], x.v[(k + 2) % 4]}).meets(Simplex(x.p, x.p))) return 0;
  return -1;
}

/// Returns the corners of the part of a convex polygon on the closed positive side of a plane. The polygon may be a
/// segment or a point.
std::vector<Point> clipped(const std::vector<Point>& polygon, const Plane& plane)
{
  std::vector<Point> kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point &from = polygon[k], &to = polygon[(k + 1) % polygon.size()];
    const CGAL::Sign side_from = plane.oriented_side(from), side_to = plane.oriented_side(to);
    if (side_from != CGAL::ON_NEGATIVE_SIDE) kept.push_back(from);
    if (side_from * side_to == CGAL::NEGATIVE) {
      const auto crossing = CGAL::intersection(Segment(from, to), plane);
      kept.push_back(*shape_in<Point>(crossing));
    }
  }
  return kept;
}

/// True when the triangle clipped by the half-spaces of the cone is not empty.
bool triangle_meets_cone(const Points& x)
{
  std::vector<Point> polygon = {x.p, x.q, x.r};
  for (int k = 1; k <= 3; ++k) {
    Plane side(x.v[0], x.v[k], x.v[k % 3 + 1]);
    if (side.has_on_negative_side(x.v[(k + 1) % 3 + 1])) side = side.opposite();
    polygon = clipped(polygon, side);
  }
  return !polygon.empty();
}

}  // namespace

std::optional<int> true_answer(Predicate predicate, const Predicate_case& c)
{
  const Points x(c);
  switch (predicate) {
    case Predicate::orientation: return orientation(x);
    case Predicate::tetra_cone:
      if (coplanar(x)) return std::nullopt;
      return is_in_cone(x);
    case Predicate::tetrahedron:
      if (coplanar(x)) return std::nullopt;
      return !Tetrahedron(x.v[0], x.v[1], x.v[2], x.v[3]).has_on_unbounded_side(x.p);
    case Predicate::segment_triangle: return Simplex(x.p, x.q).meets(Simplex({x.v[1], x.v[2], x.v[3]}));
    case Predicate::solid: return place_in_solid(x);
    case Predicate::classification:
      if (coplanar(x) || CGAL::coplanar(x.v[0], x.p, x.q, x.r)) return std::nullopt;
      return triangle_meets_cone(x);
    case Predicate::triangle_triangle: return Simplex({x.v[1], x.v[2], x.v[3]}).meets(Simplex({x.p, x.q, x.r}));
  }
  return std::nullopt;
}

}  // namespace tetracone::verify
