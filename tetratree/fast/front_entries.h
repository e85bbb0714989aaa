#ifndef TETRACONE_TETRATREE_FAST_FRONT_ENTRIES_H
#define TETRACONE_TETRATREE_FAST_FRONT_ENTRIES_H

#include "tetracone/kernel/bound/obb8_gap.h"
#include "tetracone/kernel/bound/relative_motion.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/simd/simd.h"
#include "tetracone/tetratree/fast/bvh8_descent.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetracone::tetratree {

/// A part of the front of a descent: parts of a node that are apart from a box of the other body; or a pair of boxes.
struct Front_entry {
  enum class Kind : std::uint8_t { node_of_a, node_of_b, pair };

  std::uint32_t first;   ///< the node, or A's box
  std::uint32_t second;  ///< the other body's box, or B's
  Kind kind;
  std::uint8_t lanes = 0;  ///< of the certificate, as bits: the node's that are apart; of a pair 1, or 0: none

  /// Whose box is carried to the node, or to A's box.
  int carried_body() const { return kind == Kind::node_of_b ? 0 : 1; }
};

/// By how much, and along which axes, the lanes of an entry are apart from the box that is carried to them, in the local
/// units of the body that it is carried to.
struct Certificate {
  kernel::Certified_gaps gaps;
  kernel::Carried_box carried;
  kernel::Going_box going;  ///< B's: the carried box, or one that holds the lanes' elements
};

/// The front's parts, each with how much of its gap is left.
///
/// Bodies are on a course, step by step, and stray from it: so an entry loses of its gap its own rate times the steps
/// since, and what bodies have strayed since. It holds as long as something is left; then it is to be asked again.
/// Of an entry that has no rate of its own, it is the pace: as far as a point may go in a step, in whatever direction.
class Front_entries {
 public:
  /// Beyond that, floats tell what bodies have gone and strayed too coarsely, in local units.
  static constexpr double most_gone = 1;

  /// What is left of a gap where it is stored: less than it by more than four roundings in float take.
  static constexpr float shrink = 1 - 0x1p-20f;

  /// Of what is to be asked the next time, whatever moves.
  static constexpr float at_once = -1;

  /// Goes on, by a multiple of `Course::least_step`. Requires both to be no less than 0.
  void go_on(double steps, double strayed)
  {
    steps_before_ = steps_;
    strayed_before_ = strayed_;
    steps_ += steps;
    strayed_ = (strayed_ + strayed) * (1 + kernel::few_roundings);
  }

  double pace() const { return double(pace_); }

  /// Whether a new course is to be set, since bodies have gone or strayed too far on this one.
  bool has_gone_far() const { return !(gone_by(double(pace_)) <= most_gone && steps_ <= kernel::Course::most_steps); }

  /// Sets a new course, whose pace is given: what is left of gaps is taken down, and all entries have no rate of their
  /// own. Requires `gone` to be finite.
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

  /// At most what is left of a gap; not above 0 where that is nothing.
  double gap(std::size_t k) const { return double(until_[k]) - gone_by(double(rate_[k])); }

  /// Before they last went on.
  double gap_before(std::size_t k) const
  {
    return double(until_[k]) - (double(rate_[k]) * steps_before_ + strayed_before_);
  }

  /// So much is left of a gap now, in A's local units, and it loses so much in a step.
  void set_gap(std::size_t k, double gap, double rate)
  {
    rate_[k] = float(rate) * kernel::rounded_up;
    // Of a positive sum: more than what is lost by rounding it, and in `expired` and `set_course`, 4 roundings. Below
    // that the float would be a denormal.
    const float untils[2] = {at_once, float((gap + gone_by(double(rate_[k]))) * double(shrink))};
    until_[k] = untils[gap > 0x1p-60];
  }
  void set_gap(std::size_t k, double gap) { set_gap(k, gap, double(pace_)); }

  std::size_t count() const { return count_; }
  Front_entry& operator[](std::size_t k) { return entries_[k]; }
  const Front_entry& operator[](std::size_t k) const { return entries_[k]; }
  Certificate& certificate(std::size_t k) { return certificates_[k]; }
  const Certificate& certificate(std::size_t k) const { return certificates_[k]; }

  /// For `expired`.
  const float* until() const { return until_.data(); }
  const float* rates() const { return rate_.data(); }
  float steps() const { return float(steps_); }
  float strayed_as_float() const { return float(strayed_) * kernel::rounded_up; }

  /// None, and bodies that are on no course.
  void clear()
  {
    count_ = 0;
    steps_ = strayed_ = 0;
    pace_ = 0;
  }

  /// The certificate of an entry that is asked soon.
  void prefetch(std::size_t k) const
  {
    const auto* const bytes = reinterpret_cast<const char*>(&certificates_[k]);
    for (std::size_t at = 0; at < sizeof(Certificate); at += 64) __builtin_prefetch(bytes + at);
  }

  /// Where the certificate of the next entry belongs, and then the entry itself.
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
  void add(const Front_entry& entry, double gap)
  {
    next();
    entries_[count_] = entry;
    set_gap(count_, gap);
    ++count_;
  }

  /// The last one takes its place.
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
  double steps_before_ = 0, strayed_before_ = 0;  // before bodies last went on
  float pace_ = 0;
  std::vector<Front_entry> entries_;
  std::vector<float> until_,
      rate_;  // more than the rate times the steps, and what was strayed, while something is left
  std::vector<Certificate> certificates_;
};

/// Where certified descents write the front.
struct Certifying {
  kernel::Carrier carrier[2];  ///< of body k into the other's frame, B on its course
  double to_a[2];              ///< at most the least stretch from a body's local units to A's
  Front_entries* entries;
};

}  // namespace tetracone::tetratree

#define TETRACONE_SIMD_FILE "tetracone/tetratree/fast/front_entries_simd.inl"
#include "tetracone/kernel/simd/simd_rounds.h"

namespace tetracone::tetratree {

/// Writes the numbers of the entries that have nothing left of their gap, in order, to `found`, which has room for 8 more
/// than there are entries; returns how many.
inline std::size_t expired(const Front_entries& entries, std::uint32_t* found)
{
  using Function = std::size_t(const Front_entries&, std::uint32_t*);
  static Function* const fastest = kernel::fastest_version<Function>(TETRACONE_SIMD_VERSIONS(expired_simd));
  return fastest(entries, found);
}

/// As `descend`, of bodies whose maps are similarities, with everything that is found apart written to the front.
inline Stop descend_certified(Pair_stack& stack, Both_trees& trees, const Certifying& certifying)
{
  using Function = Stop(Pair_stack&, Both_trees&, const Certifying&);
  static Function* const fastest = kernel::fastest_version<Function>(TETRACONE_SIMD_VERSIONS(descend_certified_simd));
  return fastest(stack, trees, certifying);
}

/// Of entries of the numbers in `asked`, those whose axes tell all their lanes apart stay in the front, with what is left
/// of their gaps now and rates of their own; the others are left in `asked`, in order. Returns how many; takes the least
/// gap into `least`.
inline std::size_t keep_by_axes(const Certifying& certifying, std::uint32_t* asked, std::size_t count, double& least)
{
  using Function = std::size_t(const Certifying&, std::uint32_t*, std::size_t, double&);
  static Function* const fastest = kernel::fastest_version<Function>(TETRACONE_SIMD_VERSIONS(keep_by_axes_simd));
  return fastest(certifying, asked, count, least);
}

/// Asks the entries of the numbers in `asked` again that are of nodes: lanes that are no longer apart are pushed, and
/// what is certified of the others takes their place; an entry may have no lanes then. Takes the least gap into `least`.
inline void open_again(Pair_stack& stack, Both_trees& trees, const Certifying& certifying, const std::uint32_t* asked,
                       std::size_t count, double& least)
{
  using Function = void(Pair_stack&, Both_trees&, const Certifying&, const std::uint32_t*, std::size_t, double&);
  static Function* const fastest = kernel::fastest_version<Function>(TETRACONE_SIMD_VERSIONS(open_again_simd));
  fastest(stack, trees, certifying, asked, count, least);
}

}  // namespace tetracone::tetratree

#endif
