#include "verify/integer_truth/distance_to_degeneracy.h"

#include "verify/integer_truth/integer_boxes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace tetracone::verify {
namespace {

using Quadruple = std::array<int, 4>;

/// log2 of a positive number of any size.
double log2_of(const Integer& x)
{
  long exponent = 0;
  const double mantissa = mpz_get_d_2exp(&exponent, x.get_mpz_t());
  return std::log2(mantissa) + double(exponent);
}

/// log2 of an ulp of the largest coordinate x / denominator, the ulp being 2^(e-52) for 2^e <= x / denominator <
/// 2^(e+1), in units of 1 / denominator. Requires x > 0.
double log2_ulp(const Integer& x, const Integer& denominator)
{
  long e = long(mpz_sizeinbase(x.get_mpz_t(), 2)) - long(mpz_sizeinbase(denominator.get_mpz_t(), 2));
  const bool below = e >= 0 ? x < Integer(denominator << e) : Integer(x << -e) < denominator;
  if (below) --e;
  return double(e - 52) + log2_of(denominator);
}

Integer largest_coordinate(std::span<const Integer_vector> points)
{
  Integer largest = 0;
  for (const Integer_vector& point : points)
    for (const Integer& coordinate : point)
      if (mpz_cmpabs(coordinate.get_mpz_t(), largest.get_mpz_t()) > 0) largest = abs(coordinate);
  return largest;
}

/// The least so far.
class Least {
 public:
  explicit Least(double log2_ulp) : log2_ulp_(log2_ulp) {}

  /// The determinant of three vectors, whose value divided by the length of n is a distance. Its sign.
  int add(const Integer_vector& x, const Integer_vector& y, const Integer_vector& z, const Integer_vector& n)
  {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Integer determinant = 0, permanent = 0, plus, minus;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      plus = y[j] * z[k];
      minus = y[k] * z[j];
      determinant += x[i] * (plus - minus);
      permanent += abs(x[i]) * (abs(plus) + abs(minus));
    }
    const int sign = sgn(determinant);
    if (sign == 0) {
      least_ = {-infinite, -infinite};
    } else {
      const double value = log2_of(abs(determinant));
      least_.log2_rho = std::min(least_.log2_rho, value - log2_of(permanent));
      least_.log2_ulps = std::min(least_.log2_ulps, value - log2_of(dot(n, n)) / 2 - log2_ulp_);
    }
    return sign;
  }

  /// The vertex x against the plane of a, b, c.
  int add_plane(const Integer_vector& a, const Integer_vector& b, const Integer_vector& c, const Integer_vector& x)
  {
    return add(difference(a, x), difference(b, x), difference(c, x), cross(difference(b, a), difference(c, a)));
  }

  /// The line ab against the line cd.
  int add_lines(const Integer_vector& a, const Integer_vector& b, const Integer_vector& c, const Integer_vector& d)
  {
    const Integer_vector along = difference(b, a);
    return add(along, difference(c, a), difference(d, a), cross(along, difference(d, c)));
  }

  bool is_degenerate() const { return least_.log2_rho == -std::numeric_limits<double>::infinity(); }
  const Distance& value() const { return least_; }

 private:
  double log2_ulp_;
  Distance least_ = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
};

// The points of a predicate's case by number.
constexpr int v0 = 0, v1 = 1, v2 = 2, v3 = 3, p = 4, q = 5, r = 6;

/// A plane through three points and a vertex.
std::vector<Quadruple> planes_of(Predicate predicate)
{
  switch (predicate) {
    case Predicate::orientation: return {{v1, v2, v3, p}};
    case Predicate::tetra_cone: return {{v1, v2, v3, v0}, {v0, v2, v3, p}, {v0, v3, v1, p}, {v0, v1, v2, p}};
    case Predicate::tetrahedron:
      return {{v1, v2, v3, v0}, {v0, v2, v3, p}, {v0, v3, v1, p}, {v0, v1, v2, p}, {v1, v2, v3, p}};
    case Predicate::segment_triangle: return {{v1, v2, v3, p}, {v1, v2, v3, q}};
    case Predicate::solid:
      return {{v0, v2, v3, p}, {v0, v3, v1, p}, {v0, v1, v2, p}, {v1, v2, v3, p}, {v0, v2, v3, q},
              {v0, v3, v1, q}, {v0, v1, v2, q}, {v1, v2, v3, q}, {q, v0, v1, p},  {q, v0, v2, p},
              {q, v0, v3, p},  {q, v1, v2, p},  {q, v2, v3, p},  {q, v3, v1, p}};
    case Predicate::classification:
      return {{v1, v2, v3, v0}, {p, q, r, v0},   {v0, v2, v3, p}, {v0, v2, v3, q}, {v0, v2, v3, r},
              {v0, v3, v1, p},  {v0, v3, v1, q}, {v0, v3, v1, r}, {v0, v1, v2, p}, {v0, v1, v2, q},
              {v0, v1, v2, r},  {v0, p, q, v1},  {v0, p, q, v2},  {v0, p, q, v3},  {v0, q, r, v1},
              {v0, q, r, v2},   {v0, q, r, v3},  {v0, r, p, v1},  {v0, r, p, v2},  {v0, r, p, v3}};
    case Predicate::triangle_triangle:
      return {{v1, v2, v3, p}, {v1, v2, v3, q}, {v1, v2, v3, r}, {p, q, r, v1}, {p, q, r, v2}, {p, q, r, v3}};
  }
  return {};
}

/// Two lines, each through two points.
std::vector<Quadruple> lines_of(Predicate predicate)
{
  switch (predicate) {
    case Predicate::segment_triangle: return {{p, q, v1, v2}, {p, q, v2, v3}, {p, q, v3, v1}};
    case Predicate::triangle_triangle:
      return {{p, q, v1, v2}, {p, q, v2, v3}, {p, q, v3, v1}, {q, r, v1, v2}, {q, r, v2, v3},
              {q, r, v3, v1}, {r, p, v1, v2}, {r, p, v2, v3}, {r, p, v3, v1}};
    default: return {};
  }
}

/// Three corners that span the face's plane; the first corner thrice where they are all on one line.
std::array<Index, 3> plane_basis(const Integer_body& body, Index f)
{
  const std::vector<Index> corners = body.corners(f);
  const Index first = corners[0];
  Integer_vector along;
  Index second = first;
  for (const Index v : corners) {
    const Integer_vector d = difference(body.point(v), body.point(first));
    if (is_zero(along)) {
      along = d;
      second = v;
    } else if (!is_zero(cross(along, d))) {
      return {first, second, v};
    }
  }
  return {first, first, first};
}

/// The edges of the one against the faces of the other.
void add_pairs(const Integer_body& with_edges, const std::vector<Rank_box>& edge_boxes, const Integer_body& with_faces,
               const std::vector<Rank_box>& face_boxes, Least& least)
{
  int pairs = 0;
  std::vector<std::optional<int>> sides(with_edges.vertex_count());
  std::vector<Index> touched;
  Index last = with_faces.face_count();
  std::array<Index, 3> plane{};
  const auto side = [&](Index v) {
    if (!sides[v]) {
      const auto corner = [&](int i) -> const Integer_vector& { return with_faces.point(plane[i]); };
      sides[v] = least.add_plane(corner(0), corner(1), corner(2), with_edges.point(v));
      touched.push_back(v);
    }
    return *sides[v];
  };
  for (const auto& [f, e] : meeting_boxes(face_boxes, edge_boxes)) {
    if (++pairs > 2000 || least.is_degenerate()) return;
    if (f != last) {
      for (const Index v : touched) sides[v].reset();
      touched.clear();
      plane = plane_basis(with_faces, f);
      last = f;
    }
    const auto [from, to] = with_edges.edges()[e];
    if (side(from) * side(to) > 0) continue;
    with_faces.for_edges(f, [&, from = from, to = to](Index a, Index b) {
      least.add_lines(with_edges.point(from), with_edges.point(to), with_faces.point(a), with_faces.point(b));
    });
  }
}

}  // namespace

Distance distance(Predicate predicate, const Predicate_case& c)
{
  Integer_points of_a = placed(c.v, c.pose_a), of_b = placed(std::array{c.p, c.q, c.r}, c.pose_b);
  bring_together(of_a, of_b);
  std::vector<Integer_vector> points = std::move(of_a.points);
  points.insert(points.end(), of_b.points.begin(), of_b.points.end());

  const std::vector<Quadruple> planes = planes_of(predicate), lines = lines_of(predicate);
  std::vector<Integer_vector> named;
  for (const auto* all : {&planes, &lines})
    for (const Quadruple& quadruple : *all)
      for (const int k : quadruple) named.push_back(points[k]);
  const Integer largest = largest_coordinate(named);
  Least least(sgn(largest) == 0 ? 0 : log2_ulp(largest, of_b.denominator));
  for (const auto& [a, b, d, x] : planes) least.add_plane(points[a], points[b], points[d], points[x]);
  for (const auto& [a, b, d, e] : lines) least.add_lines(points[a], points[b], points[d], points[e]);
  return least.value();
}

Distance distance(const Object_case& c)
{
  Integer_points of_a = placed(c.a->vertices, c.pose_a), of_b = placed(c.b->vertices, c.pose_b);
  bring_together(of_a, of_b);
  const Integer largest = std::max(largest_coordinate(of_a.points), largest_coordinate(of_b.points));
  const Integer_body a(*c.a, std::move(of_a.points)), b(*c.b, std::move(of_b.points));

  const auto [boxes_a, boxes_b] = grown_boxes(a, b, 20);
  Least least(sgn(largest) == 0 ? 0 : log2_ulp(largest, of_b.denominator));
  add_pairs(a, boxes_a.edges, b, boxes_b.faces, least);
  add_pairs(b, boxes_b.edges, a, boxes_a.faces, least);
  return least.value();
}

}  // namespace tetracone::verify
