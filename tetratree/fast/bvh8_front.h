#ifndef TETRACONE_TETRATREE_FAST_BVH8_FRONT_H
#define TETRACONE_TETRATREE_FAST_BVH8_FRONT_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/bound/relative_motion.h"
#include "tetracone/kernel/bound/triangle_distance.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/predicate/question.h"
#include "tetracone/tetratree/fast/bvh8.h"
#include "tetracone/tetratree/fast/bvh8_descent.h"
#include "tetracone/tetratree/fast/front_entries.h"
#include "tetracone/tetratree/fast/front_policy.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// What a pair of bodies keeps from one pose to the next: the front of the last descent, with certificates; the pair of
/// leaves that met; what decided. A query gives the same answers with it as without.
///
/// The front covers all pairs of elements: parts of a node that were apart from a box of the other body, by a gap at
/// least; and pairs of leaves, by a lower bound of their distance. Gaps and motions are in A's local units, where A
/// stands still.
///
/// Bodies go on as they went, mostly. So B is on a course (`kernel::Course`), by the step between two poses: later poses
/// are so many steps of it, and its points have strayed by so much at most from where these lead. A step takes at most a
/// rate off a gap along an axis that stands still with A, and the pace off any distance; and what a point has strayed, it
/// may be nearer. An entry holds until that has used up its gap (`Front_entries`). Then it alone is asked again, and what
/// is no longer apart is opened, from there. Where B strays by much, it is set on a new course. Cf. Klosowski et al.,
/// "Efficient collision detection using bounding volume hierarchies of k-DOPs" (1998), generalised front tracking, which
/// has no gaps; Mirtich's conservative advancement, which has no front; Basch, Guibas and Hershberger, "Data structures
/// for mobile data" (1999), whose certificates hold on a course alone, which must be known.
///
/// Motions are bounded by the two relative maps alone (`kernel::stray_bound`), with their errors: where these are not
/// known, or the maps are no similarities, nothing is certified, and descents begin at the root. Where steps are so
/// large that the front does not pay (`Front_policy`), they do as well.
///
/// One for a pair of placed bodies, whatever query object it is asked by: bodies of the same two trees, in the same
/// order, may share that object and keep a front each. Not for two threads at a time.
class Bvh8_front {
 public:
  /// A's box and B's.
  using Boxes = std::pair<Index, Index>;

  /// What is known of a pair of leaves: that elements meet, or at most how far all are apart, in A's local units, 0
  /// where that is not known; and along which axis, of length 1, from A's to B's, 0 where it is along several.
  struct Leaf_gap {
    bool meet = false;
    double gap = 0;
    kernel::Double_vector axis{};
  };

  /// Whether there is a front.
  bool holds() const { return holds_; }
  const Front_entries& entries() const { return entries_; }

  /// At most how far the boxes of an entry are apart, in A's local units, in the pose that was asked last; not above 0
  /// where nothing is known.
  double gap(std::size_t k) const { return entries_.gap(k); }

  /// Since the front was made.
  std::size_t poses_followed() const { return poses_followed_; }

  std::size_t bytes() const { return entries_.bytes() + expired_.capacity() * sizeof(std::uint32_t); }

  // For the query.

  /// The pair of leaves that met in the last pose, tried first in the next.
  std::optional<Boxes> witness;

  /// Whether a plane between the bodies is to be tried before the front.
  bool is_plane_first() const { return is_plane_first_ || !holds_; }
  void set_plane_first(bool is_first) { is_plane_first_ = is_first; }

  /// What was found of solids whose surfaces shared no point, where nothing has met since.
  std::optional<kernel::Relation> relation;

  /// Whether gaps between bodies can be certified under these maps: similarities whose errors are far below all that
  /// they move.
  static bool is_certifiable(const Both_trees& trees)
  {
    for (const kernel::Box_map* map : trees.into)
      if (!map->is_similarity() || !(map->frame().error() <= most_error * map->scale())) return false;
    return true;
  }
  static constexpr double most_error = 0x1p-26;

  /// By how much the least stretch of B's exact map is below the length of its first computed column, a share of that: the
  /// map is a similarity but for `Relative_frame::similarity_defect`, and columns are off by what `most_error` lets pass.
  static constexpr double stretch_loss = 0x1p-20;

  /// What a gap of leaves loses by being rounded to float, and along an axis whose length is rounded: a share of itself.
  static constexpr double leaf_gap_rounding = 0x1p-20;

  /// Bodies that stray by more in a pose are set on a new course: a share of what they go on theirs, and as much as those
  /// at rest may seem to.
  static constexpr double most_strayed = 0.25, most_at_rest = 0x1p-30;

  /// Whether the next descent from the root is to make a front.
  bool is_to_be_made() { return policy_.makes_front(); }

  /// Descends from the root. True where leaf_pair(box of A, box of B), a Leaf_gap, finds elements that meet. Requires
  /// `is_certifiable`.
  template <class Leaf_pair>
  bool make(Pair_stack& stack, Both_trees& trees, const Bvh8& a, const Bvh8& b, const Leaf_pair& leaf_pair)
  {
    entries_.clear();
    box_ = kernel::Body_box(b.node(0).boxes, 0);
    at_ = kernel::Placement(*trees.into[1]);
    course_ = {};
    poses_followed_ = 0;
    holds_ = true;
    leaf_pairs_ = 0;
    relation.reset();
    stack.clear();
    push(stack, trees, {0, 0});
    const std::uint64_t before = trees.opened;
    const bool meet = descend(stack, trees, certifying(trees), a, b, leaf_pair);
    policy_.made(cost(double(trees.opened - before)));
    return meet;
  }

  /// Brings the front to the present pose. True where elements meet; nothing where there is no front any more.
  template <class Leaf_pair>
  std::optional<bool> follow(Pair_stack& stack, Both_trees& trees, const Bvh8& a, const Bvh8& b,
                             const Leaf_pair& leaf_pair)
  {
    const std::optional<double> step = go_on(trees);
    if (!step || !is_certifiable(trees) || policy_.is_worn()) return forget();
    ++poses_followed_;

    expired_.resize(entries_.count() + kernel::lanes);
    std::size_t count = expired(entries_, expired_.data());
    double left = std::numeric_limits<double>::infinity();
    least_gap_ = left;
    if (relation)
      for (std::size_t k = 0; k < count; ++k) left = kernel::minimum(left, entries_.gap_before(expired_[k]));
    const std::size_t checked = count;
    const Certifying units = certifying(trees);
    count = keep_by_axes(units, expired_.data(), count, least_gap_);
    if (!policy_.is_worth(count)) return forget();

    stack.clear();
    leaf_pairs_ = 0;
    const std::uint64_t opened = trees.opened;
    // From the last one on: where one is removed, the last takes its place.
    open_again(stack, trees, units, expired_.data(), count, least_gap_);
    bool meet = false;
    for (std::size_t k = count; k-- > 0 && !meet;) meet = ask_again(stack, trees, units, expired_[k], leaf_pair);
    if (meet)
      keep_rest(stack);
    else
      meet = descend(stack, trees, units, a, b, leaf_pair);
    policy_.followed(cost(Front_policy::of_certified * double(trees.opened - opened)) +
                     Front_policy::of_check * double(checked));
    // On the way, straight, from the last pose to this one, t of it from 0 to 1, those asked again were apart before the
    // step reached what was left, t step < left, and again where (1 - t) step < the new gap. Where these hold in turn
    // for all t, no surface has passed the other: a shell that was inside is inside, and one outside outside.
    if (meet || !(left + least_gap_ > *step)) relation.reset();
    return meet;
  }

 private:
  /// Takes B to its present place: along the course that it is on, where that tells most of its way, else on a new one.
  /// Returns at least how far a point of B has gone; nothing where that is not known or too far.
  std::optional<double> go_on(const Both_trees& trees)
  {
    const kernel::Placement now(*trees.into[1]);
    double steps = kernel::steps_along(course_, at_, now),
           strayed = kernel::stray_bound(course_, steps, at_, now, box_);
    if (!(strayed <= most_strayed * (steps * entries_.pace()) + most_at_rest) || entries_.has_gone_far()) {
      course_ = kernel::Course(at_, now);
      entries_.set_course(kernel::pace_bound(course_, box_));
      steps = 1;
      strayed = kernel::stray_bound(course_, steps, at_, now, box_);
    }
    entries_.go_on(steps, strayed);
    at_ = now;
    const double gone = (steps * entries_.pace() + strayed) * (1 + kernel::few_roundings);
    if (!(gone <= Front_entries::most_gone)) return std::nullopt;
    return gone;
  }

  std::nullopt_t forget()
  {
    holds_ = false;
    relation.reset();
    policy_.ended();
    return std::nullopt;
  }

  /// Of openings that cost so much, and the pairs of leaves.
  double cost(double opened) const { return opened + Front_policy::of_elements * double(leaf_pairs_); }

  /// With lower bounds of the distances in A's local units over those in the units of either body.
  Certifying certifying(const Both_trees& trees)
  {
    const kernel::Placement of_a(*trees.into[0]);
    return {{{*trees.into[0], of_a, course_.reversed(of_a)}, {*trees.into[1], at_, course_}},
            {1, at_.scale * (1 - stretch_loss)},
            &entries_};
  }

  static void push(Pair_stack& stack, const Both_trees& trees, const Boxes& boxes)
  {
    const auto size = [&](int body, Index box) {
      const auto lane = int(box % 8);
      const Bvh8_node& node = trees.nodes[body][box / 8];
      const float sum = node.boxes.extent[0][lane] + node.boxes.extent[1][lane] + node.boxes.extent[2][lane];
      return node.is_leaf(lane) ? -sum : sum;
    };
    stack.push(boxes.first, boxes.second, size(0, boxes.first) * trees.scale, size(1, boxes.second));
  }

  /// Takes in what is known of an entry that was asked now.
  void renew(std::size_t k, double gap)
  {
    entries_.set_gap(k, gap);
    least_gap_ = kernel::minimum(least_gap_, gap);
  }

  /// Removes what has no lanes left, and asks pairs of boxes again; what is to be opened is on the stack then. True where
  /// elements meet.
  template <class Leaf_pair>
  bool ask_again(Pair_stack& stack, const Both_trees& trees, const Certifying& units, std::size_t k,
                 const Leaf_pair& leaf_pair)
  {
    Front_entry& entry = entries_[k];
    if (entry.kind != Front_entry::Kind::pair) {
      if (entry.lanes == 0) entries_.remove(k);
      return false;
    }
    const auto is_leaf = [&](int body, Index box) { return trees.nodes[body][box / 8].is_leaf(int(box % 8)); };
    if (!is_leaf(0, entry.first) || !is_leaf(1, entry.second)) {
      push(stack, trees, {entry.first, entry.second});
      entries_.remove(k);
      return false;
    }
    ++leaf_pairs_;
    const Leaf_gap found = leaf_pair(entry.first, entry.second);
    if (found.meet) witness = {entry.first, entry.second};
    entry.lanes = certify(trees, units, entry.second, found, entries_.certificate(k));
    renew(k, found.meet ? 0 : found.gap);
    return found.meet;
  }

  /// Writes the certificate of a pair of leaves. Returns its lanes.
  static std::uint8_t certify(const Both_trees& trees, const Certifying& units, Index box_b, const Leaf_gap& found,
                              Certificate& certificate)
  {
    if (!(found.gap > 0) || found.axis == kernel::Double_vector{}) return 0;
    certificate.gaps.gap[0] = float(found.gap * (1 - leaf_gap_rounding));
    for (int k = 0; k < 3; ++k) certificate.gaps.axis[k][0] = float(found.axis[k]);
    const kernel::Obb8& boxes = trees.nodes[1][box_b / 8].boxes;
    kernel::carry_now(units.carrier[1], boxes, int(box_b % 8), certificate.carried);
    certificate.going = kernel::Going_box(boxes, int(box_b % 8));
    return 1;
  }

  /// Opens what is on the stack, until elements meet.
  template <class Leaf_pair>
  bool descend(Pair_stack& stack, Both_trees& trees, const Certifying& units, const Bvh8& a, const Bvh8& b,
               const Leaf_pair& leaf_pair)
  {
    const std::size_t known = entries_.count();
    bool meet = false;
    for (Stop stop; !meet && (stop = descend_certified(stack, trees, units)) != Stop::nothing_left;) {
      const Boxes boxes{stack.box(0), stack.box(1)};
      if (stop == Stop::no_child) {
        const int larger = first_is_larger(stack.size(0), stack.size(1)) ? 0 : 1;
        const Index box = larger == 0 ? boxes.first : boxes.second;
        (larger == 0 ? a : b).child(box / 8, int(box % 8));
        continue;
      }
      stack.pop();
      ++leaf_pairs_;
      const Leaf_gap found = leaf_pair(boxes.first, boxes.second);
      meet = found.meet;
      if (meet) witness = boxes;
      const std::uint8_t lanes = certify(trees, units, boxes.second, found, entries_.next());
      entries_.add({boxes.first, boxes.second, Front_entry::Kind::pair, lanes}, meet ? 0 : found.gap);
    }
    for (std::size_t k = known; k < entries_.count(); ++k) least_gap_ = kernel::minimum(least_gap_, entries_.gap(k));
    if (meet) keep_rest(stack);
    return meet;
  }

  /// What is left on the stack when elements meet, to be opened the next time.
  void keep_rest(Pair_stack& stack)
  {
    for (; !stack.empty(); stack.pop()) entries_.add({stack.box(0), stack.box(1), Front_entry::Kind::pair}, 0);
  }

  bool holds_ = false, is_plane_first_ = true;
  Front_entries entries_;
  std::vector<std::uint32_t> expired_;
  kernel::Body_box box_;   // of B
  kernel::Placement at_;   // of B, when the front was last brought to a pose
  kernel::Course course_;  // of B
  std::size_t poses_followed_ = 0;
  double least_gap_ = 0;  // of what was asked in this pose
  std::uint64_t leaf_pairs_ = 0;
  Front_policy policy_;
};

}  // namespace tetracone::tetratree

#endif
