#include "verify/truth/overlap_truth.h"

#include "verify/truth/cgal_truth.h"
#include "verify/truth/surface_pieces.h"

#include <algorithm>
#include <array>
#include <vector>

namespace tetracone::verify {
namespace {

using kernel::Rational;
using kernel::Solid_relation;
using namespace object_family;

// Two placed solids, and the pieces of their surfaces.
class Two_solids {
 public:
  Two_solids(const Placed_body& a, const Placed_body& b)
      : placed_{&a, &b},
        scale_(lcm(common_denominator(a), common_denominator(b))),
        surfaces_{placed_elements(a, scale_), placed_elements(b, scale_)},
        pieces_(surface_pieces(surfaces_)),
        curves_(curve_pieces(surfaces_))
  {}

  bool share_interior() const { return verify::share_interior(pieces_); }

  // True when some part of a body's surface is in the other solid, or on its surface.
  bool has_surface_in(int body, int other) const
  {
    return std::ranges::any_of(pieces_,
                               [&](const Surface_piece& piece) {
                                 const auto& [below, above] = piece.winding[other];
                                 return piece.body == body && (piece.is_on[other] || below != 0 || above != 0);
                               }) ||
           std::ranges::any_of(curves_, [&](const Curve_piece& curve) {
             return curve.body == body && inside(*placed_[other], unscaled(curve.middle)) >= 0;
           });
  }

  bool lies_in(int body, int other) const
  {
    const auto leaves = [&](const Surface_piece& piece) {
      for (int side = 0; side < 2; ++side) {
        if (piece.winding[other][side] != 0) continue;
        if (piece.winding[body][side] != 0 || (piece.body == body && !piece.is_on[other])) return true;
      }
      return false;
    };
    return std::ranges::none_of(pieces_, leaves) && std::ranges::none_of(curves_, [&](const Curve_piece& curve) {
             return curve.body == body && inside(*placed_[other], unscaled(curve.middle)) < 0;
           });
  }

  // True when the surface of a body shares a point with the border of the other solid's interior.
  bool touches_border(int body, int other) const
  {
    const std::vector<Placed_element> border = interior_border(other);
    return std::ranges::any_of(surfaces_[body], [&](const Placed_element& x) {
      return std::ranges::any_of(border, [&](const Placed_element& y) { return meet(x, y); });
    });
  }

  // Adds up the tetrahedra from the origin to the pieces with the overlap on one side.
  void set_overlap(Solid_overlap& overlap) const
  {
    for (const Surface_piece& piece : pieces_) {
      const int outward = int(piece.is_common(0)) - int(piece.is_common(1));
      if (outward == 0 || !piece.is_first) continue;
      for (const int k : {1, 2}) {
        const Exact_vector &p = piece.corner[0], &q = piece.corner[k], &r = piece.corner[k + 1];
        const Rational volume = outward * dot(p, cross(q, r)) / 6;
        overlap.volume += volume;
        overlap.centroid = sum(overlap.centroid, Rational(volume / 4), sum(sum(p, q), r));
      }
    }
    if (overlap.volume == 0) return;
    overlap.centroid = unscaled(times(Rational(1 / overlap.volume), overlap.centroid));
    overlap.volume /= scale_ * scale_ * scale_;
  }

  // The area of the pieces of A that lie on B. A piece's corners run counterclockwise, seen from above.
  Shared_area shared_area() const
  {
    const Rational unit = Rational(1, scale_ * scale_) / 2;
    Shared_area shared;
    std::vector<Exact_vector> areas;  // by direction: the sum of parallel ones
    for (const Surface_piece& piece : pieces_) {
      if (piece.body != 0 || !piece.is_on[1] || !piece.is_first) continue;
      const auto& [p, q, r, s] = piece.corner;
      const Exact_vector area = times(unit, cross(difference(r, p), difference(s, q)));
      if (is_zero(area)) continue;
      const auto& [below, above] = piece.winding[0];
      shared.vector = sum(shared.vector, times(Rational(int(below != 0) - int(above != 0)), area));
      const auto same = std::ranges::find_if(areas, [&](const auto& other) { return is_zero(cross(other, area)); });
      if (same == areas.end())
        areas.push_back(area);
      else
        *same = sum(*same, times(Rational(sgn(dot(*same, area))), area));
    }
    for (const Exact_vector& area : areas) shared.squares.push_back(dot(area, area));
    std::ranges::sort(shared.squares);
    return shared;
  }

 private:
  Exact_vector unscaled(const Exact_vector& x) const { return times(Rational(1, scale_), x); }

  std::vector<Placed_element> interior_border(int body) const
  {
    std::vector<Placed_element> border;
    for (const Surface_piece& piece : pieces_) {
      const auto& [below, above] = piece.winding[body];
      if (piece.body != body || (below != 0 && above != 0)) continue;
      for (const int k : {1, 2}) {
        const Placed_element part(2, 0, {piece.corner[0], piece.corner[k], piece.corner[k + 1]});
        if (!is_zero(part.normal)) border.push_back(part);
      }
    }
    // A curve that is in the interior, or on a triangle, has said nothing new. One that is off both is border.
    for (const Curve_piece& curve : curves_) {
      if (curve.body != body) continue;
      const Placed_element part(curve.from == curve.to ? 0 : 1, 0, {curve.from, curve.to, curve.from});
      if (is_outside_of_triangles(body, curve.middle)) border.push_back(part);
    }
    return border;
  }

  // True when a point is on no triangle of the body's, and has winding number 0.
  bool is_outside_of_triangles(int body, const Exact_vector& x) const
  {
    const Placed_element point(0, 0, {x, x, x});
    for (const Placed_element& element : surfaces_[body])
      if (element.dimension == 2 && meet(element, point)) return false;
    return detail::winding(*placed_[body], unscaled(x)) == 0;
  }

  std::array<const Placed_body*, 2> placed_;
  mpz_class scale_;  // the pieces' coordinates are the true ones times this
  std::array<std::vector<Placed_element>, 2> surfaces_;
  std::vector<Surface_piece> pieces_;
  std::vector<Curve_piece> curves_;
};

Solid_relation relation(const Two_solids& solids, bool surfaces_meet)
{
  if (!surfaces_meet && !solids.has_surface_in(0, 1) && !solids.has_surface_in(1, 0)) return Solid_relation::disjoint;
  const bool a_in_b = solids.lies_in(0, 1), b_in_a = solids.lies_in(1, 0);
  if (a_in_b && b_in_a) return Solid_relation::equal;
  if (a_in_b) return solids.touches_border(0, 1) ? Solid_relation::covered_by : Solid_relation::inside;
  if (b_in_a) return solids.touches_border(1, 0) ? Solid_relation::covers : Solid_relation::contains;
  return solids.share_interior() ? Solid_relation::overlap : Solid_relation::meet;
}

}  // namespace

Solid_overlap solid_overlap(const Object_case& c)
{
  Shared_area shared;
  return solid_overlap(c, shared);
}

Solid_overlap solid_overlap(const Object_case& c, Shared_area& shared)
{
  const Brute_body body_a(*c.a), body_b(*c.b);
  const Placed_body a(body_a, c.pose_a), b(body_b, c.pose_b);
  detail::require_closed(a, b);
  const Two_solids solids(a, b);
  Solid_overlap overlap;
  overlap.contact.dimension = dimension(contacts(c));
  overlap.contact.relation = relation(solids, overlap.contact.dimension >= 0);
  solids.set_overlap(overlap);
  shared = solids.shared_area();
  return overlap;
}

}  // namespace tetracone::verify
