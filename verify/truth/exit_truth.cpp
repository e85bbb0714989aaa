#include "verify/truth/exit_truth.h"

#include "verify/truth/cgal_truth.h"
#include "verify/truth/surface_pieces.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace tetracone::verify {
namespace {

using kernel::Rational;
using namespace object_family;

using Ends = std::pair<Exact_vector, Exact_vector>;

Placed_element moved_by(const Placed_element& element, const Exact_vector& shift)
{
  std::array<Exact_vector, 3> corner;
  for (int k = 0; k < 3; ++k) corner[k] = sum(element.corner[k], shift);
  return {element.dimension, element.winding, corner};
}

Placed_element as_point(const Exact_vector& x) { return {0, 0, {x, x, x}}; }
Placed_element as_segment(const Ends& s) { return {1, 0, {s.first, s.second, s.first}}; }

// The triangles of a placed surface, their corners and their edges.
struct Surface {
  std::vector<Placed_element> elements;
  std::vector<const Placed_element*> triangles;
  std::set<Exact_vector> corners;
  std::set<Ends> edges;

  Surface(const Placed_body& placed, const mpz_class& scale) : elements(placed_elements(placed, scale))
  {
    for (const Placed_element& element : elements) {
      if (element.dimension < 2) continue;
      triangles.push_back(&element);
      for (int k = 0; k < 3; ++k) {
        corners.insert(element.corner[k]);
        edges.insert(std::minmax(element.corner[k], element.corner[(k + 1) % 3]));
      }
    }
  }
};

struct Two_surfaces {
  mpz_class scale;  // coordinates are the true ones times this
  Surface a, b;
};

Two_surfaces surfaces_of(const Object_case& c)
{
  const Brute_body body_a(*c.a), body_b(*c.b);
  const Placed_body a(body_a, c.pose_a), b(body_b, c.pose_b);
  detail::require_closed(a, b);
  const mpz_class scale = lcm(common_denominator(a), common_denominator(b));
  return {scale, Surface(a, scale), Surface(b, scale)};
}

bool share_interior(const Two_surfaces& both, const Exact_vector& shift)
{
  std::array<std::vector<Placed_element>, 2> surfaces = {std::vector<Placed_element>(), both.b.elements};
  for (const Placed_element& element : both.a.elements) surfaces[0].push_back(moved_by(element, shift));
  return share_interior(surface_pieces(surfaces));
}

// Adds the shifts s > 0 at which x + s d is on a triangle.
void add_events(const Exact_vector& x, const Exact_vector& d, const Surface& surface, int sign,
                std::set<Rational>& events)
{
  for (const Placed_element* triangle : surface.triangles) {
    const Rational rise = dot(triangle->normal, d);
    if (rise == 0) continue;
    const Rational s = dot(triangle->normal, difference(triangle->corner[0], x)) / rise;
    if (sgn(s) * sign > 0 && meet(as_point(sum(x, s, d)), *triangle)) events.insert(abs(s));
  }
}

// A normal n, and the least width for which every translation v of A with n . v >= width parts two convex solids.
struct Width {
  Exact_vector normal;
  Rational width;
};

// Returns the widths along both directions of all normals of the Minkowski difference, and along others.
std::vector<Width> widths(const Object_case& c)
{
  const Two_surfaces both = surfaces_of(c);
  std::vector<Exact_vector> normals;
  for (const Surface* surface : {&both.a, &both.b})
    for (const Placed_element* triangle : surface->triangles) normals.push_back(triangle->normal);
  for (const Ends& e : both.a.edges)
    for (const Ends& f : both.b.edges)
      normals.push_back(cross(difference(e.second, e.first), difference(f.second, f.first)));
  std::vector<Width> widths;
  for (const Exact_vector& n : normals) {
    if (is_zero(n)) continue;
    for (const int sign : {1, -1}) {
      const Exact_vector axis = times(Rational(sign), n);
      Rational largest_of_b = dot(axis, *both.b.corners.begin()), least_of_a = dot(axis, *both.a.corners.begin());
      for (const Exact_vector& x : both.b.corners) largest_of_b = std::max(largest_of_b, dot(axis, x));
      for (const Exact_vector& x : both.a.corners) least_of_a = std::min(least_of_a, dot(axis, x));
      widths.push_back({axis, (largest_of_b - least_of_a) / both.scale});
    }
  }
  return widths;
}

}  // namespace

Solid_exits exits_by_events(const Object_case& c, const Exact_vector& direction)
{
  const Two_surfaces both = surfaces_of(c);
  const Exact_vector d = times(Rational(both.scale), direction);
  if (!share_interior(both, {0, 0, 0})) return {0, 0};
  std::set<Rational> events;
  for (const Exact_vector& x : both.a.corners) add_events(x, d, both.b, 1, events);
  for (const Exact_vector& x : both.b.corners) add_events(x, d, both.a, -1, events);
  for (const Ends& e : both.a.edges)
    for (const Ends& f : both.b.edges) {
      const Exact_vector normal = cross(difference(e.second, e.first), difference(f.second, f.first));
      const Rational rise = dot(normal, d);
      if (rise == 0) continue;
      const Rational s = dot(normal, difference(f.first, e.first)) / rise;
      const Exact_vector shift = times(s, d);
      if (s > 0 && meet(as_segment({sum(e.first, shift), sum(e.second, shift)}), as_segment(f))) events.insert(s);
    }
  Solid_exits exits;
  // The set of shifts at which interiors share a point is open, so it does not hold the event at which it ends.
  exits.first = *std::ranges::find_if(events, [&](const Rational& s) { return !share_interior(both, times(s, d)); });
  for (auto last = events.rbegin(); last != events.rend(); ++last) {
    const Rational before = std::next(last) == events.rend() ? Rational(0) : *std::next(last);
    exits.last = *last;
    if (share_interior(both, times((*last + before) / 2, d))) break;
  }
  return exits;
}

Rational convex_exit(const Object_case& c, const Exact_vector& direction)
{
  std::optional<Rational> exit;
  for (const auto& [normal, width] : widths(c)) {
    const Rational rise = dot(normal, direction);
    if (width <= 0) return 0;
    if (rise > 0 && (!exit || width / rise < *exit)) exit = width / rise;
  }
  return *exit;
}

Rational convex_squared_depth(const Object_case& c)
{
  std::optional<Rational> least;
  for (const auto& [normal, width] : widths(c)) {
    if (width <= 0) return 0;
    const Rational square = width * width / dot(normal, normal);
    if (!least || square < *least) least = square;
  }
  return *least;
}

}  // namespace tetracone::verify
