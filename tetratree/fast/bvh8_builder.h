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
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// Makes the nodes of a `Bvh8`, in any order. Ranges first .. last exclude last. It is not thread-safe: `Bvh8` calls it
/// under a lock, or makes a worker for each thread.
class Bvh8_builder {
 public:
  /// Prepares the construction, and computes centroids by `both`. `elements` must outlive the builder; their order
  /// becomes the order of the leaves. Making a node changes only its own range of that order. `leaf_ends` is used when
  /// leaves may hold several elements: it maps a leaf's first position in the order to its end.
  Bvh8_builder(Bvh8_elements& elements, const Bvh8_options& options, std::vector<Index>& leaf_ends,
               const covering::Both& both = {})
      : elements_(elements),
        options_(options),
        leaf_ends_(leaf_ends),
        centroids_(std::make_shared<covering::Unset_vector<Centroid>>()),
        treelet_(elements, options_, leaf_ends)
  {
    assert(options_.leaf_size >= 1 && options_.parts >= 2 && options_.parts <= kernel::lanes);
    assert(options_.cuts != Cuts::tetra_cones || options_.parts == kernel::lanes);
    if (options_.leaf_size > 1) leaf_ends_.resize(elements_.count());
    centroids_->resize(elements_.count());
    covering::in_parts(0, elements_.count(), both, [&](Index first, Index last) {
      for (Index e = first; e < last; ++e) (*centroids_)[e] = centroid(elements_[e]);
    });
  }

  /// Returns a builder for another thread. It shares everything except its scratch memory, and counts its own cuts.
  Bvh8_builder worker() const { return {*this, true}; }

  /// Returns a node of one lane that holds all elements. Requires at least one element.
  Bvh8_node root(const covering::Both& both = {})
  {
    const Bvh8_lane lane = lane_of(0, elements_.count(), corners_, both);
    return node_of(std::span(&lane, 1));
  }

  /// Appends the node of elements first .. last to `nodes` and returns its number. For few elements it appends all
  /// nodes below it, too. Requires more elements than a leaf holds. The result does not depend on `both`.
  template <class Nodes>
  Index make(Index first, Index last, Nodes& nodes, const covering::Both& both = {})
  {
    if (last - first > Bvh8_treelet::most || options_.cuts == Cuts::tetra_cones ||
        options_.cuts == Cuts::through_origin)
      return nodes.push_back(node(first, last, both));
    const std::size_t before = treelet_.cuts();
    const Index made = treelet_.make(first, last, nodes);
    cuts_.all += treelet_.cuts() - before;
    return made;
  }

  /// Appends the node of elements first .. last and all nodes below it to `nodes`, which must be empty.
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

  /// Returns how many cuts were made, and of which kind.
  const Cut_counts& cuts() const { return cuts_; }
  /// Adds the cuts of a worker.
  void add_cuts(const Cut_counts& of_worker) { cuts_ += of_worker; }

  /// Returns the bytes held, except scratch memory.
  std::size_t bytes() const { return centroids_->capacity() * sizeof(Centroid); }

 private:
  using Vector = kernel::Vector;
  using Centroid = std::array<float, 3>;

  struct Count {
    Index of = 0;
    void add(const Count& other) { of += other.of; }
  };

  /// A struct, not `char`: `char` may alias everything, which blocks vectorisation.
  struct Before {
    bool is;
  };

  /// The cuts tried for a part: across the direction in which it spreads most and, when every element allows it, by
  /// planes through the origin.
  struct Tried_cuts {
    Binned_cuts planes;
    std::optional<Binned_cuts> cones;

    void add(const Tried_cuts& other)
    {
      planes.add(other.planes);
      if (cones && other.cones)
        cones->add(*other.cones);
      else
        cones.reset();
    }
  };

  Bvh8_builder(const Bvh8_builder& whole, bool)
      : elements_(whole.elements_),
        options_(whole.options_),
        leaf_ends_(whole.leaf_ends_),
        centroids_(whole.centroids_),
        treelet_(whole.elements_, options_, whole.leaf_ends_)
  {}

  Bvh8_node node(Index first, Index last, const covering::Both& both)
  {
    std::vector<Part> parts = parts_in_cones(first, last);
    const std::size_t most = parts.size() > 1 ? parts.size() : options_.parts;  // cones are not cut further
    while (parts.size() < most) {
      const auto largest =
          std::max_element(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.size < b.size; });
      if (is_leaf(*largest)) break;
      const Part whole = *largest;
      const Index middle = split(whole, both);
      std::optional<Part> before, after;
      both_of(whole.last - whole.first, both)([&] { before = part(whole.first, middle); },
                                              [&] { after = part(middle, whole.last); });
      *largest = *before;
      parts.insert(largest + 1, *after);
    }
    lanes_.clear();
    if (last - first <= covering::most_in_part) {
      for (const Part& part : parts) lanes_.push_back(lane_of(part.first, part.last, corners_, both));
    } else {
      std::array<std::optional<Bvh8_lane>, kernel::lanes> made;
      covering::in_parts(
          0, Index(parts.size()), both,
          [&](Index k, Index) {
            Corner_set corners;
            made[k] = lane_of(parts[k].first, parts[k].last, corners, both);
          },
          1);
      for (std::size_t k = 0; k < parts.size(); ++k) lanes_.push_back(*made[k]);
    }
    return node_of(lanes_);
  }

  template <class What>
  void for_corners(const Element& element, const What& what) const
  {
    elements_.for_vertices(element, [&](Index v) { what(elements_.local(v)); });
  }

  Centroid centroid(const Element& element) const
  {
    Vector sum;
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

  /// A sample of elements first .. last of the order: all of them, or one of each group if there are more than `most`.
  /// The element of a group is pseudo-random, for the order may be regular.
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

  /// Elements first .. last of the order, with the spread of their centroids along the columns of `axes`, least first.
  struct Part {
    Index first, last;
    double size;  // of the spread; 0 for a leaf
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
  bool is_leaf(Index first, Index last) const { return last - first <= options_.leaf_size; }
  bool is_leaf(const Part& part) const { return is_leaf(part.first, part.last); }

  /// Returns `both` where the elements are many enough to pay for it, else one that works in turn.
  static covering::Both both_of(Index count, const covering::Both& both)
  {
    return count > covering::most_in_part ? both : covering::Both();
  }

  /// Returns the parts that tetra-cones hold, for `Cuts::tetra_cones`. Returns one part for other cuts, or if one cone
  /// holds all.
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

  /// Cuts the part in two at the least cost (SAH), and returns the position of the cut in the order. It takes a cut
  /// through the origin that costs less than `most_for_cones` times the other; `Cuts::through_origin` takes it at any
  /// cost. It cuts in the middle of the order where no plane parts the elements.
  Index split(const Part& part, const covering::Both& both)
  {
    const Index count = part.last - part.first, middle = part.first + count / 2;
    const kernel::Spread& spread = part.spread;
    if (count == 2 || !(spread.size() > 0x1p-900)) return middle;
    const kernel::Matrix to_axes = 1 / std::sqrt(spread.size()) * part.axes.transpose();
    const auto along_axes = [&](const Vector& p) {
      const Vector at = to_axes * (p - spread.mean);
      return kernel::Four_floats{float(at[0]), float(at[1]), float(at[2]), 0};
    };
    const auto cuts_across = [&](const Pencil& pencil, double place, double per_length) {
      const double most = std::sqrt(pencil.across.dot(spread.covariance * pencil.across));
      return Binned_cuts(pencil, place, reach_of_bins * most * per_length);
    };
    ++cuts_.all;
    const Vector across = part.axes.col(2);
    const double place = across.dot(spread.mean);
    const auto pencil = tries_cones(count) ? cones_about(part) : std::nullopt;
    const Some some(part.first, part.last, most_seen);
    const auto tried = covering::sum_of_parts(0, some.count(), both, [&](Index first, Index last) {
      Tried_cuts cuts{cuts_across({across, {}}, place, 1), {}};
      auto& [planes, cones] = cuts;
      if (pencil) cones = cuts_across(*pencil, 0, 1 / spread.mean.norm());
      for (Index k = first; k < last; ++k) {
        const Vector p = centroid(some[k]);
        kernel::Four_floats low = along_axes(p), high = low;
        if (count <= most_by_corners)
          for_corners(elements_[some[k]], [&](const Vector& corner) {
            const kernel::Four_floats at = along_axes(corner);
            low = kernel::smaller(low, at);
            high = kernel::larger(high, at);
          });
        planes.add(p, low, high);
        if (cones && !(p.dot(*cones->pencil().along) > steep * p.norm())) cones.reset();
        if (cones) cones->add(p, low, high);
      }
      return cuts;
    });
    Cut best = tried.planes.best();
    if (tried.cones) {
      ++cuts_.tried_cones;
      const Cut into_cones = tried.cones->best();
      if (options_.cuts == Cuts::through_origin || into_cones.cost < most_for_cones * best.cost) {
        ++cuts_.through_origin;
        best = into_cones;
      }
    }
    const Index cut =
        partition(part.first, part.last, both, [&](Index e) { return best.pencil.place(centroid(e)) < best.place; });
    return cut == part.first || cut == part.last ? middle : cut;
  }

  /// Moves the elements for which `is_before` holds to the front; returns where the others begin. The first misplaced
  /// element is swapped with the last, the second with the last but one, and so on.
  template <class Is_before>
  Index partition(Index first, Index last, const covering::Both& both, const Is_before& is_before)
  {
    if (both.is_in_turn() || last - first <= covering::most_in_part) {
      const std::span<Element> elements = elements_.order();
      while (true) {
        while (first < last && is_before(first)) ++first;
        while (first < last && !is_before(last - 1)) --last;
        if (first == last) return first;
        std::swap(elements[first], elements[--last]);
        std::swap((*centroids_)[first++], (*centroids_)[last]);
      }
    }
    const Index all = last - first;
    if (is_before_.size() < all) {
      is_before_.resize(all);
      misplaced_.resize(all);
    }
    const auto count = covering::sum_of_parts(0, all, both, [&](Index begin, Index end) {
      Count sum;
      for (Index k = begin; k < end; ++k) sum.of += is_before_[k].is = is_before(first + k);
      return sum;
    });
    const Index before = count.of;
    Index* const others = misplaced_.data();
    Index* const early = others + before;
    Index swapped = 0;
    both_of(all, both)(
        [&] {
          for (Index k = 0; k < before; ++k) {
            others[swapped] = first + k;
            swapped += !is_before_[k].is;
          }
        },
        [&] {
          Index found = 0;
          for (Index k = all; k-- > before;) {
            early[found] = first + k;
            found += is_before_[k].is;
          }
        });
    const std::span<Element> elements = elements_.order();
    covering::in_parts(0, swapped, both, [&](Index begin, Index end) {
      for (Index k = begin; k < end; ++k) {
        std::swap(elements[others[k]], elements[early[k]]);
        std::swap((*centroids_)[others[k]], (*centroids_)[early[k]]);
      }
    });
    return first + before;
  }

  bool tries_cones(Index count) const
  {
    return options_.cuts == Cuts::through_origin || (options_.cuts == Cuts::least_cost && count > fewest_in_cones);
  }

  /// Returns planes through the origin that cut the part where it spreads most, as seen from the origin. Returns
  /// nothing where the part spreads towards the origin or its mean is there.
  std::optional<Pencil> cones_about(const Part& part) const
  {
    const Vector& mean = part.spread.mean;
    const double distance = mean.norm();
    if (!(distance > 0)) return {};
    const Vector along = mean / distance, spread = part.axes.col(2), across = spread - spread.dot(along) * along;
    if (!(across.norm() > steep)) return {};
    return Pencil{across.normalized(), along};
  }

  /// Returns the box of elements first .. last. Its axes come from a sample of corners where elements are many.
  /// `corners` is scratch memory.
  Bvh8_lane lane_of(Index first, Index last, Corner_set& corners, const covering::Both& both)
  {
    if (is_leaf(first, last) && !leaf_ends_.empty()) leaf_ends_[first] = last;
    if (last - first <= most_fitted) {
      corners.gather(elements_, first, last);
      return {first, last, is_leaf(first, last), corners.points()};
    }
    std::vector<Vector> some_corners;
    some_corners.reserve(3 * most_fitted);
    const Some some(first, last, most_fitted);
    for (Index k = 0; k < some.count(); ++k)
      for_corners(elements_[some[k]], [&](const Vector& p) { some_corners.push_back(p); });
    Bvh8_lane lane(first, last, is_leaf(first, last), kernel::fitted_axes(some_corners, fitting_rounds),
                   some_corners[0]);
    lane.box = covering::sum_of_parts(first, last, both, [&](Index begin, Index end) {
      kernel::Lane_box box = lane.box;
      for (Index e = begin; e < end; ++e) for_corners(elements_[e], [&](const Vector& p) { box.add(p); });
      return kernel::Lane_box(box);  // a copy, so that the box added to stays in registers
    });
    return lane;
  }

  Bvh8_elements& elements_;
  const Bvh8_options options_;
  std::vector<Index>& leaf_ends_;
  Cut_counts cuts_;
  std::shared_ptr<covering::Unset_vector<Centroid>> centroids_;  // in the elements' order
  Bvh8_treelet treelet_;
  Corner_set corners_;
  std::vector<Bvh8_lane> lanes_;
  std::vector<Before> is_before_;  // scratch of `partition`
  std::vector<Index> misplaced_;

  static constexpr Index most_seen = 32768,  ///< elements sampled for a spread or a cut
      most_fitted = 128,                     ///< elements sampled for the axes of a box
      most_by_corners = 256,                 ///< elements of a part up to which cuts bound corners, not centroids
      fewest_in_cones = 64;                  ///< up to this many elements, no plane through the origin is tried
  static constexpr double steep = 0.05,      ///< lower bound of the sines and cosines by which cones may cut a part
      reach_of_bins = 2.5,                   ///< half width of the bins, in standard deviations
      most_for_cones = 1.03;                 ///< cuts of the paper are kept where they cost hardly more than others
};

}  // namespace tetracone::tetratree

#endif
