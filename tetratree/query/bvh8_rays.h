#ifndef TETRACONE_TETRATREE_QUERY_BVH8_RAYS_H
#define TETRACONE_TETRATREE_QUERY_BVH8_RAYS_H

#include "tetracone/kernel/bound/obb8_ray.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/predicate/ray_face.h"
#include "tetracone/kernel/predicate/ray_triangle.h"
#include "tetracone/tetratree/fast/bvh8.h"
#include "tetracone/tetratree/ray_hit.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// The faces that a ray meets, and where, exactly, through a `Bvh8`.
///
/// The descent takes nearer boxes first. A filter that encloses t decides a triangle. Integers decide uncertain
/// triangles and faces that are not triangles, and rationals faces on one line. Exact times also decide where two
/// enclosures overlap, and where an enclosure does not determine the double nearest to t. One object serves one thread.
/// Requires sound floating point (`kernel::require_sound_floating_point`).
class Bvh8_rays {
 public:
  /// The tree must outlive this object.
  explicit Bvh8_rays(const Bvh8& tree) : tree_(&tree) { open_.reserve(256); }

  /// Returns `first` of each ray. Up to 16 rays take turns, a node each, so that memory accesses of some overlap with
  /// computations of others. Requires as `first`.
  static std::vector<std::optional<Ray_hit>> first_of_each(const Bvh8& tree, std::span<const Ray> rays)
  {
    constexpr std::size_t at_once = 16;
    std::vector<Bvh8_rays> casters(kernel::minimum(at_once, rays.size()), Bvh8_rays(tree));
    std::vector<std::optional<Ray_hit>> hits;
    hits.reserve(rays.size());
    while (hits.size() < rays.size()) {
      const auto some = rays.subspan(hits.size(), kernel::minimum(at_once, rays.size() - hits.size()));
      for (std::size_t k = 0; k < some.size(); ++k) casters[k].begin(some[k], true, no_end);
      for (unsigned under_way = (1u << some.size()) - 1; under_way != 0;)
        for_bits(under_way, [&](int k) {
          if (!casters[std::size_t(k)].advance()) under_way &= ~(1u << k);
        });
      for (std::size_t k = 0; k < some.size(); ++k) hits.push_back(casters[k].first_met());
    }
    return hits;
  }

  /// The end of a ray without one.
  static constexpr double no_end = std::numeric_limits<double>::infinity();

  /// Returns the hit of least t; of several faces there, the one of least number. Nothing if no face is met up to
  /// `end`. Requires finite numbers and a direction that is not 0.
  std::optional<Ray_hit> first(const Ray& ray, double end = no_end)
  {
    begin(ray, true, end);
    while (advance()) continue;
    auto hit = first_met();
    if (hit && !is_before_end(met_.front())) hit.reset();
    return hit;
  }

  /// True when some face is met at a t of at most `end`. It stops at the first that it finds. Requires as `first`.
  bool any(const Ray& ray, double end = no_end)
  {
    begin(ray, true, end);
    bool is_under_way = true;
    for (std::size_t decided = 0; is_under_way;) {
      is_under_way = advance();
      for (; decided < met_.size(); ++decided)
        if (is_before_end(met_[decided])) return true;
    }
    return false;
  }

  /// Returns every face that is met at a t of at most `end`, by t, then by number. Requires as `first`.
  std::vector<Ray_hit> all(const Ray& ray, double end = no_end)
  {
    begin(ray, false, end);
    while (advance()) continue;
    if (end < no_end) std::erase_if(met_, [this](Met& m) { return !is_before_end(m); });
    std::sort(met_.begin(), met_.end(), [](const Met& x, const Met& y) { return x.low < y.low; });
    for (std::size_t begin = 0, past; begin < met_.size(); begin = past) {
      double high = met_[begin].high;
      for (past = begin + 1; past < met_.size() && met_[past].low <= high; ++past)
        high = kernel::maximum(high, met_[past].high);
      if (past == begin + 1) continue;
      for (std::size_t k = begin; k < past; ++k) make_exact(met_[k]);
      std::sort(met_.begin() + std::ptrdiff_t(begin), met_.begin() + std::ptrdiff_t(past), is_before);
    }
    std::vector<Ray_hit> hits;
    for (Met& m : met_) hits.push_back(hit(m));
    return hits;
  }

 private:
  using Rational = kernel::Rational;

  /// A face that the ray meets; t refers to the scaled direction.
  struct Met {
    const Element* element;
    double low, high;
    std::optional<Rational> t;
  };

  struct Open {
    float nearest;
    Index node;
  };

  /// A face's corners in rationals, made when rationals decide the face.
  class Exact_face {
   public:
    using Point = kernel::Point<kernel::Rational_kernel>;

    Exact_face(const covering::Model<kernel::Adaptive>& model, Index face)
    {
      const auto point = [&](Index v) { return kernel::point<kernel::Rational_kernel>(model.vertices()[v]); };
      for (const Index v : model.covering().from(face)) from_.push_back(point(v));
      for (const Index v : model.covering().to(face)) to_.push_back(point(v));
      if (const auto& basis = model.covering().plane_basis(face))
        for (const Index v : *basis) basis_.push_back(point(v));
    }
    std::size_t edge_count() const { return from_.size(); }
    const Point& from(std::size_t k) const { return from_[k]; }
    const Point& to(std::size_t k) const { return to_[k]; }
    const Point& origin() const { return from_[0]; }
    bool is_degenerate() const { return basis_.empty(); }
    const Point& plane_basis(int k) const { return basis_[std::size_t(k)]; }

   private:
    std::vector<Point> from_, to_, basis_;
  };

  static bool is_before(const Met& x, const Met& y)
  {
    return *x.t != *y.t ? *x.t < *y.t : x.element->face < y.element->face;
  }

  const covering::Vertex& corner(const Element& element, int k) const
  {
    return tree_->model().vertices()[element.corner[std::size_t(k)]];
  }

  /// Begins a ray. If it is local, boxes beyond `end` or, with `first_alone`, beyond the first hit are not opened.
  void begin(const Ray& ray, bool first_alone, double end)
  {
    ray_ = ray;
    end_ = end;
    filter_.emplace(ray.origin, ray.direction);
    exact_ray_.reset();
    local_.reset();
    met_.clear();
    decided_.clear();
    open_.clear();
    leaves_ = 0;
    limit_ = std::numeric_limits<double>::infinity();
    farthest_ = kernel::Local_ray::length;
    first_alone_ = first_alone;
    if (tree_->empty()) return;
    if (kernel::Local_ray::may_be_local(tree_->scale(), ray.origin)) {
      local_ = kernel::Local_ray::of(tree_->scale(), ray.origin, filter_->direction());
      if (!local_) return;
      const auto& d = filter_->direction();
      per_t_ = std::sqrt(kernel::dot(d, d)) / tree_->scale().unit;
      // The quotient of rounded numbers is as exact as an enclosure's end.
      if (end < no_end) farthest_ = kernel::minimum(farthest_, scaled_end().second * per_t_ - local_->skipped);
    }
    open_.push_back({0, 0});
  }

  /// Opens the nearest node. False if none is left; then all leaves are decided.
  bool advance()
  {
    decide_leaves();
    while (!open_.empty()) {
      const Open top = open_.back();
      open_.pop_back();
      if (local_ && is_beyond(top.nearest)) continue;
      open_node(top.node);
      return true;
    }
    return false;
  }

  /// True when what begins at s, in local units, is beyond the first face. The margin covers the errors of entries and
  /// times, each at most 2^-16. It is counted by hand (verify/proofs/other_constants.h).
  bool is_beyond(float s) const { return s > farthest_ + 0x1p-14; }

  /// Opens a node. All its lanes are met if there is no local ray.
  void open_node(Index n)
  {
    const Bvh8_node& node = tree_->node(n);
    unsigned met = (1u << node.boxes.lane_count) - 1;
    if (local_) met = kernel::ray_lanes(node.boxes, *local_, farthest_, nearest_);
    node_ = n;
    leaves_ = met & node.boxes.marked;
    for_bits(leaves_, [&](int lane) { __builtin_prefetch(&tree_->element({n, lane})); });
    const std::size_t before = open_.size();
    for_bits(met & ~leaves_, [&](int lane) {
      const Index child = tree_->child({n, lane});
      open_.push_back({nearest_[std::size_t(lane)], child});
      // The nearest is last, to be opened first.
      for (std::size_t k = open_.size() - 1; k > before && open_[k - 1].nearest < open_[k].nearest; --k)
        std::swap(open_[k - 1], open_[k]);
      tree_->prefetch(child);
    });
    for_bits(leaves_, [&](int lane) {
      const Element& element = tree_->element({n, lane});
      if (!element.is_whole_face())
        for (const Index v : element.corner) __builtin_prefetch(&tree_->model().vertices()[v]);
    });
  }

  /// Decides the leaves of the node that was opened last.
  void decide_leaves()
  {
    for_bits(leaves_, [&](int lane) {
      if (local_ && is_beyond(nearest_[std::size_t(lane)])) return;
      const Box_id leaf(node_, lane);
      for (Index k = 0; k < tree_->leaf_count(leaf); ++k) decide(tree_->element(leaf, k));
    });
    leaves_ = 0;
  }

  template <class What>
  static void for_bits(unsigned bits, const What& what)
  {
    for (; bits != 0; bits &= bits - 1) what(std::countr_zero(bits));
  }

  void decide(const Element& element)
  {
    if (!element.is_whole_face() && tree_->scale().is_in_range()) {
      const auto decision = (*filter_)(corner(element, 0), corner(element, 1), corner(element, 2));
      if (decision.meets == kernel::Ray_triangle::Meets::no) return;
      if (decision.meets == kernel::Ray_triangle::Meets::yes) {
        for (const Met& m : met_)
          if (m.element->face == element.face) return;
        add({&element, decision.low, decision.high, std::nullopt});
        return;
      }
    }
    // The whole face is decided once.
    if (std::find(decided_.begin(), decided_.end(), element.face) != decided_.end()) return;
    decided_.push_back(element.face);
    for (const Met& m : met_)
      if (m.element->face == element.face) return;
    if (auto t = exact_t(element.face)) {
      const double nearest = kernel::nearest_double(*t);
      add({&element, std::nextafter(nearest, -HUGE_VAL), std::nextafter(nearest, HUGE_VAL), std::move(t)});
    }
  }

  /// Adds a hit, and lowers the limits by it.
  void add(Met met)
  {
    limit_ = kernel::minimum(limit_, met.high);
    if (first_alone_ && local_) farthest_ = kernel::minimum(farthest_, limit_ * per_t_ - local_->skipped);
    met_.push_back(std::move(met));
  }

  /// Returns the exact t of the scaled direction, or nothing.
  std::optional<Rational> exact_t(Index face)
  {
    const auto& covering = tree_->model().covering();
    if (const auto basis = covering.plane_basis(face)) return exact_t(covering.from(face), covering.to(face), *basis);
    if (!exact_ray_) {
      exact_ray_.emplace();
      for (int k = 0; k < 3; ++k) {
        exact_ray_->origin[k] = ray_.origin[k];
        exact_ray_->direction[k] = kernel::times_power(Rational(ray_.direction[k]), -filter_->exponent());
      }
    }
    return kernel::ray_face(*exact_ray_, Exact_face(tree_->model(), face));
  }

  /// Returns `exact_t` of a face with a plane. It has edges from `from[k]` to `to[k]`.
  std::optional<Rational> exact_t(std::span<const Index> from, std::span<const Index> to,
                                  const std::array<Index, 3>& basis) const
  {
    const auto& vertices = tree_->model().vertices();
    const auto bits_of = [](int bits, const kernel::Vertex& x) {
      for (const double coordinate : x) bits = kernel::maximum(bits, kernel::fraction_bits(coordinate));
      return bits;
    };
    int bits = bits_of(0, ray_.origin);
    for (const Index v : from) bits = bits_of(bits, vertices[v]);
    const auto whole = [](const kernel::Vertex& x, int by) {
      return kernel::Integer_vector{kernel::integer(x[0], by), kernel::integer(x[1], by), kernel::integer(x[2], by)};
    };
    const kernel::Integer_vector origin = whole(ray_.origin, bits);
    const auto point = [&](Index v) { return kernel::difference(whole(vertices[v], bits), origin); };
    kernel::Integer_face face;
    for (const Index v : from) face.from.push_back(point(v));
    for (const Index v : to) face.to.push_back(point(v));
    for (std::size_t k = 0; k < 3; ++k) face.basis[k] = point(basis[k]);
    const int of_direction = bits_of(0, ray_.direction);
    auto t = kernel::ray_face(whole(ray_.direction, of_direction), face);
    if (t) *t = kernel::times_power(*t, long(of_direction) + filter_->exponent() - bits);
    return t;
  }

  /// Returns the end of the scaled ray, rounded down and up.
  std::pair<double, double> scaled_end() const
  {
    const double end = std::ldexp(end_, filter_->exponent());
    return {std::nextafter(end, -HUGE_VAL), std::nextafter(end, HUGE_VAL)};
  }

  /// True when a hit's t is at most `end_`, exactly.
  bool is_before_end(Met& met)
  {
    if (end_ == no_end) return true;
    const auto [low, high] = scaled_end();
    if (met.high <= low) return true;
    if (met.low > high) return false;
    make_exact(met);
    return *met.t <= kernel::times_power(Rational(end_), filter_->exponent());
  }

  /// Returns the first hit of a ray for which `advance` has returned false.
  std::optional<Ray_hit> first_met()
  {
    if (met_.empty()) return std::nullopt;
    if (met_.size() > 1) std::erase_if(met_, [&](const Met& m) { return m.low > limit_; });
    if (met_.size() > 1) {
      for (Met& m : met_) make_exact(m);
      std::swap(met_.front(), *std::min_element(met_.begin(), met_.end(), is_before));
    }
    return hit(met_.front());
  }

  void make_exact(Met& met)
  {
    if (!met.t) met.t = exact_t(met.element->face);
  }

  Ray_hit hit(Met& met)
  {
    if (!met.t)
      if (const auto t = filter_->rounded(corner(*met.element, 0), corner(*met.element, 1), corner(*met.element, 2)))
        return {met.element->face, *t};
    make_exact(met);
    return {met.element->face, kernel::nearest_double(kernel::times_power(*met.t, -filter_->exponent()))};
  }

  const Bvh8* tree_;
  Ray ray_{};
  double end_ = no_end;
  std::optional<kernel::Ray_triangle> filter_;
  std::optional<kernel::Rational_ray> exact_ray_;
  std::optional<kernel::Local_ray> local_;
  double per_t_ = 0;     // from t to length in local units
  double limit_ = 0;     // upper bound of the first face's t
  double farthest_ = 0;  // in local units: the ray need not be followed farther
  bool first_alone_ = false;
  std::vector<Met> met_;
  std::vector<Index> decided_;  // faces decided exactly
  std::vector<Open> open_;
  Index node_ = 0;                  // the node that was opened last
  unsigned leaves_ = 0;             // its leaves that are met and not yet decided
  kernel::Lane_entries nearest_{};  // where the ray enters its lanes
};

}  // namespace tetracone::tetratree

#endif
