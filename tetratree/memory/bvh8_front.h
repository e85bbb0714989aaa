#ifndef TETRACONE_TETRATREE_MEMORY_BVH8_FRONT_H
#define TETRACONE_TETRATREE_MEMORY_BVH8_FRONT_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/bound/relative_motion.h"
#include "tetracone/kernel/bound/triangle_distance.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/predicate/question.h"
#include "tetracone/tetratree/fast/bvh8.h"
#include "tetracone/tetratree/fast/bvh8_descent.h"
#include "tetracone/tetratree/memory/front_entries.h"
#include "tetracone/tetratree/memory/front_policy.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace tetracone::tetratree {

/// The front of the last descent of a pair of bodies, with certificates. It changes speed, never an answer.
///
/// The front covers all pairs of elements. An entry is a pair of leaves or of boxes still to be opened. It may also be
/// some lanes of a node and a box of the other body. It has a lower bound of their gap. Gaps and motions are in A's
/// local units; A rests.
///
/// Bodies mostly go on as they went. So the step between two poses gives B a course (`kernel::Course`), and later
/// motions are taken as multiples of that step. The stray is an upper bound of the distance between a point and its
/// place by the course.
///
/// A step takes at most the entry's rate off a gap along an axis fixed to A, and at most the pace off any distance. The
/// stray takes more. An entry holds until these have used up its gap (`Front_entries`). Then only that entry is tested
/// again, and if it is no longer apart, the descent goes on from there. A large stray sets B on a new course.
///
/// Related work:
/// - Klosowski et al., "Efficient collision detection using bounding volume hierarchies of k-DOPs" (1998): generalised
///   front tracking, which has no gaps.
/// - Mirtich's conservative advancement, which has no front.
/// - Basch, Guibas and Hershberger, "Data structures for mobile data" (1999): certificates that require a course that
///   is given and followed exactly.
///
/// Motions are bounded by B's maps at the last pose and at this one alone (`kernel::stray_bound`), with their errors.
/// If a map's error is unknown or above `most_error`, or a map is no similarity, nothing is certified and each descent
/// begins at the root. Descents also begin there when steps are so large that the front does not pay (`Front_policy`).
///
/// A front belongs to one pair of placed bodies, whichever query object uses it. Pairs of the same two trees, in the
/// same order, may share a query object and keep a front each. A front is not for two threads at a time.
class Bvh8_front {
 public:
  /// The result for a pair of leaves. Either elements meet, or `gap` is a lower bound of the distance of any two, in
  /// A's local units; 0 if unknown. `axis` is the direction of the gap, of length 1, from A's to B's; 0 if several
  /// directions were used.
  struct Leaf_gap {
    bool meet = false;
    double gap = 0;
    kernel::Double_vector axis{};
  };

  /// True when there is a front.
  bool holds() const { return holds_; }
  /// Returns the entries, for tests.
  const Front_entries& entries() const { return entries_; }

  /// Returns a lower bound of the gap of an entry, in A's local units, in the last pose that was asked. It is not above
  /// 0 if nothing is known. It serves tests.
  double gap(std::size_t k) const { return entries_.gap(k); }

  /// Returns the number of poses since the front was made, for tests.
  std::size_t poses_followed() const { return poses_followed_; }

  std::size_t bytes() const { return entries_.bytes() + expired_.capacity() * sizeof(std::uint32_t); }

  // For the query.

  /// The relation of solids whose surfaces shared no point, unless one surface may have passed the other since.
  std::optional<kernel::Relation> relation;

  /// True when gaps can be certified under these maps: both are similarities, with errors of at most `most_error` of
  /// their scale.
  static bool is_certifiable(const Both_trees& trees)
  {
    for (const kernel::Box_map* map : trees.into)
      if (!map->is_similarity() || !(map->frame().error() <= most_error * map->scale())) return false;
    return true;
  }
  /// Upper bound of the error of a certifiable map, as a fraction of its scale.
  static constexpr double most_error = 0x1p-26;

  /// Upper bound of the relative difference by which the least stretch of B's exact map is below the length of its
  /// first computed column. The map is a similarity except for `Relative_frame::similarity_defect`, and the error of a
  /// column is below `most_error`. Proved in verify/proofs/reference_proofs.h.
  static constexpr double stretch_loss = 0x1p-20;

  /// Upper bound of the relative error of a leaf gap in float, the rounded length of its axis included. Proved in
  /// verify/proofs/reference_proofs.h.
  static constexpr double leaf_gap_rounding = 0x1p-20;

  /// B keeps its course while stray <= most_strayed * motion along the course + most_at_rest.
  static constexpr double most_strayed = 0.25,  ///< a fraction of the motion
      most_at_rest = 0x1p-30;                   ///< the stray that bodies at rest may show, in local units

  /// True when the next descent from the root is to make a front. Ask once a descent: each false answer shortens the
  /// policy's pause.
  bool is_to_be_made() { return policy_.makes_front(); }

  /// Makes a front by a descent from the root. leaf_gap(boxes) returns the Leaf_gap of a pair of leaves. True when
  /// elements meet. Requires `is_certifiable`. `stack` is scratch memory.
  template <class Gap>
  bool make(Pair_stack& stack, Both_trees& trees, const Bvh8& a, const Bvh8& b, const Gap& leaf_gap)
  {
    entries_.clear();
    corners_ = kernel::Box_corners(b.node(0).boxes, 0);
    at_ = kernel::Placement(*trees.into[1]);
    course_ = {};
    poses_followed_ = 0;
    holds_ = true;
    leaf_pairs_ = 0;
    relation.reset();
    stack.clear();
    push(stack, trees, {});
    const std::uint64_t before = trees.opened;
    const bool meet = descend(stack, trees, certifying(trees), a, b, leaf_gap);
    policy_.made(cost(double(trees.opened - before)));
    return meet;
  }

  /// Brings the front to the present pose. True when elements meet; nothing when the front has been given up. Requires
  /// `holds`, and arguments as `make`.
  template <class Gap>
  std::optional<bool> follow(Pair_stack& stack, Both_trees& trees, const Bvh8& a, const Bvh8& b, const Gap& leaf_gap)
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
    // Backwards: a removed entry is replaced by the last one.
    open_again(stack, trees, units, expired_.data(), count, least_gap_);
    bool meet = false;
    for (std::size_t k = count; k-- > 0 && !meet;) meet = ask_again(stack, trees, units, expired_[k], leaf_gap);
    if (meet)
      keep_rest(stack);
    else
      meet = descend(stack, trees, units, a, b, leaf_gap);
    policy_.followed(cost(Front_policy::of_certified * double(trees.opened - opened)) +
                     Front_policy::of_check * double(checked));
    // Consider the straight path from the last pose, t = 0, to this one, t = 1. An entry that was asked again is apart
    // while t step < left, by its old gap, and while (1 - t) step < its new gap. If left + least_gap_ > step, one of
    // these holds at every t. Then no surface has passed another: a shell that was inside is inside, and one outside is
    // outside.
    if (meet || !(left + least_gap_ > *step)) relation.reset();
    return meet;
  }

 private:
  /// Moves B to its present pose: along its course if that predicts most of the motion, else on a new course. Returns
  /// an upper bound of the distance that any point of B has moved; nothing if that is unknown or too large.
  std::optional<double> go_on(const Both_trees& trees)
  {
    const kernel::Placement now(*trees.into[1]);
    double steps = kernel::steps_along(course_, at_, now),
           strayed = kernel::stray_bound(course_, steps, at_, now, corners_);
    if (!(strayed <= most_strayed * (steps * entries_.pace()) + most_at_rest) || entries_.has_gone_far()) {
      course_ = kernel::Course(at_, now);
      entries_.set_course(kernel::pace_bound(course_, corners_));
      steps = 1;
      strayed = kernel::stray_bound(course_, steps, at_, now, corners_);
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

  /// Returns the cost of openings and of the pairs of leaves, in openings.
  double cost(double opened) const { return opened + Front_policy::of_elements * double(leaf_pairs_); }

  /// Returns the context of a certified descent. It multiplies gaps in either body's units by lower bounds of the
  /// stretch into A's local units.
  Certifying certifying(const Both_trees& trees)
  {
    const kernel::Placement of_a(*trees.into[0]);
    return {{{*trees.into[0], of_a, course_.reversed(of_a)}, {*trees.into[1], at_, course_}},
            {1, at_.scale * (1 - stretch_loss)},
            &entries_};
  }

  static void push(Pair_stack& stack, const Both_trees& trees, const Box_ids& boxes)
  {
    stack.push(boxes, trees.size(0, boxes[0]), trees.size(1, boxes[1]));
  }

  /// Records the new gap of an entry that was asked in this pose.
  void renew(std::size_t k, double gap)
  {
    entries_.set_gap(k, gap);
    least_gap_ = kernel::minimum(least_gap_, gap);
  }

  /// Asks an expired entry again. An entry without lanes is removed; a pair of leaves is tested; another pair of boxes
  /// goes onto the stack to be opened. True when elements meet.
  template <class Gap>
  bool ask_again(Pair_stack& stack, const Both_trees& trees, const Certifying& units, std::size_t k,
                 const Gap& leaf_gap)
  {
    Front_entry& entry = entries_[k];
    if (entry.kind != Front_entry::Kind::pair) {
      if (entry.lanes == 0) entries_.remove(k);
      return false;
    }
    const Box_ids boxes{entry.first, entry.second};
    const auto is_leaf = [&](int body, Box_id box) { return trees.node_of(body, box).is_leaf(box.lane()); };
    if (!is_leaf(0, boxes[0]) || !is_leaf(1, boxes[1])) {
      push(stack, trees, boxes);
      entries_.remove(k);
      return false;
    }
    ++leaf_pairs_;
    const Leaf_gap found = leaf_gap(boxes);
    entry.lanes = certify(trees, units, entry.second, found, entries_.certificate(k));
    renew(k, found.meet ? 0 : found.gap);
    return found.meet;
  }

  /// Writes the certificate of a pair of leaves. Returns its lanes.
  static std::uint8_t certify(const Both_trees& trees, const Certifying& units, Box_id box_b, const Leaf_gap& found,
                              Certificate& certificate)
  {
    if (!(found.gap > 0) || found.axis == kernel::Double_vector{}) return 0;
    certificate.gaps.gap[0] = float(found.gap * (1 - leaf_gap_rounding));
    for (int k = 0; k < 3; ++k) certificate.gaps.axis[k][0] = float(found.axis[k]);
    const kernel::Obb8& boxes = trees.node_of(1, box_b).boxes;
    kernel::carry_now(units.carrier[1], boxes, box_b.lane(), certificate.carried);
    certificate.going = kernel::Going_box(boxes, box_b.lane());
    return 1;
  }

  /// Opens the pairs on the stack, until elements meet. True when they do.
  template <class Gap>
  bool descend(Pair_stack& stack, Both_trees& trees, const Certifying& units, const Bvh8& a, const Bvh8& b,
               const Gap& leaf_gap)
  {
    const std::size_t known = entries_.count();
    bool meet = false;
    for (Stop stop; !meet && (stop = descend_certified(stack, trees, units)) != Stop::nothing_left;) {
      const Box_ids boxes = stack.boxes();
      if (stop == Stop::no_child) {
        const int larger = stack.larger_body();
        (larger == 0 ? a : b).child(boxes[std::size_t(larger)]);
        continue;
      }
      stack.pop();
      ++leaf_pairs_;
      const Leaf_gap found = leaf_gap(boxes);
      meet = found.meet;
      const std::uint8_t lanes = certify(trees, units, boxes[1], found, entries_.next());
      entries_.add({boxes[0], boxes[1], Front_entry::Kind::pair, lanes}, meet ? 0 : found.gap);
    }
    for (std::size_t k = known; k < entries_.count(); ++k) least_gap_ = kernel::minimum(least_gap_, entries_.gap(k));
    if (meet) keep_rest(stack);
    return meet;
  }

  /// Adds the pairs left on the stack to the front when elements meet, to be opened in the next pose.
  void keep_rest(Pair_stack& stack)
  {
    for (; !stack.empty(); stack.pop()) entries_.add({stack.box(0), stack.box(1), Front_entry::Kind::pair}, 0);
  }

  bool holds_ = false;
  Front_policy policy_;
  std::uint64_t leaf_pairs_ = 0;
  std::size_t poses_followed_ = 0;
  double least_gap_ = 0;  // over the entries asked in this pose
  Front_entries entries_;
  std::vector<std::uint32_t> expired_;
  kernel::Box_corners corners_;  // of B's box
  kernel::Placement at_;         // B's, when the front was last brought to a pose
  kernel::Course course_;        // B's
};

}  // namespace tetracone::tetratree

#endif
