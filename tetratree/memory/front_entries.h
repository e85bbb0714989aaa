#ifndef TETRACONE_TETRATREE_MEMORY_FRONT_ENTRIES_H
#define TETRACONE_TETRATREE_MEMORY_FRONT_ENTRIES_H

#include "tetracone/kernel/bound/obb8_gap.h"
#include "tetracone/kernel/bound/relative_motion.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/simd/simd.h"
#include "tetracone/tetratree/fast/bvh8_descent.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetracone::tetratree {

/// An entry of a front: lanes of a node that are apart from a box of the other body, or a pair of boxes.
struct Front_entry {
  enum class Kind : std::uint8_t { node_of_a, node_of_b, pair };

  Box_id first;   ///< the node's first box, or A's box
  Box_id second;  ///< the other body's box, or B's
  Kind kind;
  std::uint8_t lanes = 0;  ///< the certified ones, as bits: lanes of the node; for a pair 1, or 0 if it has no
                           ///< certificate

  /// Returns the body whose box is carried to the node, or to A's box.
  int carried_body() const { return kind == Kind::node_of_b ? 0 : 1; }
};

/// The gaps and axes by which an entry's lanes are apart from the box that is carried to them. Units are the local
/// units of the body that it is carried to.
struct Certificate {
  kernel::Certified_gaps gaps;
  kernel::Carried_box carried;
  kernel::Going_box going;  ///< B's box: the carried one, or one that holds the lanes' elements
};

/// The entries of a front, each with its remaining gap.
///
/// Bodies move in steps along a course and stray from it. Since its gap was found, an entry has lost its own rate times
/// the number of steps, plus the stray. It expires when nothing is left, and is then asked again. An entry without a
/// rate of its own uses the pace, an upper bound of the distance that any point moves in a step.
class Front_entries {
 public:
  /// Limit of the motion and stray since the course was set, in local units: floats are too coarse beyond it.
  static constexpr double most_gone = 1;

  /// A stored gap is multiplied by this, which covers the roundings in float of `expired` and `set_course`. Proved in
  /// verify/proofs/reference_proofs.h.
  static constexpr float shrink = 1 - 0x1p-20f;

  /// The stored value of an entry that is asked in the next pose, however bodies move.
  static constexpr float at_once = -1;

  /// Moves by `steps`, a multiple of `Course::least_step`, and adds to the stray. Requires both to be at least 0.
  void go_on(double steps, double strayed)
  {
    steps_before_ = steps_;
    strayed_before_ = strayed_;
    steps_ += steps;
    strayed_ = (strayed_ + strayed) * (1 + kernel::few_roundings);
  }

  /// Returns an upper bound of the distance that any point of B moves in a step of the course.
  double pace() const { return double(pace_); }

  /// True when a new course is needed: motion and stray on this one are too large for floats.
  bool has_gone_far() const { return !(gone_by(double(pace_)) <= most_gone && steps_ <= kernel::Course::most_steps); }

  /// Sets a new course of the given pace. It stores each remaining gap, and gives all entries the pace as their
  /// rate. Requires finite motion since the last course was set.
  void set_course(double pace)
  {
    const float steps = float(steps_), strayed = strayed_as_float();
    for (std::size_t k = 0; k < count_; ++k) {
      const float left = until_[k] - (rate_[k] * steps + strayed);
      until_[k] = left > 0x1p-60f ? left * shrink : at_once;
    }
    pace_ = float(pace) * kernel::rounded_up;
    for (std::size_t k = 0; k < count_; ++k) rate_[k] = pace_;
    steps_ = strayed_ = 0;
  }

  /// Returns a lower bound of the remaining gap; not above 0 if it is used up.
  double gap(std::size_t k) const { return double(until_[k]) - gone_by(double(rate_[k])); }

  /// Returns a lower bound of the remaining gap before the last `go_on`.
  double gap_before(std::size_t k) const
  {
    return double(until_[k]) - (double(rate_[k]) * steps_before_ + strayed_before_);
  }

  /// Sets the remaining gap now, in A's local units, and its loss per step. Without a rate, that is the pace.
  void set_gap(std::size_t k, double gap, double rate)
  {
    rate_[k] = float(rate) * kernel::rounded_up;
    // The sum is positive. `shrink` covers its rounding and those in `expired` and `set_course`, 4 in all. A gap below
    // the limit would be a denormal float.
    const float untils[2] = {at_once, float((gap + gone_by(double(rate_[k]))) * double(shrink))};
    until_[k] = untils[gap > 0x1p-60];
  }
  void set_gap(std::size_t k, double gap) { set_gap(k, gap, double(pace_)); }

  std::size_t count() const { return count_; }
  Front_entry& operator[](std::size_t k) { return entries_[k]; }
  const Front_entry& operator[](std::size_t k) const { return entries_[k]; }
  Certificate& certificate(std::size_t k) { return certificates_[k]; }
  const Certificate& certificate(std::size_t k) const { return certificates_[k]; }

  /// Return the arrays and sums that `expired` reads.
  const float* until() const { return until_.data(); }
  const float* rates() const { return rate_.data(); }
  float steps() const { return float(steps_); }
  float strayed_as_float() const { return float(strayed_) * kernel::rounded_up; }

  /// Removes all entries and the course.
  void clear()
  {
    count_ = 0;
    steps_ = strayed_ = 0;
    pace_ = 0;
  }

  /// Prefetches the certificate of an entry that is asked soon.
  void prefetch(std::size_t k) const
  {
    const auto* const bytes = reinterpret_cast<const char*>(&certificates_[k]);
    for (std::size_t at = 0; at < sizeof(Certificate); at += 64) __builtin_prefetch(bytes + at);
  }

  /// Returns room for the next entry's certificate; `add` then adds that entry.
  Certificate& next()
  {
    if (count_ == entries_.size()) {
      const std::size_t room = 2 * count_ + 32;
      entries_.resize(room);
      until_.resize(room);
      rate_.resize(room);
      certificates_.resize(room);
    }
    return certificates_[count_];
  }
  /// Adds an entry with its remaining gap, and the pace as its rate.
  void add(const Front_entry& entry, double gap)
  {
    next();
    entries_[count_] = entry;
    set_gap(count_, gap);
    ++count_;
  }

  /// Removes entry k; the last entry takes its number.
  void remove(std::size_t k)
  {
    --count_;
    entries_[k] = entries_[count_];
    until_[k] = until_[count_];
    rate_[k] = rate_[count_];
    certificates_[k] = certificates_[count_];
  }

  std::size_t bytes() const
  {
    return entries_.capacity() * sizeof(Front_entry) + (until_.capacity() + rate_.capacity()) * sizeof(float) +
           certificates_.capacity() * sizeof(Certificate);
  }

 private:
  double gone_by(double rate) const { return rate * steps_ + strayed_; }

  std::size_t count_ = 0;
  double steps_ = 0, strayed_ = 0;                // since the course was set
  double steps_before_ = 0, strayed_before_ = 0;  // before the last `go_on`
  float pace_ = 0;
  std::vector<Front_entry> entries_;
  std::vector<float> until_,
      rate_;  // an entry holds while until > rate * steps + strayed
  std::vector<Certificate> certificates_;
};

/// The context of a certified descent, which writes the front.
struct Certifying {
  kernel::Carrier carrier[2];  ///< carries boxes of body k into the other's frame, B on its course
  double to_a[2];              ///< lower bounds of the least stretch from a body's local units to A's
  Front_entries* entries;
};

}  // namespace tetracone::tetratree

#define TETRACONE_SIMD_FILE "tetracone/tetratree/memory/front_entries_simd.inl"
#include "tetracone/kernel/simd/simd_rounds.h"

namespace tetracone::tetratree {

/// Writes the numbers of the expired entries to `found`, in order, and returns their count. Requires room in `found`
/// for 8 more than all entries.
inline std::size_t expired(const Front_entries& entries, std::uint32_t* found)
{
  static auto* const fastest = TETRACONE_SIMD_FASTEST(expired_simd);
  return fastest(entries, found);
}

/// Descends as `descend` does, and writes everything that is found apart to the front. Requires similarities.
inline Stop descend_certified(Pair_stack& stack, Both_trees& trees, const Certifying& certifying)
{
  static auto* const fastest = TETRACONE_SIMD_FASTEST(descend_certified_simd);
  return fastest(stack, trees, certifying);
}

/// Tests the entries whose numbers are in `asked` along the axes of their certificates. An entry stays if all its lanes
/// are apart: it gets its present gap and a rate of its own. Leaves the other numbers in `asked`, in order, and returns
/// their count. Lowers `least` to the least gap.
inline std::size_t keep_by_axes(const Certifying& certifying, std::uint32_t* asked, std::size_t count, double& least)
{
  static auto* const fastest = TETRACONE_SIMD_FASTEST(keep_by_axes_simd);
  return fastest(certifying, asked, count, least);
}

/// Asks the node entries of `asked` again. Lanes that are no longer apart are pushed to the stack. The others are
/// certified anew, and an entry may be left without lanes. Lowers `least` to the least gap.
inline void open_again(Pair_stack& stack, Both_trees& trees, const Certifying& certifying, const std::uint32_t* asked,
                       std::size_t count, double& least)
{
  static auto* const fastest = TETRACONE_SIMD_FASTEST(open_again_simd);
  fastest(stack, trees, certifying, asked, count, least);
}

}  // namespace tetracone::tetratree

#endif
