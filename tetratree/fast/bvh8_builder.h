#ifndef TETRACONE_TETRATREE_FAST_BVH8_BUILDER_H
#define TETRACONE_TETRATREE_FAST_BVH8_BUILDER_H

#include "tetracone/kernel/bound/oriented_box.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/tetratree/fast/bvh8_elements.h"
#include "tetracone/tetratree/fast/bvh8_node.h"
#include "tetracone/tetratree/fast/bvh8_options.h"
#include "tetracone/tetratree/fast/cone_order.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// Makes the nodes of a `Bvh8`, in any order. Not thread-safe: `Bvh8` calls it under a lock.
class Bvh8_builder {
 public:
  /// `elements` must outlive the builder. `order` becomes that of the leaves: a node's making changes its own range of
  /// it alone. `leaf_ends`, where leaves may hold several elements: by where in the order a leaf begins, where it ends.
  Bvh8_builder(const Bvh8_elements& elements, const Bvh8_options& options, std::vector<Index>& order,
               std::vector<Index>& leaf_ends)
      : elements_(elements), options_(options), order_(order), leaf_ends_(leaf_ends)
  {
    assert(options_.leaf_size >= 1 && options_.parts >= 2 && options_.parts <= kernel::lanes);
    assert(options_.cuts != Cuts::tetra_cones || options_.parts == kernel::lanes);
    if (options_.leaf_size > 1) leaf_ends_.resize(elements_.count());
    order_.resize(elements_.count());
    std::iota(order_.begin(), order_.end(), Index(0));
    for (Index e = 0; e < elements_.count(); ++e) centroids_.push_back(centroid(elements_[e]));
    stamps_.resize(elements_.model().vertices().size(), 0);
  }

  /// One lane that holds everything. Requires an element.
  Bvh8_node root() { return node_of({part(0, elements_.count())}); }

  /// The node of elements first .. last of the order, of which there are more than a leaf holds.
  Bvh8_node node(Index first, Index last)
  {
    std::vector<Part> parts = parts_in_cones(first, last);
    const std::size_t most = parts.size() > 1 ? parts.size() : options_.parts;  // cones are not cut further
    while (parts.size() < most) {
      const auto largest =
          std::max_element(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.size < b.size; });
      if (is_leaf(*largest)) break;
      const Part whole = *largest;
      const Index middle = split(whole);
      *largest = part(whole.first, middle);
      parts.insert(largest + 1, part(middle, whole.last));
    }
    return node_of(parts);
  }

  const Cut_counts& cuts() const { return cuts_; }

  std::size_t bytes() const
  {
    return centroids_.capacity() * sizeof(centroids_[0]) + stamps_.capacity() * sizeof(stamps_[0]);
  }

 private:
  using Vector = kernel::Vector;

  template <class What>
  void for_corners(const Element& element, const What& what) const
  {
    elements_.for_vertices(element, [&](Index v) { what(elements_.local(v)); });
  }

  std::array<float, 3> centroid(const Element& element) const
  {
    Vector sum = Vector::Zero();
    int count = 0;
    for_corners(element, [&](const Vector& p) {
      sum += p;
      ++count;
    });
    sum /= count;
    return {float(sum[0]), float(sum[1]), float(sum[2])};
  }
  static Vector vector(const std::array<float, 3>& c) { return {c[0], c[1], c[2]}; }
  Vector centroid_of(Index position) const { return vector(centroids_[order_[position]]); }

  /// Elements first .. last of the order, and how far their centroids spread: along the columns of `axes`, the last one
  /// the most.
  struct Part {
    Index first, last;
    double size;
    Vector mean;
    kernel::Matrix axes;
  };

  Part part(Index first, Index last)
  {
    gathered_.clear();
    for (Index k = first; k < last; ++k) gathered_.push_back(centroid_of(k));
    const kernel::Spread spread(gathered_);
    return {first, last, last - first > options_.leaf_size ? kernel::maximum(spread.size(), 1e-300) : 0, spread.mean,
            spread.principal_axes()};
  }
  bool is_leaf(const Part& part) const { return part.last - part.first <= options_.leaf_size; }

  /// With `Cuts::tetra_cones`: the parts that cones hold; one part where these are not asked for, or do not part it.
  std::vector<Part> parts_in_cones(Index first, Index last)
  {
    if (options_.cuts != Cuts::tetra_cones) return {part(first, last)};
    const auto begins = order_by_cones(std::span(order_).subspan(first, last - first),
                                       [this](Index e) { return vector(centroids_[e]); });
    std::vector<Part> parts;
    for (std::size_t k = 0; k < begins.size(); ++k)
      parts.push_back(part(first + Index(begins[k]), k + 1 < begins.size() ? first + Index(begins[k + 1]) : last));
    return parts;
  }

  /// Planes, one through every point: all across one direction or, of a cone, all through the origin and a line there.
  struct Pencil {
    Vector across;
    std::optional<Vector> along;  // of a cone: into it

    /// Where the point's plane is among them. Of a cone, for points before the origin.
    float place(const Vector& p) const { return float(along ? across.dot(p) / along->dot(p) : across.dot(p)); }
  };

  struct Cut {
    Pencil pencil;
    float place = 0;
    double cost = std::numeric_limits<double>::infinity();
  };

  /// An element as cuts see it: its centroid, and its corners' bounds along the part's axes.
  struct Sample {
    Vector centroid, low, high;
  };

  /// Cuts the part in two, and returns where in the order: the boxes of both are small for what they hold. In the
  /// middle where all elements are in one place.
  Index split(const Part& part)
  {
    const Index count = part.last - part.first, middle = part.first + count / 2;
    if (count == 2) return middle;
    samples_.clear();
    const Index step = (count + most_samples - 1) / most_samples;
    for (Index k = part.first; k < part.last; k += step) samples_.push_back(sample(order_[k], part.axes));
    Cut best = best_cut({part.axes.col(2), {}});
    ++cuts_.all;
    if (const auto cones = tries_cones(count) ? cones_about(part) : std::nullopt) {
      ++cuts_.tried_cones;
      const Cut into_cones = best_cut(*cones);
      if (options_.cuts == Cuts::through_origin || into_cones.cost < 1.03 * best.cost) {
        ++cuts_.through_origin;
        best = into_cones;
      }
    }
    const auto begin = order_.begin() + part.first, end = order_.begin() + part.last;
    const auto cut =
        std::partition(begin, end, [&](Index e) { return best.pencil.place(vector(centroids_[e])) < best.place; });
    return cut == begin || cut == end ? middle : Index(cut - order_.begin());
  }

  bool tries_cones(Index count) const
  {
    return options_.cuts == Cuts::through_origin || (options_.cuts == Cuts::least_cost && count > fewest_in_cones);
  }

  Sample sample(Index e, const kernel::Matrix& axes) const
  {
    Sample s{vector(centroids_[e]), Vector::Constant(8), Vector::Constant(-8)};
    for_corners(elements_[e], [&](const Vector& p) {
      const Vector along = axes.transpose() * p;
      s.low = s.low.cwiseMin(along);
      s.high = s.high.cwiseMax(along);
    });
    return s;
  }

  /// Planes through the origin that cut the part where it spreads most, as seen from there; none where the origin is
  /// too near.
  std::optional<Pencil> cones_about(const Part& part) const
  {
    constexpr double steep = 0.05;
    const double distance = part.mean.norm();
    if (!(distance > 0)) return {};
    const Vector along = part.mean / distance, spread = part.axes.col(2), across = spread - spread.dot(along) * along;
    if (!(across.norm() > steep)) return {};
    for (const Sample& s : samples_)
      if (!(s.centroid.dot(along) > steep * s.centroid.norm())) return {};
    return Pencil{across.normalized(), along};
  }

  /// Of all planes of the pencil between two samples: that of the least surface of the boxes of both sides, along the
  /// part's axes, each times the root of its count. (With the count itself, as for rays, or with lengths in place of
  /// surfaces, trees had more boxes to compare.)
  Cut best_cut(const Pencil& pencil)
  {
    auto& order = places_;
    order.clear();
    for (std::size_t k = 0; k < samples_.size(); ++k) order.push_back({pencil.place(samples_[k].centroid), Index(k)});
    std::sort(order.begin(), order.end());
    struct Side {
      Vector low = Vector::Constant(8), high = -low;
      int count = 0;

      double cost_with(const Sample& s)
      {
        low = low.cwiseMin(s.low);
        high = high.cwiseMax(s.high);
        ++count;
        const Vector e = high - low;
        return std::sqrt(double(count)) * (e[0] * e[1] + e[1] * e[2] + e[2] * e[0]);
      }
    };
    Side before, after;
    costs_after_.resize(samples_.size());
    for (std::size_t k = samples_.size(); k-- > 1;) costs_after_[k] = after.cost_with(samples_[order[k].second]);
    Cut best{pencil};
    const std::size_t fewest = samples_.size() / 8;  // else elements that all reach everywhere would be cut off one by
                                                     // one
    for (std::size_t k = 1; k < samples_.size(); ++k) {
      const double cost = before.cost_with(samples_[order[k - 1].second]) + costs_after_[k];
      const bool is_even = k >= fewest && k + fewest <= samples_.size();
      if (is_even && cost < best.cost && order[k - 1].first < order[k].first) {
        best.cost = cost;
        best.place = order[k].first;
      }
    }
    return best;
  }

  /// The corners of the part's elements, each once.
  std::vector<Vector> corners_of(const Part& part)
  {
    std::vector<Vector> points;
    ++stamp_;
    for (Index k = part.first; k < part.last; ++k)
      elements_.for_vertices(elements_[order_[k]], [&](Index v) {
        if (stamps_[v] != stamp_) {
          stamps_[v] = stamp_;
          points.push_back(elements_.local(v));
        }
      });
    return points;
  }

  /// A node of one to eight parts.
  Bvh8_node node_of(const std::vector<Part>& parts)
  {
    Bvh8_node node{};
    node.boxes.lane_count = int(parts.size());
    struct Lane {
      kernel::Oriented_box box;
      std::vector<Vector> points;
    };
    std::vector<Lane> all;
    Vector low = Vector::Constant(4), high = -low;
    for (const Part& part : parts) {
      std::vector<Vector> points = corners_of(part);
      const bool triangle = points.size() == 3;
      const auto box = triangle ? kernel::triangle_box(std::span<const Vector, 3>(points.data(), 3))
                                : kernel::fitted_box(points, fitting_rounds);
      low = low.cwiseMin(box.centre);
      high = high.cwiseMax(box.centre);
      all.push_back({box, std::move(points)});
    }
    // Exact in float, and so in double.
    Vector origin;
    for (int k = 0; k < 3; ++k) origin[k] = node.boxes.origin[k] = float(0.5 * (low[k] + high[k]));
    double reach = 0;
    for (std::size_t lane = 0; lane < parts.size(); ++lane) {
      node.first[lane] = parts[lane].first;
      const std::vector<Vector>& points = all[lane].points;
      kernel::store_lane(node.boxes, int(lane), all[lane].box, origin, points, Bvh8_elements::local_error);
      const bool leaf = is_leaf(parts[lane]);
      if (leaf && !leaf_ends_.empty()) leaf_ends_[parts[lane].first] = parts[lane].last;
      node.boxes.marked |= std::uint32_t(leaf) << lane;
      node.child[lane] =
          !leaf ? Bvh8_node::not_made(parts[lane].last)
          : points.size() == 3
              ? Bvh8_node::leaf(kernel::apex_code(node.boxes, int(lane), origin, std::span<const Vector, 3>(points)))
              : Bvh8_node::leaf(0);
      double sum = 0, square = 0;
      for (int i = 0; i < 3; ++i) {
        sum += node.boxes.extent[i][lane];
        square += double(node.boxes.centre[i][lane]) * node.boxes.centre[i][lane];
      }
      reach = kernel::maximum(reach, sum + std::sqrt(square));
    }
    node.boxes.reach = float(reach * 1.0000002);
    return node;
  }

  const Bvh8_elements& elements_;
  const Bvh8_options options_;
  std::vector<Index>&order_, &leaf_ends_;
  Cut_counts cuts_;
  std::vector<std::array<float, 3>> centroids_;
  std::vector<std::uint32_t> stamps_;  // of vertices: when last gathered
  std::uint32_t stamp_ = 0;
  std::vector<Vector> gathered_;
  std::vector<Sample> samples_;
  std::vector<std::pair<float, Index>> places_;  // of samples
  std::vector<double> costs_after_;

  static constexpr Index most_samples = 1024, fewest_in_cones = 64;
  static constexpr int fitting_rounds = 8;
};

}  // namespace tetracone::tetratree

#endif
