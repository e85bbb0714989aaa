#ifndef TETRACONE_KERNEL_CONTACT_CONVEX_DEPTH_H
#define TETRACONE_KERNEL_CONTACT_CONVEX_DEPTH_H

#include "tetracone/kernel/contact/corner_errors.h"
#include "tetracone/kernel/contact/corner_point.h"
#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/products.h"

#include <CGAL/gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::kernel {

/// A convex solid: its corners, and its faces and edges by numbers of corners.
struct Convex_solid {
  struct Edge {
    std::array<std::uint32_t, 2> corners;
    std::array<std::uint32_t, 2> faces;  ///< numbers of its faces, which lie in different planes
  };

  std::vector<Vertex> corners;
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< a triangle of each; all are oriented alike
  std::vector<Edge> edges;
};

/// The least translation of convex solid A that parts its interior from B's.
///
/// The translations that do not part them are the inside of the Minkowski difference B - A. Its facets' normals are
/// normals of either solid's faces, or products of an edge of each. A plane with the normal n is as far from 0 as the
/// largest n . b less the least n . a, over |n|. The plane of any other n is no nearer than the nearest facet, so more
/// directions do not change the least.
///
/// - Arcs: an edge is an arc of the Gauss map, between the normals of its two faces. The product of two edges is a
///   facet's normal, and no face's, only where their arcs cross: each edge strictly separates the other's normals.
///   Fractions tell the side where doubles cannot, since parallel faces would leave a product for each two edges.
/// - Order: directions come in the order of a lower bound of their plane's distance from 0. They end where it exceeds
///   the least. For a product n of edges, n . (b - a) / |n| is such a bound, for points of the edges.
///
/// All of this is computed in double, with bounds of the error. Fractions decide between the directions that are left,
/// from the corners that may be the furthest.
class Convex_depth {
 public:
  /// Requires interiors that share a point.
  Convex_depth(const Convex_solid& a, const Pose& pose_a, const Convex_solid& b, const Pose& pose_b)
      : body_{Body(a, pose_a), Body(b, pose_b)}
  {
    std::vector<Candidate> all;
    {
      const CGAL::Protect_FPU_rounding<true> upward;
      for (Body& body : body_) round(body);
      add_normals(all);
      add_products_of_edges(all);
      std::erase_if(all, [this](const Candidate& c) { return c.least > most_; });
    }
    std::ranges::sort(all, {}, [](const Candidate& c) { return std::pair(c.least, c.rank); });
    for (const Candidate& c : all) {
      if (c.least > most_) break;
      offer(c);
    }
  }

  /// Returns the least translation. Among equal ones, a face's normal comes first, in the order of faces.
  const Rational_point& vector() const { return vector_; }
  /// Returns the square of its length.
  const Rational& square() const { return *square_; }

 private:
  struct Body {
    Body(const Convex_solid& convex, const Pose& pose)
        : solid(&convex), map(rows_of(pose)), exact(convex.corners.size()), exact_normals(convex.faces.size())
    {}

    const Rational_point& exactly(std::uint32_t corner)
    {
      if (!exact[corner]) exact[corner] = image(solid->corners[corner], map);
      return *exact[corner];
    }
    Rational_point step(std::uint32_t from, std::uint32_t to) { return difference(exactly(to), exactly(from)); }
    Rational_point exact_edge(std::uint32_t edge)
    {
      const auto& [from, to] = solid->edges[edge].corners;
      return step(from, to);
    }
    const Rational_point& exact_normal(std::uint32_t face)
    {
      const auto& t = solid->faces[face];
      if (!exact_normals[face]) exact_normals[face] = cross(step(t[0], t[1]), step(t[0], t[2]));
      return *exact_normals[face];
    }

    const Convex_solid* solid;
    std::array<Rational, 12> map;
    std::vector<Number_point<double>> corners, normals, edges;        // rounded
    std::vector<std::optional<Rational_point>> exact, exact_normals;  // corners, normals
  };

  /// A direction: the normal of face `second` of body `first`, or the product of an edge of each. `least` is a
  /// lower bound of its plane's distance from 0.
  struct Candidate {
    bool is_normal;
    std::uint32_t first, second;
    int sign;
    double least;
    std::size_t rank;  // of equal ones, the lowest is taken
  };

  /// Rounds the corners of a body, and covers their errors.
  void round(Body& body)
  {
    std::array<Interval, 12> map;
    for (std::size_t k = 0; k < 12; ++k) map[k] = CGAL::to_interval(body.map[k]);
    for (const Vertex& v : body.solid->corners) {
      const Number_point<Interval> about = image(v, map);
      for (const Interval& x : about) is_bounded_ = is_bounded_ && x.inf() >= -0x1p200 && x.sup() <= 0x1p200;
      body.corners.push_back(errors_.rounded(about));
    }
    const auto step = [&](std::uint32_t from, std::uint32_t to) {
      const auto edge = difference(body.corners[to], body.corners[from]);
      errors_.add_edge(edge);
      return edge;
    };
    for (const auto& t : body.solid->faces) body.normals.push_back(cross(step(t[0], t[1]), step(t[0], t[2])));
    for (const Convex_solid::Edge& e : body.solid->edges) body.edges.push_back(step(e.corners[0], e.corners[1]));
  }

  /// Encloses height / |n|, the distance of a facet's plane from 0. n is a rounded normal, and height a difference of
  /// two rounded products with it.
  Interval distance(double height, const Number_point<double>& n) const
  {
    if (!is_bounded_) return Interval::largest();
    // A length is off by at most the root of 3 times a component's error, and a difference by two heights' errors.
    const double off = 2 * errors_.off_normal(), off_height = 2 * errors_.off_height();
    const Interval x = n[0], y = n[1], z = n[2], square = x * x + y * y + z * z,
                   length = CGAL::sqrt(square) + Interval(-off, off);
    if (!(length.inf() > 0)) return Interval::largest();
    return (Interval(height) * Interval(1 - few_roundings, 1 + few_roundings) + Interval(-off_height, off_height)) /
           length;
  }

  /// Returns the rounded products of a direction with the corners of a body.
  static std::vector<double> heights(const Number_point<double>& n, const Body& body)
  {
    std::vector<double> heights;
    for (const auto& x : body.corners) heights.push_back(dot(n, x));
    return heights;
  }

  void add(std::vector<Candidate>& all, const Candidate& c, const Interval& distance)
  {
    if (distance.sup() < 0) return;  // 0 is inside, so no facet's plane is behind it
    all.push_back(c);
    all.back().rank = all.size();
    all.back().least = maximum(distance.inf(), 0.0);
  }

  void add_normals(std::vector<Candidate>& all)
  {
    for (std::uint32_t body = 0; body < 2; ++body)
      for (std::uint32_t f = 0; f < body_[body].normals.size(); ++f) {
        const Number_point<double>& n = body_[body].normals[f];
        const auto of_a = std::ranges::minmax(heights(n, body_[0])), of_b = std::ranges::minmax(heights(n, body_[1]));
        for (const int sign : {1, -1}) {
          const Interval at = distance(sign > 0 ? of_b.max - of_a.min : of_a.max - of_b.min, n);
          most_ = minimum(most_, at.sup());
          add(all, {true, body, f, sign, 0, 0}, at);
        }
      }
  }

  /// Returns the sign of an edge's product with a normal.
  int side(Body& of_edge, std::uint32_t edge, Body& of_normal, std::uint32_t face) const
  {
    const double at = dot(of_edge.edges[edge], of_normal.normals[face]);
    if (std::abs(at) > off_turn_) return at > 0 ? 1 : -1;
    return CGAL::sign(dot(of_edge.exact_edge(edge), of_normal.exact_normal(face)));
  }

  void add_products_of_edges(std::vector<Candidate>& all)
  {
    if (is_bounded_) off_turn_ = errors_.off_turn();
    Body &a = body_[0], &b = body_[1];
    std::vector<int> sides(b.normals.size());
    for (std::uint32_t i = 0; i < a.edges.size(); ++i) {
      for (std::uint32_t f = 0; f < sides.size(); ++f) sides[f] = side(a, i, b, f);
      const auto& [ends, at_edge] = a.solid->edges[i];
      for (std::uint32_t j = 0; j < b.edges.size(); ++j) {
        const auto& [other_ends, at_other] = b.solid->edges[j];
        if (sides[at_other[0]] * sides[at_other[1]] >= 0) continue;
        if (side(b, j, a, at_edge[0]) * side(b, j, a, at_edge[1]) >= 0) continue;
        const auto n = cross(a.edges[i], b.edges[j]);
        const double height = dot(n, b.corners[other_ends[0]]) - dot(n, a.corners[ends[0]]);
        for (const int sign : {1, -1}) add(all, {false, i, j, sign, 0, 0}, distance(sign * height, n));
      }
    }
  }

  Rational_point direction(const Candidate& c)
  {
    const Rational_point n = c.is_normal ? body_[c.first].exact_normal(c.second)
                                         : cross(body_[0].exact_edge(c.first), body_[1].exact_edge(c.second));
    return c.sign > 0 ? n : negated(n);
  }

  /// Returns the largest product of `sign` n with the corners of a body, exactly. It skips corners whose rounded
  /// products are surely less than another's.
  Rational largest(const Rational_point& n, const std::vector<double>& heights, Body& body, int sign)
  {
    const double off = is_bounded_ ? 3 * errors_.off_height() : HUGE_VAL;
    double most = -HUGE_VAL;
    for (const double x : heights) most = maximum(most, sign * x);
    std::optional<Rational> found;
    for (std::uint32_t k = 0; k < heights.size(); ++k) {
      if (sign * heights[k] < most - off) continue;
      const Rational at = sign * dot(n, body.exactly(k));
      if (!found || at > *found) found = at;
    }
    return *found;
  }

  /// Takes the plane of a direction if it is nearer than all before.
  void offer(const Candidate& c)
  {
    std::array<std::vector<double>, 2> seen;
    {
      const CGAL::Protect_FPU_rounding<true> upward;
      Number_point<double> about =
          c.is_normal ? body_[c.first].normals[c.second] : cross(body_[0].edges[c.first], body_[1].edges[c.second]);
      for (double& x : about) x *= c.sign;
      for (std::size_t body = 0; body < 2; ++body) seen[body] = heights(about, body_[body]);
      if (distance(std::ranges::max(seen[1]) - std::ranges::min(seen[0]), about).inf() > most_) return;
    }
    const Rational_point n = direction(c);
    const Rational length = dot(n, n), at = largest(n, seen[1], body_[1], 1) + largest(n, seen[0], body_[0], -1),
                   square = at * at / length;
    if (square_ && (*square_ < square || (*square_ == square && rank_ < c.rank))) return;
    square_ = square;
    rank_ = c.rank;
    for (std::size_t k = 0; k < 3; ++k) vector_[k] = at / length * n[k];
    const CGAL::Protect_FPU_rounding<true> upward;
    most_ = minimum(most_, CGAL::sqrt(Interval(CGAL::to_interval(square))).sup());
  }

  std::array<Body, 2> body_;
  Corner_errors errors_;
  bool is_bounded_ = true;
  double off_turn_ = HUGE_VAL;  // upper bound of the error of an edge's product with a normal
  double most_ = HUGE_VAL;      // upper bound of the least distance
  std::optional<Rational> square_;
  std::size_t rank_ = 0;
  Rational_point vector_;
};

}  // namespace tetracone::kernel

#endif
