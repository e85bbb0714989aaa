#ifndef TETRACONE_KERNEL_CONTACT_CONVEX_HULL_H
#define TETRACONE_KERNEL_CONTACT_CONVEX_HULL_H

#include "tetracone/kernel/contact/convex_depth.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/predicate/adaptive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace tetracone::kernel {

/// The convex hull of points, in triangles. Exact signs decide which side of a triangle a point is on, so the hull is
/// exactly that of the points, and exactly convex.
///
/// Triangles from a point to their border take the place of all that it is outside of. The farthest point comes first,
/// as doubles tell. Points in a triangle's plane are not outside of it. Source: Barber, Dobkin and Huhdanpaa, The
/// Quickhull algorithm for convex hulls, ACM Transactions on Mathematical Software 22 (1996).
class Convex_hull {
 public:
  /// Returns the hull; nothing where the points lie in a plane, or nearly do.
  static std::optional<Convex_hull> of(std::span<const Vertex> points)
  {
    Convex_hull hull(points);
    if (!hull.begin()) return std::nullopt;
    while (!hull.open_.empty()) {
      const std::uint32_t t = hull.open_.back();
      hull.open_.pop_back();
      if (hull.all_[t].is_kept && !hull.all_[t].outside.empty()) hull.add_farthest_of(t);
    }
    std::erase_if(hull.all_, [](const Triangle& t) { return !t.is_kept; });
    return hull;
  }

  /// Returns the corners of the triangles, numbers of points. They are anticlockwise, as seen from outside.
  std::vector<std::array<std::uint32_t, 3>> triangles() const
  {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const Triangle& t : all_) triangles.push_back(t.corner);
    return triangles;
  }

 private:
  using K = Adaptive;

  struct Triangle {
    std::array<std::uint32_t, 3> corner;
    std::array<std::uint32_t, 3> beyond{};  // the triangle at the edge from corner k to the next
    std::vector<std::uint32_t> outside;     // points that no other triangle has
    bool is_kept = true;
  };
  struct Edge {
    std::uint32_t from, to, beyond;
  };

  explicit Convex_hull(std::span<const Vertex> points) : points_(points), starts_at_(points.size())
  {
    for (const Vertex& v : points) exact_.push_back(K::unmoved(v));
  }

  CGAL::Sign side(const std::array<std::uint32_t, 3>& t, std::uint32_t p) const
  {
    return K::volume_sign(exact_[t[0]], exact_[t[1]], exact_[t[2]], exact_[p]);
  }

  /// Returns how far p is outside of a triangle, rounded, times twice the triangle's area.
  double height(const std::array<std::uint32_t, 3>& t, std::uint32_t p) const
  {
    const Vertex &a = points_[t[0]], &b = points_[t[1]], &c = points_[t[2]];
    return dot(cross(difference(b, a), difference(c, a)), difference(points_[p], a));
  }

  /// Makes a first tetrahedron. False where none is found whose volume is not 0.
  bool begin()
  {
    const auto count = std::uint32_t(points_.size());
    if (count < 4) return false;
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0u);
    const auto most = [&](const auto& size) { return *std::ranges::max_element(all, {}, size); };
    const std::uint32_t a = most([&](std::uint32_t p) { return points_[p]; });
    const auto from_a = [&](std::uint32_t p) { return difference(points_[p], points_[a]); };
    const std::uint32_t b = most([&](std::uint32_t p) { return dot(from_a(p), from_a(p)); });
    const std::uint32_t c = most([&](std::uint32_t p) {
      const Vertex normal = cross(from_a(b), from_a(p));
      return dot(normal, normal);
    });
    const std::uint32_t d = most([&](std::uint32_t p) { return std::abs(height({a, b, c}, p)); });
    std::array<std::uint32_t, 4> v = {a, b, c, d};
    const CGAL::Sign sign = side({a, b, c}, d);
    if (sign == CGAL::ZERO) return false;
    if (sign == CGAL::POSITIVE) std::swap(v[0], v[1]);
    // The corners of triangle k are all but corner k; it is beyond the edges that the others share with it.
    all_ = {{{v[1], v[3], v[2]}, {2, 1, 3}, {}},
            {{v[0], v[2], v[3]}, {3, 0, 2}, {}},
            {{v[0], v[3], v[1]}, {1, 0, 3}, {}},
            {{v[0], v[1], v[2]}, {2, 0, 1}, {}}};
    give(all, 0);
    return true;
  }

  /// Gives each point that is outside of a triangle, from `first` on, to one of these.
  void give(const std::vector<std::uint32_t>& points, std::uint32_t first)
  {
    for (const std::uint32_t p : points)
      for (std::uint32_t t = first; t < all_.size(); ++t)
        if (side(all_[t].corner, p) == CGAL::POSITIVE) {
          all_[t].outside.push_back(p);
          break;
        }
    for (std::uint32_t t = first; t < all_.size(); ++t)
      if (!all_[t].outside.empty()) open_.push_back(t);
  }

  void add_farthest_of(std::uint32_t t)
  {
    const std::uint32_t p =
        *std::ranges::max_element(all_[t].outside, {}, [&](std::uint32_t q) { return height(all_[t].corner, q); });
    // The triangles that p is outside of are neighbours, since the hull is convex. Their border is one loop of edges.
    std::vector<std::uint32_t> seen = {t}, points;
    std::vector<Edge> border;
    all_[t].is_kept = false;
    for (std::size_t n = 0; n < seen.size(); ++n) {
      Triangle& left = all_[seen[n]];
      std::ranges::copy_if(left.outside, std::back_inserter(points), [p](std::uint32_t q) { return q != p; });
      left.outside = {};
      for (std::size_t k = 0; k < 3; ++k) {
        Triangle& next = all_[left.beyond[k]];
        if (!next.is_kept) continue;
        if (side(next.corner, p) == CGAL::POSITIVE) {
          next.is_kept = false;
          seen.push_back(left.beyond[k]);
        }
      }
    }
    for (const std::uint32_t s : seen)
      for (std::size_t k = 0; k < 3; ++k)
        if (all_[all_[s].beyond[k]].is_kept)
          border.push_back({all_[s].corner[k], all_[s].corner[(k + 1) % 3], all_[s].beyond[k]});
    const auto first = std::uint32_t(all_.size());
    for (const Edge& e : border) {
      starts_at_[e.from] = std::uint32_t(all_.size());
      auto& beyond = all_[e.beyond];
      for (std::size_t k = 0; k < 3; ++k)
        if (beyond.corner[k] == e.to && beyond.corner[(k + 1) % 3] == e.from)
          beyond.beyond[k] = std::uint32_t(all_.size());
      all_.push_back({{e.from, e.to, p}, {e.beyond, 0, 0}, {}});
    }
    for (std::uint32_t n = first; n < all_.size(); ++n) {
      const std::uint32_t next = starts_at_[all_[n].corner[1]];
      all_[n].beyond[1] = next;
      all_[next].beyond[2] = n;
    }
    give(points, first);
  }

  std::span<const Vertex> points_;
  std::vector<K::Point_3> exact_;
  std::vector<Triangle> all_;
  std::vector<std::uint32_t> open_;       // triangles that may have points outside
  std::vector<std::uint32_t> starts_at_;  // of a border's corner: the new triangle at the edge from there
};

}  // namespace tetracone::kernel

#endif
