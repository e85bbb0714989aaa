#ifndef TETRACONE_TETRATREE_FAST_BVH8_BUILDER_H
#define TETRACONE_TETRATREE_FAST_BVH8_BUILDER_H

#include "tetracone/kernel/bound/oriented_box.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/tetratree/fast/bvh8_cuts.h"
#include "tetracone/tetratree/fast/bvh8_elements.h"
#include "tetracone/tetratree/fast/bvh8_lane.h"
#include "tetracone/tetratree/fast/bvh8_node.h"
#include "tetracone/tetratree/fast/bvh8_options.h"
#include "tetracone/tetratree/fast/bvh8_treelet.h"
#include "tetracone/tetratree/fast/cone_order.h"
#include "tetracone/tetratree/fast/corner_set.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// Makes the nodes of a `Bvh8`, in any order. Not thread-safe: `Bvh8` calls it under a lock, or makes a worker for each
/// thread.
class Bvh8_builder {
 public:
  /// `elements` must outlive the builder. Their order becomes that of the leaves: a node's making changes its own range
  /// of it alone. `leaf_ends`, where leaves may hold several elements: by where in the order a leaf begins, where it
  /// ends.
  Bvh8_builder(Bvh8_elements& elements, const Bvh8_options& options, std::vector<Index>& leaf_ends)
      : elements_(elements),
        options_(options),
        leaf_ends_(leaf_ends),
        centroids_(std::make_shared<std::vector<Centroid>>()),
        treelet_(elements, options_, leaf_ends)
  {
    assert(options_.leaf_size >= 1 && options_.parts >= 2 && options_.parts <= kernel::lanes);
    assert(options_.cuts != Cuts::tetra_cones || options_.parts == kernel::lanes);
    if (options_.leaf_size > 1) leaf_ends_.resize(elements_.count());
    centroids_->reserve(elements_.count());
    for (Index e = 0; e < elements_.count(); ++e) centroids_->push_back(centroid(elements_[e]));
  }

  /// One for another thread, which shares all but what is in use while a node is made, and counts its own cuts.
  Bvh8_builder worker() const { return {*this, true}; }

  /// One lane that holds everything. Requires an element.
  Bvh8_node root()
  {
    const Bvh8_lane lane = lane_of(part(0, elements_.count()));
    return node_of(std::span(&lane, 1));
  }

  /// Appends the node of elements first .. last to `nodes` and returns its number. Where they are few, all nodes below
  /// it are appended, too. Requires more elements than a leaf holds.
  template <class Nodes>
  Index make(Index first, Index last, Nodes& nodes)
  {
    if (last - first > Bvh8_treelet::most || options_.cuts == Cuts::tetra_cones ||
        options_.cuts == Cuts::through_origin)
      return nodes.push_back(node(first, last));
    const std::size_t before = treelet_.cuts();
    const Index made = treelet_.make(first, last, nodes);
    cuts_.all += treelet_.cuts() - before;
    return made;
  }

  /// Appends that node and all below it to `nodes`, which must be empty.
  template <class Nodes>
  void make_all(Index first, Index last, Nodes& nodes)
  {
    make(first, last, nodes);
    for (Index n = 0; n < nodes.size(); ++n)
      for (int lane = 0; lane < nodes.data()[n].boxes.lane_count; ++lane) {
        if (nodes.data()[n].is_made(lane)) continue;
        const Index end = Bvh8_node::last_of(nodes.data()[n].child[lane]);
        const Index child = make(nodes.data()[n].first[lane], end, nodes);
        nodes.data()[n].child[lane] = std::int32_t(child);
      }
  }

  const Cut_counts& cuts() const { return cuts_; }
  void add_cuts(const Cut_counts& of_worker) { cuts_ += of_worker; }

  std::size_t bytes() const { return centroids_->capacity() * sizeof(Centroid); }

 private:
  using Vector = kernel::Vector;
  using Centroid = std::array<float, 3>;

  Bvh8_builder(const Bvh8_builder& whole, bool)
      : elements_(whole.elements_),
        options_(whole.options_),
        leaf_ends_(whole.leaf_ends_),
        centroids_(whole.centroids_),
        treelet_(whole.elements_, options_, whole.leaf_ends_)
  {}

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
    lanes_.clear();
    for (const Part& part : parts) lanes_.push_back(lane_of(part));
    return node_of(lanes_);
  }

  template <class What>
  void for_corners(const Element& element, const What& what) const
  {
    elements_.for_vertices(element, [&](Index v) { what(elements_.local(v)); });
  }

  Centroid centroid(const Element& element) const
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
  Vector centroid(Index e) const
  {
    const Centroid& c = (*centroids_)[e];
    return {c[0], c[1], c[2]};
  }

  /// Elements first .. last of the order or, where they are more than `most`, one of each so many; which one is by
  /// chance, for there may be an order in them.
  class Some {
   public:
    Some(Index first, Index last, Index most)
        : first_(first), of_(last - first), count_(kernel::minimum(last - first, most))
    {}

    Index count() const { return count_; }
    Index operator[](Index k) const
    {
      if (count_ == of_) return first_ + k;
      const std::uint32_t chance = (k * 0x9e3779b1u) >> 16;
      return first_ + Index((std::uint64_t(k) << 16 | chance) * of_ / count_ >> 16);
    }

   private:
    Index first_, of_, count_;
  };

  /// Elements first .. last of the order, and how far their centroids spread: along the columns of `axes`, the last one
  /// the most.
  struct Part {
    Index first, last;
    double size;
    kernel::Spread spread;
    kernel::Matrix axes;
  };

  Part part(Index first, Index last)
  {
    const Some some(first, last, most_seen);
    const kernel::Spread spread(some.count(), [&](std::size_t k) { return centroid(some[Index(k)]); });
    return {first, last, last - first > options_.leaf_size ? kernel::maximum(spread.size(), 1e-300) : 0, spread,
            spread.principal_axes()};
  }
  bool is_leaf(const Part& part) const { return part.last - part.first <= options_.leaf_size; }

  /// With `Cuts::tetra_cones`: the parts that cones hold; one part where these are not asked for, or do not part it.
  std::vector<Part> parts_in_cones(Index first, Index last)
  {
    if (options_.cuts != Cuts::tetra_cones) return {part(first, last)};
    std::vector<Index> order(last - first);
    std::iota(order.begin(), order.end(), first);
    const auto begins = order_by_cones(order, [this](Index e) { return centroid(e); });
    std::vector<std::pair<Element, Centroid>> ordered;
    ordered.reserve(order.size());
    for (const Index e : order) ordered.push_back({elements_[e], (*centroids_)[e]});
    for (Index k = 0; k < ordered.size(); ++k)
      std::tie(elements_.order()[first + k], (*centroids_)[first + k]) = ordered[k];
    std::vector<Part> parts;
    for (std::size_t k = 0; k < begins.size(); ++k)
      parts.push_back(part(first + Index(begins[k]), k + 1 < begins.size() ? first + Index(begins[k + 1]) : last));
    return parts;
  }

  /// Cuts the part in two, and returns where in the order: the boxes of both are small for what they hold. In the
  /// middle where all elements are in one place.
  Index split(const Part& part)
  {
    const Index count = part.last - part.first, middle = part.first + count / 2;
    const kernel::Spread& spread = part.spread;
    if (count == 2 || !(spread.size() > 0x1p-900)) return middle;
    const double scale = 1 / std::sqrt(spread.size());
    const auto along_axes = [&](const Vector& p) -> Binned_cuts::Four {
      const Vector at = scale * (part.axes.transpose() * (p - spread.mean));
      return {float(at[0]), float(at[1]), float(at[2]), 0};
    };
    const auto cuts_across = [&](const Pencil& pencil, double place, double per_length) {
      const double most = std::sqrt(pencil.across.dot(spread.covariance * pencil.across));
      return Binned_cuts(pencil, place, reach_of_bins * most * per_length);
    };
    ++cuts_.all;
    const Vector across = part.axes.col(2);
    Binned_cuts planes = cuts_across({across, {}}, across.dot(spread.mean), 1);
    std::optional<Binned_cuts> cones;
    if (const auto pencil = tries_cones(count) ? cones_about(part) : std::nullopt)
      cones = cuts_across(*pencil, 0, 1 / spread.mean.norm());
    const Some some(part.first, part.last, most_seen);
    for (Index k = 0; k < some.count(); ++k) {
      const Vector p = centroid(some[k]);
      Binned_cuts::Four low = along_axes(p), high = low;
      if (count <= most_by_corners)
        for_corners(elements_[some[k]], [&](const Vector& corner) {
          const Binned_cuts::Four at = along_axes(corner);
          low = low.min(at);
          high = high.max(at);
        });
      planes.add(p, low, high);
      if (cones && !(p.dot(*cones->pencil().along) > steep * p.norm())) cones.reset();
      if (cones) cones->add(p, low, high);
    }
    Cut best = planes.best();
    if (cones) {
      ++cuts_.tried_cones;
      const Cut into_cones = cones->best();
      if (options_.cuts == Cuts::through_origin || into_cones.cost < 1.03 * best.cost) {
        ++cuts_.through_origin;
        best = into_cones;
      }
    }
    const Index cut =
        partition(part.first, part.last, [&](Index e) { return best.pencil.place(centroid(e)) < best.place; });
    return cut == part.first || cut == part.last ? middle : cut;
  }

  /// Elements of which `is_before` says so come first; returns where the others begin.
  template <class Is_before>
  Index partition(Index first, Index last, const Is_before& is_before)
  {
    const std::span<Element> elements = elements_.order();
    while (true) {
      while (first < last && is_before(first)) ++first;
      while (first < last && !is_before(last - 1)) --last;
      if (first == last) return first;
      std::swap(elements[first], elements[--last]);
      std::swap((*centroids_)[first++], (*centroids_)[last]);
    }
  }

  bool tries_cones(Index count) const
  {
    return options_.cuts == Cuts::through_origin || (options_.cuts == Cuts::least_cost && count > fewest_in_cones);
  }

  /// Planes through the origin that cut the part where it spreads most, as seen from there; none where the origin is
  /// too near.
  std::optional<Pencil> cones_about(const Part& part) const
  {
    const Vector& mean = part.spread.mean;
    const double distance = mean.norm();
    if (!(distance > 0)) return {};
    const Vector along = mean / distance, spread = part.axes.col(2), across = spread - spread.dot(along) * along;
    if (!(across.norm() > steep)) return {};
    return Pencil{across.normalized(), along};
  }

  /// A lane of many elements has the axes that some of their corners tell.
  Bvh8_lane lane_of(const Part& part)
  {
    const Index first = part.first, last = part.last;
    if (is_leaf(part) && !leaf_ends_.empty()) leaf_ends_[first] = last;
    if (last - first <= most_fitted) {
      corners_.gather(elements_, first, last);
      return {first, last, is_leaf(part), corners_.points()};
    }
    gathered_.clear();
    const Some some(first, last, most_fitted);
    for (Index k = 0; k < some.count(); ++k)
      for_corners(elements_[some[k]], [&](const Vector& p) { gathered_.push_back(p); });
    Bvh8_lane lane(first, last, is_leaf(part), kernel::fitted_axes(gathered_, fitting_rounds), gathered_[0]);
    for (Index e = first; e < last; ++e) for_corners(elements_[e], [&](const Vector& p) { lane.box.add(p); });
    return lane;
  }

  Bvh8_elements& elements_;
  const Bvh8_options options_;
  std::vector<Index>& leaf_ends_;
  Cut_counts cuts_;
  std::shared_ptr<std::vector<Centroid>> centroids_;  // in the elements' order
  Bvh8_treelet treelet_;
  Corner_set corners_;
  std::vector<Bvh8_lane> lanes_;
  std::vector<Vector> gathered_;

  static constexpr Index most_seen = 32768, most_fitted = 128, most_by_corners = 256, fewest_in_cones = 64;
  static constexpr double steep = 0.05, reach_of_bins = 2.5;
};

}  // namespace tetracone::tetratree

#endif
