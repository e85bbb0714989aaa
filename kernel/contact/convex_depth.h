#ifndef TETRACONE_KERNEL_CONTACT_CONVEX_DEPTH_H
#define TETRACONE_KERNEL_CONTACT_CONVEX_DEPTH_H

#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/contact/shift_range.h"

#include <CGAL/gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tetracone::kernel {

/// A placed convex solid: its corners, and the corners of its triangles and edges.
struct Convex_solid {
  std::vector<Rational_point> corners;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint32_t, 2>> edges;
};

/// The least translation of convex solid A after which its interior shares no point with that of B.
///
/// The translations that do not part them are the inside of the Minkowski difference B - A. Its facets' normals are
/// those of faces of either solid, or products of an edge of each. A plane with the normal n is as far from 0 as the
/// largest n . b less the least n . a, over |n|. The plane of any other n is no nearer than the nearest facet, so more
/// directions do not change the least.
///
/// Products of edges are tried in the order of a lower bound of their planes' distance: n . (b - a) / |n| for points a
/// and b of the edges. The search ends where that exceeds the least distance so far.
class Convex_depth {
 public:
  /// Requires interiors that share a point.
  Convex_depth(const Convex_solid& a, const Convex_solid& b) : solid_{&a, &b}
  {
    for (std::size_t body = 0; body < 2; ++body)
      for (const Rational_point& x : solid_[body]->corners) {
        Number_point<Interval> about;
        for (std::size_t k = 0; k < 3; ++k) about[k] = CGAL::to_interval(x[k]);
        for (const Interval& c : about) is_bounded_ = is_bounded_ && c.inf() >= -0x1p200 && c.sup() <= 0x1p200;
        about_[body].push_back(about);
      }
    for (std::uint32_t body = 0; body < 2; ++body)
      for (std::uint32_t f = 0; f < solid_[body]->triangles.size(); ++f)
        for (const int sign : {1, -1}) offer({0, true, body, f, sign});
    std::vector<Candidate> of_edges = products_of_edges();
    std::ranges::sort(of_edges, {}, &Candidate::least);
    for (const Candidate& c : of_edges) {
      if (c.least > most_) break;
      offer(c);
    }
  }

  /// Returns the least translation.
  const Rational_point& vector() const { return vector_; }
  /// Returns the square of its length.
  const Rational& square() const { return *square_; }

 private:
  /// A direction: the normal of triangle `second` of body `first`, or the product of an edge of each. `least` is a
  /// lower bound of its plane's distance.
  struct Candidate {
    double least;
    bool is_normal;
    std::uint32_t first, second;
    int sign;
  };

  template <class N>
  static Number_point<N> direction(const Candidate& c, const std::array<const Convex_solid*, 2>& solid,
                                   const std::array<const std::vector<Number_point<N>>*, 2>& corner)
  {
    Number_point<N> n;
    if (c.is_normal) {
      const auto& t = solid[c.first]->triangles[c.second];
      const auto& x = *corner[c.first];
      n = detail::product(detail::step(x[t[0]], x[t[1]]), detail::step(x[t[0]], x[t[2]]));
    } else {
      const auto &e = solid[0]->edges[c.first], &f = solid[1]->edges[c.second];
      n = detail::product(detail::step((*corner[0])[e[0]], (*corner[0])[e[1]]),
                          detail::step((*corner[1])[f[0]], (*corner[1])[f[1]]));
    }
    if (c.sign < 0)
      for (N& x : n) x = -x;
    return n;
  }

  template <class N>
  static N width(const Number_point<N>& n, const std::array<const std::vector<Number_point<N>>*, 2>& corner)
  {
    N least = detail::inner(n, (*corner[0])[0]), largest = detail::inner(n, (*corner[1])[0]);
    for (const auto& x : *corner[0]) least = detail::least(least, detail::inner(n, x));
    for (const auto& x : *corner[1]) largest = detail::largest(largest, detail::inner(n, x));
    return N(largest - least);
  }

  std::array<const std::vector<Number_point<Interval>>*, 2> enclosed() const { return {&about_[0], &about_[1]}; }

  std::vector<Candidate> products_of_edges() const
  {
    const CGAL::Protect_FPU_rounding<true> upward;
    std::vector<Candidate> all;
    const auto &e = solid_[0]->edges, &f = solid_[1]->edges;
    for (std::uint32_t i = 0; i < e.size(); ++i)
      for (std::uint32_t j = 0; j < f.size(); ++j) {
        Candidate c{0, false, i, j, 1};
        if (!is_bounded_) {
          all.push_back(c);
          c.sign = -1;
          all.push_back(c);
          continue;
        }
        const auto n = direction<Interval>(c, solid_, enclosed());
        const Interval between = detail::inner(n, detail::step(about_[0][e[i][0]], about_[1][f[j][0]])),
                       length = CGAL::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (const int sign : {1, -1}) {
          const Interval height = sign > 0 ? between : -between;
          c.sign = sign;
          c.least = length.inf() > 0 ? (height / length).inf() : -HUGE_VAL;
          // A facet's plane is beyond 0, which is inside.
          if (height.sup() > 0 && c.least <= most_) all.push_back(c);
        }
      }
    return all;
  }

  /// Takes the plane of a direction if it is nearer than all before.
  void offer(const Candidate& c)
  {
    if (is_bounded_) {
      const CGAL::Protect_FPU_rounding<true> upward;
      const auto n = direction<Interval>(c, solid_, enclosed());
      const Interval length = CGAL::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
      if (length.inf() > 0 && (width(n, enclosed()) / length).inf() > most_) return;
    }
    const std::array<const std::vector<Rational_point>*, 2> corners = {&solid_[0]->corners, &solid_[1]->corners};
    const Rational_point n = direction<Rational>(c, solid_, corners);
    if (is_zero(n)) return;
    const Rational at = width(n, corners), square = at * at / dot(n, n);
    if (square_ && *square_ <= square) return;
    square_ = square;
    for (std::size_t k = 0; k < 3; ++k) vector_[k] = at / dot(n, n) * n[k];
    const CGAL::Protect_FPU_rounding<true> upward;
    most_ = CGAL::sqrt(Interval(CGAL::to_interval(square))).sup();
  }

  std::array<const Convex_solid*, 2> solid_;
  std::array<std::vector<Number_point<Interval>>, 2> about_;
  bool is_bounded_ = true;
  double most_ = HUGE_VAL;  // upper bound of the least distance
  std::optional<Rational> square_;
  Rational_point vector_;
};

}  // namespace tetracone::kernel

#endif
