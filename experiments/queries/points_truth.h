#ifndef TETRACONE_EXPERIMENTS_QUERIES_POINTS_TRUTH_H
#define TETRACONE_EXPERIMENTS_QUERIES_POINTS_TRUTH_H

#include "experiments/support/extent.h"
#include "tetracone/tetratree/ray_hit.h"
#include "verify/cases/random.h"
#include "verify/truth/cgal_truth.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#if __has_include(<CGAL/AABB_traits_3.h>)  // CGAL 6, which warns of the other header
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <cmath>
#include <optional>
#include <vector>

namespace tetracone::experiments {

using Exact_predicates = CGAL::Exact_predicates_inexact_constructions_kernel;
using Cgal_mesh = CGAL::Surface_mesh<Exact_predicates::Point_3>;
using Cgal_primitive = CGAL::AABB_face_graph_triangle_primitive<Cgal_mesh>;
#if __has_include(<CGAL/AABB_traits_3.h>)
using Cgal_tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Exact_predicates, Cgal_primitive>>;
#else
using Cgal_tree = CGAL::AABB_tree<CGAL::AABB_traits<Exact_predicates, Cgal_primitive>>;
#endif

/// Returns points at random in a box a tenth larger than the body's. With `near_surface`, each is within 1e-3 of a
/// random point of a random face, where 1 is half of the body's largest extent; this requires triangles.
inline std::vector<std::array<double, 3>> points_of(const covering::Polyhedron& body, bool near_surface, int count,
                                                    verify::Random& random)
{
  using Point = std::array<double, 3>;
  const auto [low, high] = extent_of(body);
  const double half = extent_of(body).longest_side() / 2;
  std::vector<Point> points;
  for (int n = 0; n < count; ++n) {
    Point p;
    if (near_surface) {
      const auto loop = body.loop(covering::Index(random.bits() % body.face_count()), 0);
      const auto on = random.in_triangle({body.vertices[loop[0]], body.vertices[loop[1]], body.vertices[loop[2]]});
      const auto off = random.in_ball();
      for (int k = 0; k < 3; ++k) p[k] = on[k] + 1e-3 * half * off[k];
    } else {
      for (int k = 0; k < 3; ++k) p[k] = low[k] + (high[k] - low[k]) * (1.1 * random.unit() - 0.05);
    }
    points.push_back(p);
  }
  return points;
}

/// The truth for points and meshes of many triangles. It sums the signed crossings of the upward ray by CGAL's exact
/// predicates. A grid over x and y finds the triangles above and below. Degenerate cases are decided in rationals, by
/// all pairs whose boxes meet.
class Column_truth {
 public:
  using Point = std::array<double, 3>;

  /// Requires a closed mesh of triangles that outlives this, and whose extents in x and y are above 0.
  explicit Column_truth(const covering::Polyhedron& mesh)
      : mesh_(&mesh), body_(mesh), placed_(body_, kernel::Pose()), extent_(extent_of(mesh))
  {
    side_ = std::clamp(int(std::sqrt(double(mesh.face_count()) / 4)), 1, 1000);
    columns_.resize(std::size_t(side_) * std::size_t(side_));
    for (covering::Index f = 0; f < mesh.face_count(); ++f) {
      const auto [x0, x1] = std::minmax({corner(f, 0)[0], corner(f, 1)[0], corner(f, 2)[0]});
      const auto [y0, y1] = std::minmax({corner(f, 0)[1], corner(f, 1)[1], corner(f, 2)[1]});
      for (int i = place(x0, 0); i <= place(x1, 0); ++i)
        for (int j = place(y0, 1); j <= place(y1, 1); ++j) columns_[std::size_t(i * side_ + j)].push_back(f);
    }
    covering::Polyhedron origin;
    origin.vertices = {{0, 0, 0}};
    origin.add_polygon({0});
    dot_.emplace(origin);
  }

  /// Returns 1 inside, 0 on the surface, -1 outside.
  long operator()(const Point& p) const
  {
    for (int k = 0; k < 2; ++k)
      if (p[k] < extent_.low[k] || p[k] > extent_.high[k]) return -1;
    const auto in_plane = [](const Point& v) { return Exact_predicates::Point_2(v[0], v[1]); };
    const auto in_space = [](const Point& v) { return Exact_predicates::Point_3(v[0], v[1], v[2]); };
    int winding = 0;
    for (const covering::Index f : columns_[std::size_t(place(p[0], 0) * side_ + place(p[1], 1))]) {
      int sides[3];
      for (int k = 0; k < 3; ++k)
        sides[k] = CGAL::orientation(in_plane(corner(f, k)), in_plane(corner(f, (k + 1) % 3)), in_plane(p));
      const auto [least, most] = std::minmax({sides[0], sides[1], sides[2]});
      if (least < 0 && most > 0) continue;
      if (least == 0 || most == 0) return in_rationals(p);
      const int above =
          CGAL::orientation(in_space(corner(f, 0)), in_space(corner(f, 1)), in_space(corner(f, 2)), in_space(p));
      if (above == 0) return 0;
      if (above != most) winding += most > 0 ? 1 : -1;
    }
    return winding != 0 ? 1 : -1;
  }

  /// Returns what operator() returns, decided in rationals by all triangles whose boxes meet.
  long in_rationals(const Point& p) const
  {
    const verify::Placed_body moved(*dot_, kernel::Pose::translation(p[0], p[1], p[2]));
    if (verify::detail::surfaces_meet(placed_, moved)) return 0;
    return verify::detail::winding(placed_, moved, 0) != 0 ? 1 : -1;
  }

 private:
  const Point& corner(covering::Index f, int k) const { return mesh_->vertices[mesh_->loop(f, 0)[std::size_t(k)]]; }

  /// Returns the grid's cell of x along an axis, which is monotone in x under rounding.
  int place(double x, int axis) const
  {
    const double low = extent_.low[axis], high = extent_.high[axis];
    return std::clamp(int((x - low) / (high - low) * side_), 0, side_ - 1);
  }

  const covering::Polyhedron* mesh_;
  verify::Brute_body body_;
  verify::Placed_body placed_;
  std::optional<verify::Brute_body> dot_;
  Extent extent_;
  int side_;
  std::vector<std::vector<covering::Index>> columns_;
};

/// What stands for a face where a ray meets none.
inline constexpr long no_face = -1;

/// Returns the face that the ray meets at the least t; among those of equal t, the one of the least number. It returns
/// `no_face` if there are no `faces`. It computes in rationals. Requires triangles, all of which the ray meets, and
/// none whose plane contains it.
template <class Faces>
long first_of(const covering::Polyhedron& mesh, const tetratree::Ray& ray, const Faces& faces)
{
  using Exact = verify::Exact;
  const auto point = [](const std::array<double, 3>& v) { return Exact::Point_3(v[0], v[1], v[2]); };
  const Exact::Point_3 origin = point(ray.origin);
  const Exact::Vector_3 direction(ray.direction[0], ray.direction[1], ray.direction[2]);
  long best = no_face;
  kernel::Rational least;
  for (const covering::Index f : faces) {
    const auto corner = [&](int k) { return point(mesh.vertices[mesh.loop(f, 0)[std::size_t(k)]]); };
    const Exact::Vector_3 normal = CGAL::cross_product(corner(1) - corner(0), corner(2) - corner(0));
    const kernel::Rational t = kernel::Rational(normal * (corner(0) - origin)) / kernel::Rational(normal * direction);
    if (best == no_face || t < least || (t == least && long(f) < best)) {
      best = long(f);
      least = t;
    }
  }
  return best;
}

}  // namespace tetracone::experiments

#endif
