#ifndef TETRACONE_TETRATREE_FAST_FRONT_ENTRIES_H
#define TETRACONE_TETRATREE_FAST_FRONT_ENTRIES_H

#include "tetracone/kernel/bound/obb8_gap.h"
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
};

/// The front's parts, each with how far the bodies may have moved, in whatever direction, until it is to be asked again.
class Front_entries {
 public:
  /// Beyond that, floats tell sums of movements in local units too coarsely.
  static constexpr double most_moved = 64;

  /// Of what is to be asked the next time, whatever moves.
  static constexpr float at_once = -1;

  /// A float above `as_float(moved)` only where moved < moved_then + gap. Requires moved_then >= 0.
  static float until(double moved_then, double gap)
  {
    // Of a positive sum, rounded to nearest twice; below that the float would be a denormal.
    return gap > 0x1p-60 ? float((moved_then + gap) * (1 - 0x1p-22)) : at_once;
  }
  static float as_float(double moved) { return float(moved * (1 + 0x1p-22)); }

  std::size_t count() const { return count_; }
  Front_entry& operator[](std::size_t k) { return entries_[k]; }
  const Front_entry& operator[](std::size_t k) const { return entries_[k]; }
  Certificate& certificate(std::size_t k) { return certificates_[k]; }
  const Certificate& certificate(std::size_t k) const { return certificates_[k]; }
  float until(std::size_t k) const { return until_[k]; }
  const float* all_until() const { return until_.data(); }
  void set_until(std::size_t k, float until) { until_[k] = until; }

  void clear() { count_ = 0; }

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
      certificates_.resize(room);
    }
    return certificates_[count_];
  }
  void add(const Front_entry& entry, float until)
  {
    next();
    entries_[count_] = entry;
    until_[count_] = until;
    ++count_;
  }

  /// The last one takes its place.
  void remove(std::size_t k)
  {
    --count_;
    entries_[k] = entries_[count_];
    until_[k] = until_[count_];
    certificates_[k] = certificates_[count_];
  }

  std::size_t bytes() const
  {
    return entries_.capacity() * sizeof(Front_entry) + until_.capacity() * sizeof(float) +
           certificates_.capacity() * sizeof(Certificate);
  }

 private:
  std::size_t count_ = 0;
  std::vector<Front_entry> entries_;
  std::vector<float> until_;
  std::vector<Certificate> certificates_;
};

/// Where certified descents write the front.
struct Certifying {
  Front_entries* entries;
  double moved;      ///< so far
  double turned[2];  ///< so far, by the map of body k into the other's frame
  double to_a[2];    ///< at most the least stretch from a body's local units to A's
};

}  // namespace tetracone::tetratree

#define TETRACONE_SIMD_FILE "tetracone/tetratree/fast/front_entries_simd.inl"
#include "tetracone/kernel/simd/simd_rounds.h"

namespace tetracone::tetratree {

/// Writes the numbers of the first `count` entries that are to be asked when so much has moved, in order, to `found`,
/// which has room for 8 more; returns how many.
inline std::size_t expired(const float* until, std::size_t count, float moved, std::uint32_t* found)
{
  using Function = std::size_t(const float*, std::size_t, float, std::uint32_t*);
  static Function* const fastest = kernel::fastest_version<Function>(TETRACONE_SIMD_VERSIONS(expired_simd));
  return fastest(until, count, moved, found);
}

/// As `descend`, of bodies whose maps are similarities, with everything that is found apart written to the front.
inline Stop descend_certified(Pair_stack& stack, Both_trees& trees, const Certifying& certifying)
{
  using Function = Stop(Pair_stack&, Both_trees&, const Certifying&);
  static Function* const fastest = kernel::fastest_version<Function>(TETRACONE_SIMD_VERSIONS(descend_certified_simd));
  return fastest(stack, trees, certifying);
}

/// Of entries of the numbers in `asked`, those whose axes tell all their lanes apart stay in the front, until what their
/// gaps are worth now; the others are left in `asked`, in order. Returns how many; takes the least gap into `least`.
inline std::size_t keep_by_axes(const Both_trees& trees, const Certifying& certifying, std::uint32_t* asked,
                                std::size_t count, double& least)
{
  using Function = std::size_t(const Both_trees&, const Certifying&, std::uint32_t*, std::size_t, double&);
  static Function* const fastest = kernel::fastest_version<Function>(TETRACONE_SIMD_VERSIONS(keep_by_axes_simd));
  return fastest(trees, certifying, asked, count, least);
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
