#include "verify/families/probe_families.h"

#include "tetracone/covering/edge_uses.h"
#include "tetracone/covering/orient.h"
#include "tetracone/kernel/bound/cone_lattice.h"
#include "verify/families/families.h"
#include "verify/families/probe_placing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace tetracone::verify {
namespace probe_family {
namespace {

// --- points ----------------------------------------------------------------------------------------------------------

Probe point_anywhere(Random& random, const Probed_body& body, double parts)
{
  return {anywhere(random, body, int(parts)), {}};
}

Probe point_on_vertex(Random& random, const Probed_body& body, double ulps)
{
  const Vertex p = on_surface(random, body, 0);
  return {next_to(random, p, int(ulps)), {}};
}

Probe point_on_edge(Random& random, const Probed_body& body, double bits)
{
  return {on_edge(random, body, int(bits)), {}};
}

Probe point_on_face(Random& random, const Probed_body& body, double bits)
{
  return {on_face(random, body, int(bits)), {}};
}

Probe point_near_surface(Random& random, const Probed_body& body, double ulps)
{
  const int dimension = integer(random, 1, 2);
  const Vertex p = on_surface(random, body, dimension);
  return {next_to(random, p, int(ulps)), {}};
}

Probe point_on_plane(Random& random, const Probed_body& body, double times)
{
  const auto corners = any_corners(random, body);
  const int s = integer(random, -3, 3), t = integer(random, -3, 3);
  return {nearest(spanned(corners, Rational(times * s), Rational(times * t))), {}};
}

Probe point_on_line(Random& random, const Probed_body& body, double times)
{
  const auto corners = any_corners(random, body);
  const int sign = integer(random, 0, 1) == 0 ? 1 : -1;
  return {nearest(between(corners[0], corners[1], Rational(sign * times))), {}};
}

Probe point_of_coordinates(Random& random, const Probed_body& body, double ulps)
{
  const Vertex p = of_coordinates(random, body);
  return {next_to(random, p, int(ulps)), {}};
}

Probe point_at_origin(Random& random, const Probed_body& body, double ulps)
{
  return {next_to(random, body.origin, int(ulps)), {}};
}

Probe point_on_cone(Random& random, const Probed_body& body, double times)
{
  const int dimension = integer(random, 0, 2);
  const Vertex p = on_surface(random, body, dimension);
  return {nearest(between(body.origin, p, Rational(times))), {}};
}

/// On borders of cells of the lattice of n steps a side over each octant of directions.
Probe point_on_cell(Random& random, const Probed_body& body, double steps)
{
  const int n = int(steps), i = integer(random, 0, n), j = integer(random, 0, n - i);
  const Vertex step = {double(i) / n, double(j) / n, double(n - i - j) / n};
  const double size = (body.high[0] / 2 - body.low[0] / 2) * integer(random, 1, 16) / 8;
  Vertex p = body.origin;
  for (std::size_t k = 0; k < 3; ++k) p[k] += (integer(random, 0, 1) == 0 ? size : -size) * step[k];
  return {nearest(exact(std::isfinite(magnitude(p)) ? p : body.origin)), {}};
}

Probe point_of_any_size(Random& random, const Probed_body&, double exponent)
{
  Vertex p;
  for (double& x : p) x = std::ldexp(random.symmetric(), int(exponent));
  return {p, {}};
}

// --- rays ------------------------------------------------------------------------------------------------------------

/// A direction of small integers times a power of two, about the body's size or some powers smaller.
Exact_vector short_direction(Random& random, const Probed_body& body)
{
  const double size = std::max(magnitude(body.low), magnitude(body.high));
  const int power = (size > 0 ? std::ilogb(size) : 0) - integer(random, 1, 16);
  const double unit = std::ldexp(1.0, std::max(power, -1074));
  for (;;) {
    Exact_vector d;
    for (Rational& x : d) x = Rational(unit) * integer(random, -4, 4);
    if (!object_family::is_zero(d)) return d;
  }
}

/// Through p at t = k: exactly, where doubles can have where it starts.
Probe through(const Vertex& p, const Exact_vector& direction, int k)
{
  return {nearest(object_family::sum(exact(p), Rational(-k), direction)), nearest(direction)};
}

Probe through_any(Random& random, const Probed_body& body, int dimension)
{
  const Vertex p = on_surface(random, body, dimension);
  const Exact_vector direction = short_direction(random, body);
  return through(p, direction, integer(random, -2, 16));
}

Probe ray_anywhere(Random& random, const Probed_body& body, double parts)
{
  const Vertex from = anywhere(random, body, int(parts)), to = anywhere(random, body, int(parts));
  return {from, nearest(object_family::difference(exact(to), exact(from)))};
}

Probe ray_through_vertex(Random& random, const Probed_body& body, double ulps)
{
  const Probe probe = through_any(random, body, 0);
  return {next_to(random, probe.from, int(ulps)), probe.direction};
}

Probe ray_through_edge(Random& random, const Probed_body& body, double ulps)
{
  const Probe probe = through_any(random, body, 1);
  return {next_to(random, probe.from, int(ulps)), probe.direction};
}

Probe ray_along_edge(Random& random, const Probed_body& body, double times)
{
  const auto corners = any_corners(random, body);
  const int sign = integer(random, 0, 1) == 0 ? 1 : -1;
  const Exact_vector along = object_family::difference(exact(corners[1]), exact(corners[0]));
  return {nearest(between(corners[0], corners[1], Rational(times))),
          nearest(object_family::times(Rational(sign), along))};
}

Probe ray_in_plane(Random& random, const Probed_body& body, double times)
{
  const auto corners = any_corners(random, body);
  const int i = integer(random, -3, 3), j = integer(random, -3, 3), s = integer(random, -2, 2),
            t = integer(random, -2, 2);
  const Exact_vector direction =
      object_family::difference(spanned(corners, Rational(i), Rational(j)), exact(corners[0]));
  return {nearest(spanned(corners, Rational(times * s), Rational(times * t))), nearest(direction)};
}

Probe ray_from_surface(Random& random, const Probed_body& body, double dimension)
{
  const Vertex p = on_surface(random, body, int(dimension));
  if (integer(random, 0, 1) == 0) return {p, nearest(short_direction(random, body))};
  const Vertex to = on_surface(random, body, int(dimension));
  return {p, nearest(object_family::difference(exact(to), exact(p)))};
}

Probe ray_along_axis(Random& random, const Probed_body& body, double ulps)
{
  const Vertex from = of_coordinates(random, body);
  const int exponent = integer(random, -60, 60);
  Vertex direction{};
  direction[one_of(random, 3)] = std::ldexp(integer(random, 0, 1) == 0 ? 1.0 : -1.0, exponent);
  return {next_to(random, from, int(ulps)), direction};
}

Probe ray_from_origin(Random& random, const Probed_body& body, double dimension)
{
  const Vertex p = on_surface(random, body, int(dimension));
  return {body.origin, nearest(object_family::difference(exact(p), exact(body.origin)))};
}

Probe ray_of_any_length(Random& random, const Probed_body& body, double exponent)
{
  Probe probe = through_any(random, body, integer(random, 0, 2));
  const double size = magnitude(probe.direction);
  for (double& x : probe.direction) x = std::ldexp(x, int(exponent) - (size > 0 ? std::ilogb(size) : 0));
  return probe;
}

Probe ray_from_afar(Random& random, const Probed_body& body, double exponent)
{
  const Vertex p = on_surface(random, body, integer(random, 0, 2));
  const Exact_vector direction = short_direction(random, body);
  return {nearest(object_family::sum(exact(p), Rational(-std::ldexp(1.0, int(exponent))), direction)),
          nearest(direction)};
}

Probe ray_at_flat_faces(Random& random, const Probed_body& body, double which)
{
  if (which == 0) return ray_along_edge(random, body, integer(random, -2, 2));
  return through_any(random, body, int(which) - 1);
}

using Entries = std::vector<Probe_family>;

Entries entries_of_points()
{
  return {
      {{"point-anywhere", "points in and about the box", "parts that its sides are cut in; 0: any doubles", {0, 12, 3}},
       {},
       point_anywhere},
      {{"point-on-vertex", "at a vertex", "ulps beside it", {0, 1, 2, 16}}, {}, point_on_vertex},
      {{"point-on-edge", "on an edge, at i / 2^k", "k", {1, 3, 10, 30, 52}}, {}, point_on_edge},
      {{"point-on-face", "in a face, at i / 2^k and j / 2^k", "k", {1, 3, 10, 26, 52}}, {}, point_on_face},
      {{"point-near-surface", "beside an edge or a face", "ulps", {1, 2, 16, 1024}}, {}, point_near_surface},
      {{"point-on-plane", "in a face's plane, as a rule beyond it", "times its sides", {1, 0.5, 64, 0x1p30}},
       {},
       point_on_plane},
      {{"point-on-line", "on an edge's line beyond it", "times its length", {2, 3, 64, 0x1p30}}, {}, point_on_line},
      {{"point-of-coordinates", "each coordinate a vertex's", "ulps beside it", {0, 1, 2}}, {}, point_of_coordinates},
      {{"point-at-origin", "at the covering's origin", "ulps beside it", {0, 1, 2, 16, 1024}}, {}, point_at_origin},
      {{"point-on-cone",
        "in line with the covering's origin and a point of the surface",
        "times its distance",
        {0.5, 0x1p-10, 0x1p-50, 1, 1.5, 2, -1}},
       {},
       point_on_cone},
      {{"point-on-cell", "on borders of cells of directions", "their number on a side", {1, 2, 4, 8, 16, 32}},
       {},
       point_on_cell},
      {{"point-of-any-size", "coordinates of any exponent", "exponent", {-1070, -500, -20, 0, 20, 500, 1023}},
       {},
       point_of_any_size},
  };
}

Entries entries_of_rays()
{
  return {
      {{"ray-anywhere",
        "from and to points in and about the box",
        "parts that its sides are cut in; 0: any doubles",
        {0, 12, 3}},
       {},
       ray_anywhere},
      {{"ray-through-vertex", "through a vertex", "ulps beside it", {0, 1, 2, 16}}, {}, ray_through_vertex},
      {{"ray-through-edge", "through an edge", "ulps beside it", {0, 1, 2, 16}}, {}, ray_through_edge},
      {{"ray-along-edge", "along an edge, either way", "where on its line it starts", {0, 1, -1, -2, 0.5, 2, 0.25}},
       {},
       ray_along_edge},
      {{"ray-in-plane", "in a face's plane", "where it starts, times its sides", {1, 0.5, 0.25, 8}}, {}, ray_in_plane},
      {{"ray-from-surface", "from a point of the surface", "0 vertex, 1 edge, 2 face", {0, 1, 2}},
       {},
       ray_from_surface},
      {{"ray-along-axis", "along an axis, each coordinate a vertex's", "ulps beside it", {0, 1, 2}},
       {},
       ray_along_axis},
      {{"ray-from-origin", "from the covering's origin", "to a 0 vertex, 1 edge, 2 face", {0, 1, 2}},
       {},
       ray_from_origin},
      {{"ray-of-any-length", "directions as long as 2^e", "e", {-1070, -1000, -500, -30, 30, 500, 1000, 1022}},
       {},
       ray_of_any_length},
      {{"ray-from-afar", "from 2^f directions before a point of the surface", "f", {8, 20, 40, 52, 100, 500}},
       {},
       ray_from_afar},
      {{"ray-at-flat-faces",
        "at bodies some of whose faces are segments or points, or are there twice",
        "0 along an edge, 1 through a vertex, 2 through an edge, 3 through a face",
        {0, 1, 2, 3}},
       {"degenerate-face", "duplicates", "sliver"},
       ray_at_flat_faces},
  };
}

}  // namespace
}  // namespace probe_family

namespace {

/// With one face less: rays ask surfaces, which need not be closed.
std::shared_ptr<const covering::Polyhedron> opened(const covering::Polyhedron& body, covering::Index without)
{
  covering::Polyhedron open;
  open.vertices = body.vertices;
  for (covering::Index f = 0; f < body.face_count(); ++f)
    if (f != without) append_face(open, body, f, false);
  return std::make_shared<const covering::Polyhedron>(std::move(open));
}

/// A closed body of any case of the families.
std::shared_ptr<const covering::Polyhedron> any_body(Random& random, const std::vector<std::string_view>& from)
{
  for (;;) {
    const Family& any = families()[one_of(random, families().size())];
    const Family& family = from.empty() ? any : *find_family(from[one_of(random, from.size())]);
    if (family.name == "many-faces") continue;
    const std::uint64_t seed = random.bits() >> 2, index = random.bits() % 1024;
    const Object_case c = family.object_case(seed, index);
    const auto& body = one_of(random, 2) == 0 ? c.a : c.b;
    if (body->face_count() <= Probe_family::most_faces && covering::is_closed(*body)) return body;
  }
}

}  // namespace

Probed_body probed(std::shared_ptr<const covering::Polyhedron> body)
{
  Probed_body probed{std::move(body), {}, {}, {}};
  const auto& vertices = probed.body->vertices;
  probed.origin = kernel::cone_lattice(vertices).origin;
  probed.low = probed.high = vertices[0];
  for (const kernel::Vertex& v : vertices)
    for (std::size_t k = 0; k < 3; ++k) {
      probed.low[k] = std::min(probed.low[k], v[k]);
      probed.high[k] = std::max(probed.high[k], v[k]);
    }
  return probed;
}

namespace {

Random random_of(std::uint64_t seed, const Probe_family& family, std::uint64_t part, std::uint64_t index)
{
  return random_of_case(seed, (std::uint64_t(1) << 40) ^ std::uint64_t(2 * family.number) ^ part, index);
}

}  // namespace

Probe_case Probe_family::probe_case(std::uint64_t seed, std::uint64_t index) const
{
  // The body of this thread's last case is kept: making a body takes longer than placing a point.
  thread_local std::array<std::uint64_t, 3> of{};
  thread_local Probed_body body;
  const std::array<std::uint64_t, 3> asked = {seed, std::uint64_t(number), index / cases_a_body};
  const bool is_ray = name.starts_with("ray");
  if (!body.body || of != asked) {
    Random random = random_of(seed, *this, 0, index / cases_a_body);
    body = probed(any_body(random, from));
    const std::size_t faces = body.body->face_count();
    if (is_ray && one_of(random, 8) == 0 && faces > 1)
      body.body = opened(*body.body, covering::Index(one_of(random, faces)));
    of = asked;
  }
  Random random = random_of(seed, *this, 1, index);
  const Origin of_case = origin(seed, index);
  Probe probe = make(random, body, of_case.parameter);
  if (is_ray && probe.direction == kernel::Vertex{0, 0, 0}) probe.direction[one_of(random, 3)] = 1;
  return {body.body, probe.from, probe.direction, of_case};
}

const std::vector<Probe_family>& point_families()
{
  static const std::vector<Probe_family> all = numbered(probe_family::entries_of_points());
  return all;
}

const std::vector<Probe_family>& ray_families()
{
  static const std::vector<Probe_family> all =
      numbered(probe_family::entries_of_rays(), int(point_families().size()) + 1);
  return all;
}

}  // namespace tetracone::verify
