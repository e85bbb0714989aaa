#ifndef TETRACONE_TETRATREE_QUERY_BVH8_MOTION_H
#define TETRACONE_TETRATREE_QUERY_BVH8_MOTION_H

#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/kernel/motion/motion_span.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/tetratree/fast/bvh8.h"
#include "tetracone/tetratree/fast/separating_direction.h"
#include "tetracone/tetratree/query/moving_features.h"
#include "tetracone/tetratree/query/pair_queue.h"
#include "tetracone/tetratree/query/span_reference.h"
#include "tetracone/tetratree/query_statistics.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace tetracone::tetratree {

/// The result of a search: whether surfaces share a point at t = 0 and, if not, how they first meet, if ever.
struct Meeting {
  bool is_at_start = false;
  std::optional<First_meeting> first;
};

/// The first contact of the surfaces of two moving `Bvh8`, exactly. Build once, ask for many motions.
///
/// Surfaces that share no point at t = 0 first meet where a vertex of one meets a triangle of the other, or an edge an
/// edge.
///
/// A span of time is done when one plane separates the bodies in all of it. Otherwise pairs of boxes are opened, in the
/// order of the times from which on they may meet. Those times come from two similarities near the whole span
/// (`Span_reference`) or, if there are none, from the span's own coefficients (`Motion_span`).
///
/// A pair waits for the halves of the span if the bodies turn too far in it for the pair's size. Pairs of leaves are
/// compared in halves at smaller turns already. Triangles are decided in integers. A pair that may meet only after the
/// first contact found so far is discarded.
///
/// Both trees must outlive the query object. The constructor and every query throw kernel::Unsound_floating_point when
/// floating point is not as exact answers need it.
class Bvh8_motion {
 public:
  /// Requires trees whose elements are triangles, or faces of corners on one line.
  Bvh8_motion(const Bvh8& a, const Bvh8& b) : tree_{&a, &b}, separating_direction_(a, b), features_(a, b)
  {
    kernel::require_exact_arithmetic();
  }

  /// Returns the first contact; nothing if the surfaces never meet. Requires that they share no point at t = 0.
  std::optional<First_meeting> operator()(const kernel::Body_motion& a, const kernel::Body_motion& b)
  {
    return (*this)(a, b, [] { return false; }).first;
  }

  /// Returns the first contact of surfaces that may share a point at t = 0; `meet_at_start()` tells whether they do. It
  /// is called at most once, and not at all if no two elements may meet then.
  Meeting operator()(const kernel::Body_motion& a, const kernel::Body_motion& b,
                     const std::function<bool()>& meet_at_start)
  {
    kernel::require_sound_floating_point();
    if (tree_[0]->empty() || tree_[1]->empty()) return {};
    features_.begin(a, b);
    meet_at_start_ = &meet_at_start;
    is_start_known_ = meets_at_start_ = false;
    search(whole_span(a, b),
           std::array{Pair{0, 1, {tree_[0]->node(0).signed_size(0), tree_[1]->node(0).signed_size(0)}, {}}});
    if (meets_at_start_) return {true, std::nullopt};
    return {false, features_.take_first()};
  }

  Query_statistics counts() const
  {
    Query_statistics all = counts_;
    all += features_.counts();
    return all;
  }
  /// Returns how many pairs each exact stage decided.
  const Motion_stages& stages() const { return features_.stages(); }
  void clear_counts()
  {
    counts_ = {};
    features_.clear_counts();
  }

 private:
  using Vertex = kernel::Vertex;

  /// A box, with its axes.
  struct Part {
    kernel::Moving_box hull;
    std::array<Vertex, 3> axis;
  };
  /// A box of each body. `low` and `until` bound the times when they may meet. The span has the times from 0 to 1; a
  /// pair of a longer span may have times outside. `size` is the signed size in local units.
  struct Pair {
    float low, until;
    std::array<float, 2> size;
    Box_ids box;

    bool is_leaf(std::size_t body) const { return std::signbit(size[body]); }
    float extent(std::size_t body) const { return std::abs(size[body]); }
  };
  /// Directions tried before the search for a plane ends.
  static constexpr int most_directions = 8;
  static constexpr int most_in_vain = 16,  // limit of `in_vain_`, at which spans are left out
      vain_for_one = 8;                    // see `in_vain_`
  /// While `in_vain_` is at its limit, one span of this many is searched: of whole motions, of parts.
  static constexpr std::array<unsigned, 2> one_in = {32, 8};
  /// Pairs opened in one round.
  static constexpr std::size_t most_openings = kernel::most_sweep_tests;
  /// A span is halved at most this often.
  static constexpr unsigned most_halvings = 50;
  static constexpr float share_of_size = 0.04f;     // a larger fraction of a pair's size lost by its turning splits the
                                                    // span
  static constexpr float share_of_leaves = 0.002f;  // a larger fraction lost makes leaves meet in halves

  kernel::Motion_units units(int body) const { return {tree_[body]->scale().origin, tree_[body]->scale().unit}; }

  kernel::Motion_span whole_span(const kernel::Body_motion& a, const kernel::Body_motion& b)
  {
    const auto &of_a = a.ends(), &of_b = b.ends();
    if (of_a && of_b)
      if (const auto span = kernel::Motion_span::of_lines(*of_a, units(0), *of_b, units(1))) return *span;
    return kernel::Motion_span(features_.motion(), units(0), units(1));
  }

  Part part(int body, Box_id box) const
  {
    const Bvh8_node& node = tree_[body]->node_of(box);
    Part part{hull_of(node, box.lane()), {}};
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) part.axis[i][k] = node.boxes.axis[i][k][box.lane()];
    return part;
  }

  /// True when a plane separates the bodies in all of the span. Where most recent searches failed, only one span in a
  /// few is searched.
  bool is_parted(const kernel::Motion_span& span)
  {
    const std::size_t kind = span.k() > 0;
    int& in_vain = in_vain_[kind];
    if (in_vain == most_in_vain && ++left_out_[kind] % one_in[kind] != 0) return false;
    const bool is_found = separating_direction_(span, most_directions);
    in_vain = is_found ? kernel::maximum(in_vain - vain_for_one, 0) : kernel::minimum(in_vain + 1, most_in_vain);
    return is_found;
  }

  /// Opens the pairs in a span of time, and then the remaining ones in its halves.
  void search(const kernel::Motion_span& span, std::span<const Pair> pairs)
  {
    if (is_parted(span)) return;
    const Span_reference reference(span);
    const Turning turning(span, reference);
    features_.enter(span);
    queue_.clear(0, 1);
    for (const Pair& pair : pairs) queue_.push(pair);
    std::vector<Pair> later;
    while (!queue_.empty()) {
      std::size_t count = 0;
      while (count < most_openings && !queue_.empty()) {
        if (features_.is_any_undecided()) {
          features_.decide_until(double(queue_.lowest()));
          features_.look_ahead();
        }
        const Pair pair = queue_.pop();
        if (double(pair.low) > features_.latest() || features_.are_parted(pair.box)) continue;
        // A pair of the second half alone waits once any pair does: the second half may turn out needless.
        const bool is_of_leaves = pair.is_leaf(0) && pair.is_leaf(1);
        if (turning.is_long(pair, share_of_size) || (!later.empty() && pair.low >= 0.5f))
          later.push_back(pair);
        else if (is_of_leaves && turning.is_long(pair, share_of_leaves))
          meet_in_halves(pair);
        else if (is_of_leaves)
          meet_leaves(Span_part::whole, pair, {double(pair.low), double(pair.until)});
        else
          open(span, reference, pair, count++);
      }
      find_near(span, reference, count);
      push_near(count);
    }
    features_.decide_until(1);
    for (const bool is_second : {false, true}) {
      std::vector<Pair> in_half;
      for (const Pair& pair : later)
        if (is_second ? pair.until >= 0.5f : pair.low <= 0.5f)
          in_half.push_back({2 * pair.low - float(is_second), 2 * pair.until - float(is_second), pair.size, pair.box});
      if (in_half.empty()) continue;
      const kernel::Motion_span half = span.half(is_second);
      if (half.start() < features_.before()) search(half, in_half);
    }
  }

  /// How much gaps of boxes lose because bodies turn in a span.
  struct Turning {
    std::array<float, 2> turn, scale;
    float rest, least;
    bool has_halves;

    Turning(const kernel::Motion_span& span, const Span_reference& reference)
        : turn{float(span.turn(0)), float(span.turn(1))},
          scale{float(span.scale(0)), float(span.scale(1))},
          rest(reference.is_certifiable() ? float(reference.rest()) : 0),
          // A loss that halves do not reduce, or that doubles do not resolve, is not worth another halving.
          least(float(
              kernel::maximum(8 * span.resolution(), reference.is_certifiable() ? 2 * reference.lasting_rest() : 0.0))),
          has_halves(span.k() < most_halvings)
    {}

    /// True when the boxes' loss exceeds this fraction of their size.
    bool is_long(const Pair& pair, float share) const
    {
      const float a = pair.extent(0), b = pair.extent(1), lost = a * turn[0] + b * turn[1] + rest,
                  size = kernel::maximum(a * scale[0], b * scale[1]);
      return has_halves && !(lost <= kernel::maximum(share * size, least));
    }
  };

  /// Returns the body whose box is opened: the larger one. Requires a box that is no leaf.
  static int opens(const kernel::Motion_span& span, const Pair& pair)
  {
    return pair.is_leaf(0) || (!pair.is_leaf(1) && pair.extent(1) * span.scale(1) > pair.extent(0) * span.scale(0));
  }

  /// Prepares opening `number` of a pair that is not of leaves: the parts of its larger box against the other box.
  void open(const kernel::Motion_span& span, const Span_reference& reference, const Pair& pair, std::size_t number)
  {
    const int body = opens(span, pair);
    const Box_id other = pair.box[std::size_t(1 - body)];
    const Index node = tree_[body]->child(pair.box[std::size_t(body)]);
    tree_[body]->prefetch(node);
    opening_[number] = {pair, body, node};
    const Bvh8_node& from = tree_[std::size_t(1 - body)]->node_of(other);
    const int lane = other.lane();
    const float apex =
        from.is_leaf(lane) ? kernel::apex_of(Bvh8_node::apex(from.child[std::size_t(lane)])) : kernel::no_apex;
    reference.ask(test_[number], std::size_t(body), tree_[body]->node(node).boxes, from.boxes, lane, apex,
                  known_times(pair));
  }

  /// Tests the parts of the first `count` openings.
  void find_near(const kernel::Motion_span& span, const Span_reference& reference, std::size_t count)
  {
    counts_.pairs_visited += count;
    for (std::size_t k = 0; k < count; ++k) counts_.box_tests += std::uint64_t(test_[k].boxes->lane_count);
    if (reference.is_certifiable()) return kernel::find_near(test_.data(), count);
    for (std::size_t k = 0; k < count; ++k) find_near(span, opening_[k], test_[k]);
  }

  /// Returns the times of a pair in this span; the pair may come from a longer one.
  static kernel::Known_times known_times(const Pair& pair)
  {
    return {kernel::maximum(pair.low, 0.f), kernel::minimum(pair.until, 1.f)};
  }

  /// Queues the parts of the first `count` openings that may meet the other box.
  void push_near(std::size_t count)
  {
    static_assert(kernel::lanes * most_openings <= 32);
    // One loop, since the count of an opening is unpredictable.
    std::uint32_t near = 0;
    for (std::size_t k = 0; k < count; ++k) near |= std::uint32_t(test_[k].near) << kernel::lanes * k;
    for (; near != 0; near &= near - 1) {
      const auto bit = std::size_t(std::countr_zero(near));
      const std::size_t number = bit / kernel::lanes, lane = bit % kernel::lanes;
      const Opened_pair<Pair>& o = opening_[number];
      Pair closer = o.pair;
      closer.low = test_[number].times.from[lane];
      closer.until = test_[number].times.until[lane];
      closer.box[std::size_t(o.body)] = {o.node, int(lane)};
      closer.size[std::size_t(o.body)] = tree_[o.body]->node(o.node).signed_size(int(lane));
      queue_.push(closer);
    }
  }

  /// Tests the parts of an opening, when no similarities are near the span.
  void find_near(const kernel::Motion_span& span, const Opened_pair<Pair>& o, kernel::Sweep_test& test) const
  {
    const Part from = part(1 - o.body, o.pair.box[std::size_t(1 - o.body)]);
    test.near = 0;
    for (int lane = 0; lane < test.boxes->lane_count; ++lane) {
      const Part own = part(o.body, {o.node, lane});
      const kernel::Time_window window = o.body == 0 ? near_boxes(span, own, from) : near_boxes(span, from, own);
      auto& [first, last] = test.times;
      first[lane] = kernel::maximum(test.known.from, float(window.from * (1 - 0x1p-20)) - 0x1p-40f);
      last[lane] = kernel::minimum(test.known.until, float(window.until * (1 + 0x1p-20)) + 0x1p-40f);
      if (!(first[lane] > last[lane])) test.near |= 1u << lane;
    }
  }

  /// Compares two leaves in the half in which they may meet first; queues them again for the other half.
  void meet_in_halves(const Pair& pair)
  {
    const double from = 2 * double(pair.low), until = 2 * double(pair.until);
    if (pair.low >= 0.5f) return meet_leaves(Span_part::second_half, pair, {from - 1, until - 1});
    meet_leaves(Span_part::first_half, pair, {from, kernel::minimum(until, 1.0)});
    if (pair.until < 0.5f) return;
    Pair rest = pair;
    rest.low = 0.5f;
    queue_.push(rest);
  }

  void meet_leaves(Span_part part, const Pair& pair, const kernel::Time_window& times)
  {
    ++counts_.leaf_pairs;
    const auto& [a, b] = pair.box;
    for (Index i = 0; i < tree_[0]->leaf_count(a); ++i)
      for (Index j = 0; j < tree_[1]->leaf_count(b); ++j)
        features_.meet(part, times, tree_[0]->element(a, i), tree_[1]->element(b, j));
    if (features_.is_start_in_doubt() && !is_start_known_) ask_about_start();
  }

  void ask_about_start()
  {
    is_start_known_ = true;
    meets_at_start_ = (*meet_at_start_)();
    if (meets_at_start_) features_.end();
  }

  /// Returns when boxes may meet, by the line of their centres and the axes that separate them in the middle of the
  /// span.
  static kernel::Time_window near_boxes(const kernel::Motion_span& span, const Part& a, const Part& b)
  {
    const auto& maps = span.at_middle();
    kernel::Time_window near;
    const auto is_apart = [&](const Vertex& axis) {
      near = common(near, span.near_along(kernel::scaled_to_one(axis), a.hull, b.hull));
      return near.is_empty();
    };
    if (is_apart(span.between(maps, a.hull.centre, b.hull.centre))) return near;
    std::array<std::array<Vertex, 3>, 2> edge;
    for (int k = 0; k < 3; ++k) {
      edge[0][k] = span.direction(maps, 0, a.axis[k]);
      edge[1][k] = span.direction(maps, 1, b.axis[k]);
    }
    for (const auto& e : edge)
      for (int k = 0; k < 3; ++k)
        if (is_apart(kernel::cross(e[(k + 1) % 3], e[(k + 2) % 3]))) return near;
    for (const Vertex& of_a : edge[0])
      for (const Vertex& of_b : edge[1])
        if (is_apart(kernel::cross(of_a, of_b))) return near;
    return near;
  }

  // All are tested before their results are queued: the tests do not wait for one another.
  std::array<Opened_pair<Pair>, most_openings> opening_;
  std::array<kernel::Sweep_test, most_openings> test_;
  std::array<const Bvh8*, 2> tree_;
  Separating_direction separating_direction_;
  Moving_feature_search features_;
  Pair_queue<Pair, 64> queue_;
  Query_statistics counts_;
  // For whole motions, and for parts of them:
  std::array<int, 2> in_vain_{};        // failed searches for a plane, less `vain_for_one` for each success
  std::array<unsigned, 2> left_out_{};  // spans that were not searched
  const std::function<bool()>* meet_at_start_ = nullptr;
  bool is_start_known_ = false, meets_at_start_ = false;
};

}  // namespace tetracone::tetratree

#endif
