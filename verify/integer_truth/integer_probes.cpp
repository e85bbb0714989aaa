#include "verify/integer_truth/integer_probes.h"

#include "verify/integer_truth/integer_contact.h"

#include <algorithm>
#include <array>
#include <utility>

namespace tetracone::verify::integer_truth {
namespace {

using kernel::Rational;

/// Doubles times a factor, as integers over a common power of two.
struct Scaled {
  std::vector<Integer_vector> vectors;
  Integer over = 1;
};

Scaled scaled(const std::vector<kernel::Vertex>& of, const Integer& factor)
{
  Scaled result;
  std::vector<std::array<mpq_class, 3>> exact;
  for (const kernel::Vertex& v : of) {
    exact.push_back({mpq_class(v[0]), mpq_class(v[1]), mpq_class(v[2])});
    for (const mpq_class& x : exact.back()) result.over = lcm(result.over, x.get_den());
  }
  for (const auto& v : exact) {
    Integer_vector whole;
    for (std::size_t k = 0; k < 3; ++k) whole[k] = v[k].get_num() * (result.over / v[k].get_den()) * factor;
    result.vectors.push_back(whole);
  }
  return result;
}

Rational fraction(const Integer& top, const Integer& bottom)
{
  mpq_class q(top, bottom);
  q.canonicalize();
  return Rational(q);
}

Integer_vector times(const Integer& s, const Integer_vector& v)
{
  return {Integer(s * v[0]), Integer(s * v[1]), Integer(s * v[2])};
}

/// The least t >= 0 at which x + t y is on the segment from p to q; either may be one point.
std::optional<Rational> first_on_segment(const Integer_vector& x, const Integer_vector& y, const Integer_vector& p,
                                         const Integer_vector& q)
{
  const Integer_vector along = difference(q, p), r = difference(p, x), n = cross(y, along);
  const Integer square = dot(n, n);
  if (sgn(square) > 0) {
    // t y - s along = r, s and t over `square`.
    if (sgn(dot(r, n)) != 0) return std::nullopt;
    const Integer t = dot(cross(r, along), n), s = dot(cross(r, y), n);
    if (sgn(t) < 0 || sgn(s) < 0 || s > square) return std::nullopt;
    return fraction(t, square);
  }
  if (!is_zero(cross(r, y))) return std::nullopt;
  const auto [low, high] = std::minmax({Integer(dot(r, y)), Integer(dot(difference(q, x), y))});
  if (sgn(high) < 0) return std::nullopt;
  return fraction(sgn(low) < 0 ? Integer(0) : low, dot(y, y));
}

}  // namespace

Probed_body::Probed_body(const covering::Polyhedron& polyhedron) : body_(polyhedron, {})
{
  Integer_points points = placed(polyhedron.vertices, kernel::Pose());
  denominator_ = points.denominator;
  body_ = Integer_body(polyhedron, std::move(points.points));
  for (Index f = 0; f < body_.face_count(); ++f) normals_.push_back(body_.normal(f));
}

bool Probed_body::is_on(Index f, const Integer_vector& x, const Integer& w) const
{
  if (const auto& n = normals_[f]) {
    if (sgn(dot(*n, difference(x, times(w, body_.corner(f))))) != 0) return false;
    return is_on_face(body_, f, *n, x, w);
  }
  bool is_on = false;
  body_.for_edges(f, [&](Index from, Index to) {
    const Integer_vector p = times(w, body_.point(from)), q = times(w, body_.point(to)), along = difference(q, p),
                         r = difference(x, p);
    is_on = is_on || (is_zero(cross(r, along)) && sgn(dot(r, difference(x, q))) <= 0);
  });
  return is_on;
}

int Probed_body::where(const kernel::Vertex& point) const
{
  const Scaled at = scaled({point}, denominator_);
  const Integer_vector& x = at.vectors[0];
  const Integer& w = at.over;
  int winding = 0;
  for (Index f = 0; f < body_.face_count(); ++f) {
    if (is_on(f, x, w)) return 0;
    const int turns = body_.turns(f, 2, x, w).winding;
    if (turns == 0) continue;
    const Integer_vector& n = *normals_[f];
    const int height = sgn(dot(n, difference(x, times(w, body_.corner(f))))) * sgn(n[2]);
    if (height < 0) winding += turns;
  }
  return winding != 0 ? 1 : -1;
}

std::optional<Rational> Probed_body::first_on_loops(Index f, const Ray& ray) const
{
  std::optional<Rational> first;
  body_.for_edges(f, [&](Index from, Index to) {
    const auto t = first_on_segment(ray.x, ray.y, times(ray.w, body_.point(from)), times(ray.w, body_.point(to)));
    if (t && (!first || *t < *first)) first = t;
  });
  return first;
}

std::optional<Rational> Probed_body::first_on(Index f, const Ray& ray) const
{
  const auto& n = normals_[f];
  if (!n) return first_on_loops(f, ray);
  const Integer height = dot(*n, difference(ray.x, times(ray.w, body_.corner(f)))), climb = dot(*n, ray.y);
  if (sgn(climb) == 0) {
    if (sgn(height) != 0) return std::nullopt;
    return is_on_face(body_, f, *n, ray.x, ray.w) ? std::optional(Rational(0)) : first_on_loops(f, ray);
  }
  if (sgn(height) * sgn(climb) > 0) return std::nullopt;
  // At t = - height / climb.
  const Integer t = abs(height), over = abs(climb);
  Integer_vector x;
  for (std::size_t k = 0; k < 3; ++k) x[k] = over * ray.x[k] + t * ray.y[k];
  if (!is_on_face(body_, f, *n, x, Integer(over * ray.w))) return std::nullopt;
  return fraction(t, over);
}

std::vector<std::pair<Rational, Index>> Probed_body::hits(const kernel::Vertex& from,
                                                          const kernel::Vertex& direction) const
{
  const Scaled both = scaled({from, direction}, denominator_);
  const Ray ray{both.vectors[0], both.vectors[1], both.over};
  std::vector<std::pair<Rational, Index>> met;
  for (Index f = 0; f < body_.face_count(); ++f)
    if (const auto t = first_on(f, ray)) met.emplace_back(*t, f);
  std::sort(met.begin(), met.end());
  return met;
}

}  // namespace tetracone::verify::integer_truth
