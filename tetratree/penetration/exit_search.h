#ifndef TETRACONE_TETRATREE_PENETRATION_EXIT_SEARCH_H
#define TETRACONE_TETRATREE_PENETRATION_EXIT_SEARCH_H

#include "tetracone/kernel/bound/view_box.h"
#include "tetracone/kernel/contact/shift_range.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/tetratree/penetration/heap.h"
#include "tetracone/tetratree/penetration/seen_solid.h"
#include "tetracone/tetratree/query_statistics.h"

#include <CGAL/gmpxx.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// How far a solid must rise to leave another one, as heights in a view.
struct Exit_heights {
  kernel::Rational first;  ///< the least rise at which the interiors share no point
  kernel::Rational last;   ///< the least rise from which on they share none
};

/// The rises of A, along z of a view, at which the interiors of A and B share a point.
///
/// Let F be the set of these rises s. Pieces are the parts of faces that `Seen_solid` makes.
///
/// 1. An upright line through no edge of either body meets each solid in intervals between pieces. Intervals of A from
///    a0 to a1 and of B from b0 to b1 overlap for s from b0 - a1 to b1 - a0. F is the union of these open intervals
///    over all such lines, since interiors are open.
/// 2. An upper end of a part of F is the largest b1 - a0 over the lines that two pieces share. That is `high` of their
///    `Shift_range`. The last exit is the largest `high` of all pairs. No pair has a larger one, since every piece is a
///    side of an interval.
/// 3. For s between `low` and `high` of two pieces whose planes are not parallel, A's piece goes through B's. Each has
///    its solid on some side, so the interiors share a point: F has all these s.
///
/// The first exit is found by going up. Rounded ends come first: where a pair is surely met below the rise that is
/// reached, F goes on to its `high`. If that meets the range of the pair that leaves last, both exits are one.
/// Otherwise an exact step is made, and rounded ends go on from there. The step leads to the largest `high` of a
/// pair that has the rise between its ends. If there is no such pair, the relation of the solids at that rise decides,
/// and the step leads to the least `high` above it.
///
/// One object serves many views of two bodies, and one thread.
class Exit_search {
 public:
  /// A and B.
  Exit_search(Seen_solid a, Seen_solid b) : solid_{std::move(a), std::move(b)} {}

  /// Returns the exits. `map_a` and `map_b` lead from the bodies' coordinates into the view. meet(s) tells whether the
  /// interiors share a point when A has risen by s. Requires that they do at 0, or that a solid has no inside.
  template <class Meet>
  Exit_heights operator()(const std::array<kernel::Rational, 12>& map_a, const std::array<kernel::Rational, 12>& map_b,
                          const Meet& meet)
  {
    solid_[0].see(map_a);
    solid_[1].see(map_b);
    last_pair_ = {};
    const std::optional<Rational> highest = largest_high(nullptr);
    if (!highest) return {0, 0};  // a solid without volume has no inside
    const Rational& last = *highest;
    const auto pair_of_last = last_pair_;
    const double goal = start_of_last();
    if (goal < 0) return {last, last};
    last_pair_ = {};
    kernel::Rational at = 0;
    for (bool is_in = true; at < last; is_in = false) {
      // F has all rises below `at`. So the climb may begin a little lower, at a double.
      if (std::optional<Met> reached = climb(CGAL::to_interval(at).first, goal)) {
        if (reached->high.least > goal) {
          last_pair_ = pair_of_last;
          last_high_ = last;
          return {last, last};
        }
        Candidate pair{reached->a, reached->b, reached->high.least, reached->high.most, std::nullopt};
        if (const Rational& high = exact_high(pair); high > at) {
          at = high;
          note(pair);
          is_in = false;
          if (at == last) break;
        }
      }
      if (auto high = largest_high(&at)) {
        at = std::move(*high);
        continue;
      }
      if (!is_in && !meet(at)) break;
      at = least_high_above(at);
    }
    return {at, last};
  }

  /// Rises from one to another, and two faces that go through one another at all rises between these.
  struct Stretch {
    kernel::Rational from, to;
    std::optional<std::array<Index, 2>> faces;  ///< of A and of B; nothing where no faces are known to do so
    bool starts_there;  ///< true: the faces go through one another only above `from`; false: also at `from`
  };

  /// Returns stretches that cover 0 to the first exit without gaps. Their faces are plain triangles. Requires what the
  /// search requires, and the first exit that it returns. Invalidates `normals()`.
  std::vector<Stretch> stretches(const std::array<kernel::Rational, 12>& map_a,
                                 const std::array<kernel::Rational, 12>& map_b, const kernel::Rational& first)
  {
    solid_[0].see(map_a);
    solid_[1].see(map_b);
    std::vector<Stretch> all;
    kernel::Rational at = 0;
    while (at < first) {
      Stretch next{at, first, std::nullopt, false};
      if (const auto high = largest_high(&at, {.plain_only = true, .or_starts = true})) {
        next.to = *high;
        next.faces = {last_pair_[0]->face, last_pair_[1]->face};
        next.starts_there = exact_range(*last_pair_[0], *last_pair_[1]).low()->most == at;
      } else if (const auto low = least_low_above(at); low && *low < first) {
        next.to = *low;
      }
      at = next.to;
      all.push_back(std::move(next));
    }
    return all;
  }

  /// Returns stretches that end at an exit, by pairs of pieces that share no point above it. They are at most
  /// `most_pairs`. Requires what the search requires, and an exit that it returns.
  std::vector<Stretch> stretches_before(const std::array<kernel::Rational, 12>& map_a,
                                        const std::array<kernel::Rational, 12>& map_b, const kernel::Rational& exit,
                                        std::size_t most_pairs)
  {
    solid_[0].see(map_a);
    solid_[1].see(map_b);
    const std::pair at = CGAL::to_interval(exit);
    const double least_at = at.first, most_at = at.second;
    std::vector<Stretch> found;
    search(
        [&](const kernel::View_box& a, const kernel::View_box& b) -> std::optional<double> {
          if (kernel::most_rise(a, b) < least_at || kernel::least_rise(a, b) > most_at) return std::nullopt;
          return 0;
        },
        [&] { return found.size() < most_pairs ? 0.0 : -1.0; },
        [&](Seen_piece& a, Seen_piece& b) {
          if (found.size() == most_pairs) return;
          if (a.is_bounded && b.is_bounded) {
            const CGAL::Protect_FPU_rounding<true> upward;
            const auto about = enclosed(a, b);
            if (about.is_empty() || (about.high() && (about.high()->most < least_at || about.high()->least > most_at)))
              return;
          }
          const auto range = exact_range(a, b);
          if (range.is_empty() || range.high()->most != exit || !(range.low()->most < exit)) return;
          found.push_back({range.low()->most, exit, std::array{a.face, b.face}, true});
        });
    return found;
  }

  /// Returns the normals, in the view, of planes along which the solids part at the first exit. Returns none if no pair
  /// of faces was found there. Requires that the exits were asked for last.
  std::vector<kernel::Number_point<kernel::Rational>> normals()
  {
    if (!last_pair_[0]) return {};
    return kernel::directions_at(solid_[0].exactly(*last_pair_[0]), solid_[1].exactly(*last_pair_[1]), last_high_);
  }

  /// Returns the counts of work since the last `clear_counts`.
  const Query_statistics& counts() const { return counts_; }
  void clear_counts() { counts_ = {}; }

 private:
  using Rational = kernel::Rational;

  /// Two boxes that are to be opened.
  struct Pair {
    double key;  // the least comes first
    Box_ids box;
  };
  /// A pair of pieces whose `high` may be the sought one, with bounds of it.
  struct Candidate {
    Seen_piece *a, *b;
    double least, most;
    std::optional<Rational> exact;
  };

  /// Pieces that surely meet for the rises from `low` to `high.least`.
  struct Met {
    Seen_piece *a, *b;
    double low;
    kernel::Shift_range<kernel::Interval>::End high;
  };

  /// Pairs of boxes that may meet for the rises from `least` to `most`.
  struct Rising {
    double least, most;
    Box_ids box;
  };

  /// Returns an enclosure of the shift range of two pieces, by rounded numbers where these decide. Requires upward
  /// rounding, and pieces that are bounded.
  static kernel::Shift_range<kernel::Interval> enclosed(const Seen_piece& a, const Seen_piece& b)
  {
    kernel::Shift_range<kernel::Interval> range(a.rounded, b.rounded);
    if (!range.is_empty() && !range.is_certain()) range = {a.about, b.about};
    return range;
  }

  /// Decides axes in integers where a range is neither empty nor certain. Requires what `enclosed` requires.
  void sharpen(kernel::Shift_range<kernel::Interval>& range, Seen_piece& a, Seen_piece& b)
  {
    if (range.is_empty() || range.is_certain()) return;
    ++counts_.exact_fallbacks;
    range = {a.about, b.about, [&] { return std::array{&solid_[0].exactly(a), &solid_[1].exactly(b)}; }};
  }

  /// Returns an upper bound of the rise from which on the pair found last meets; infinity where it is not known.
  double start_of_last()
  {
    const auto [a, b] = last_pair_;
    if (!a->is_bounded || !b->is_bounded) return std::numeric_limits<double>::infinity();
    const CGAL::Protect_FPU_rounding<true> upward;
    auto range = enclosed(*a, *b);
    sharpen(range, *a, *b);
    return range.is_certain() ? range.low()->most : std::numeric_limits<double>::infinity();
  }

  /// Goes up from a rise by pieces that surely meet below the rise that is reached, until that is above the goal.
  /// Returns the last of these pairs: F has all rises from the first one to its `high`. Nothing where no pair surely
  /// meets at the first one.
  std::optional<Met> climb(double at, double goal)
  {
    std::optional<Met> reached;
    const auto is_met_later = [](const Met& x, const Met& y) { return x.low > y.low; };
    const auto starts_later = [](const Rising& x, const Rising& y) { return x.least > y.least; };
    std::vector<Met> met;       // from above `at`
    std::vector<Rising> later;  // start above `at`
    std::vector<Rising> ready;  // the others; the one that was added last is opened first
    const auto add = [&](const Box_ids& box, const kernel::View_box& a, const kernel::View_box& b) {
      ++counts_.box_tests;
      if (!a.may_cover(b)) return;
      const Rising rising{kernel::least_rise(a, b), kernel::most_rise(a, b), box};
      if (!(rising.most > at)) return;
      if (rising.least < at)
        ready.push_back(rising);
      else
        push_to(later, rising, starts_later);
    };
    const auto compare = [&](Seen_piece& a, Seen_piece& b) {
      if (!a.is_bounded || !b.is_bounded || !(kernel::most_rise(a.box, b.box) > at)) return;
      const CGAL::Protect_FPU_rounding<true> upward;
      auto range = enclosed(a, b);
      if (range.high() && range.high()->most <= at) return;
      sharpen(range, a, b);
      if (range.is_certain() && range.high()->least > at)
        push_to(met, Met{&a, &b, range.low()->most, *range.high()}, is_met_later);
    };
    add({Box_id(), Box_id()}, solid_[0].box({}), solid_[1].box({}));
    for (;;) {
      while (!met.empty() && met.front().low < at) {
        const Met next = pop_from(met, is_met_later);
        if (!(next.high.least > at)) continue;
        at = next.high.least;
        reached = next;
      }
      if (at > goal) return reached;
      while (!later.empty() && later.front().least < at) ready.push_back(pop_from(later, starts_later));
      if (ready.empty()) return reached;
      const Rising next = ready.back();
      ready.pop_back();
      if (!(next.most > at)) continue;
      ++counts_.pairs_visited;
      const auto first = std::ptrdiff_t(ready.size());
      open(next.box, add, compare);
      std::sort(ready.begin() + first, ready.end(), [](const Rising& x, const Rising& y) { return x.most < y.most; });
    }
  }

  /// The pairs of pieces that `largest_high` looks at.
  struct Pair_choice {
    bool plain_only;  // pairs of plain triangles alone
    bool or_starts;   // also pairs whose lower end is the rise
  };

  /// Returns the largest `high` of all pairs of pieces. With a rise `through`, it looks only at pairs that have it
  /// between their ends; nothing if there is none.
  std::optional<Rational> largest_high(const Rational* through, Pair_choice choice = {})
  {
    const auto starts_after = [choice](const auto& low, const auto& rise) {
      return choice.or_starts ? low > rise : low >= rise;
    };
    // Names, since clang 14 lets no function object take a structured binding.
    const std::pair at = through ? CGAL::to_interval(*through) : std::pair(0.0, 0.0);
    const double least_at = at.first, most_at = at.second;
    double best = -std::numeric_limits<double>::infinity();
    std::vector<Candidate> candidates;
    const auto key = [&](const kernel::View_box& a, const kernel::View_box& b) -> std::optional<double> {
      const double most = kernel::most_rise(a, b);
      if (through && (most <= least_at || starts_after(kernel::least_rise(a, b), most_at))) return std::nullopt;
      return -most;
    };
    const auto compare = [&](Seen_piece& a, Seen_piece& b) {
      if (choice.plain_only && !(solid_[0].is_plain(a.face) && solid_[1].is_plain(b.face))) return;
      if (a.is_bounded && b.is_bounded) {
        const CGAL::Protect_FPU_rounding<true> upward;
        auto range = enclosed(a, b);
        const auto is_out = [&] {
          if (range.is_empty()) return true;
          if (!range.high()) return false;
          const double most = range.high()->most;
          return most <= best || (through && (most <= least_at || starts_after(range.low()->least, most_at)));
        };
        if (is_out()) return;
        sharpen(range, a, b);
        if (is_out()) return;
        if (range.is_certain() && (!through || (range.low()->most < least_at && range.high()->least > most_at))) {
          candidates.push_back({&a, &b, range.high()->least, range.high()->most, std::nullopt});
          best = kernel::maximum(best, range.high()->least);
          return;
        }
      }
      const auto range = exact_range(a, b);
      if (range.is_empty() ||
          (through && (starts_after(range.low()->most, *through) || *through >= range.high()->most)))
        return;
      add_exact(candidates, a, b, range.high()->most);
      best = kernel::maximum(best, candidates.back().least);
    };
    search(
        key, [&] { return -best; }, compare);
    std::erase_if(candidates, [&](const Candidate& c) { return c.most < best; });
    std::optional<Rational> found;
    for (Candidate& c : candidates) {
      const Rational& high = exact_high(c);
      if (found && high <= *found) continue;
      found = high;
      note(c);
    }
    return found;
  }

  /// Returns the least `high` of a pair that is above a rise. Requires that there is one.
  Rational least_high_above(const Rational& rise)
  {
    const std::pair at = CGAL::to_interval(rise);
    const double least_at = at.first, most_at = at.second;
    double best = std::numeric_limits<double>::infinity();
    std::vector<Candidate> candidates;
    const auto key = [&](const kernel::View_box& a, const kernel::View_box& b) -> std::optional<double> {
      if (kernel::most_rise(a, b) < least_at) return std::nullopt;
      return kernel::least_rise(a, b);
    };
    const auto compare = [&](Seen_piece& a, Seen_piece& b) {
      if (a.is_bounded && b.is_bounded) {
        const CGAL::Protect_FPU_rounding<true> upward;
        auto range = enclosed(a, b);
        if (range.is_empty() || (range.high() && range.high()->most < least_at)) return;
        sharpen(range, a, b);
        if (range.is_empty()) return;
        if (range.is_certain()) {
          if (range.high()->least > best) return;
          if (range.high()->least > most_at) {
            candidates.push_back({&a, &b, range.high()->least, range.high()->most, std::nullopt});
            best = kernel::minimum(best, range.high()->most);
            return;
          }
        }
      }
      const auto range = exact_range(a, b);
      if (range.is_empty() || range.high()->most <= rise) return;
      add_exact(candidates, a, b, range.high()->most);
      best = kernel::minimum(best, candidates.back().most);
    };
    search(
        key, [&] { return best; }, compare);
    std::erase_if(candidates, [&](const Candidate& c) { return c.least > best; });
    std::optional<Rational> found;
    for (Candidate& c : candidates) {
      const Rational& high = exact_high(c);
      if (found && high >= *found) continue;
      found = high;
      note(c);
    }
    return *found;
  }

  /// Returns the least `low` of a pair that is above a rise; nothing if there is none.
  std::optional<Rational> least_low_above(const Rational& rise)
  {
    const double least_at = CGAL::to_interval(rise).first;
    double best = std::numeric_limits<double>::infinity();
    std::optional<Rational> found;
    search(
        [&](const kernel::View_box& a, const kernel::View_box& b) -> std::optional<double> {
          if (kernel::most_rise(a, b) < least_at) return std::nullopt;
          return kernel::least_rise(a, b);
        },
        [&] { return best; },
        [&](Seen_piece& a, Seen_piece& b) {
          if (a.is_bounded && b.is_bounded) {
            const CGAL::Protect_FPU_rounding<true> upward;
            const auto about = enclosed(a, b);
            if (about.is_empty() || (about.low() && about.low()->least > best) ||
                (about.is_certain() && about.low()->most < least_at))
              return;
          }
          const auto range = exact_range(a, b);
          if (range.is_empty() || range.low()->most <= rise || (found && range.low()->most >= *found)) return;
          found = range.low()->most;
          best = CGAL::to_interval(*found).second;
        });
    return found;
  }

  /// Takes the candidate's `high` as the one that is found. Requires that `exact_high` was asked for it.
  void note(const Candidate& c)
  {
    last_high_ = *c.exact;
    last_pair_ = {c.a, c.b};
  }

  /// Compares the pairs of pieces that may share a place in the view. key(box of A, box of B) orders pairs of boxes,
  /// and leaves some out. Pairs with a key above limit() are left out, too.
  template <class Key, class Limit, class Compare>
  void search(const Key& key, const Limit& limit, const Compare& compare)
  {
    queue_.clear();
    const auto is_later = [](const Pair& x, const Pair& y) { return x.key > y.key; };
    const auto add = [&](const Box_ids& box, const kernel::View_box& a, const kernel::View_box& b) {
      ++counts_.box_tests;
      if (!a.may_cover(b)) return;
      if (const std::optional<double> at = key(a, b)) push_to(queue_, {*at, box}, is_later);
    };
    add({Box_id(), Box_id()}, solid_[0].box({}), solid_[1].box({}));
    while (!queue_.empty()) {
      const Pair pair = pop_from(queue_, is_later);
      if (pair.key > limit()) break;
      ++counts_.pairs_visited;
      open(pair.box, add, [&](Seen_piece& a, Seen_piece& b) {
        if (const std::optional<double> at = key(a.box, b.box); at && !(*at > limit())) compare(a, b);
      });
    }
  }

  /// Opens a pair of boxes, and counts the work. Pieces are compared where they may share a place in the view.
  template <class Add, class Compare>
  void open(const Box_ids& box, const Add& add, const Compare& compare)
  {
    counts_.leaf_pairs += solid_[0].tree().is_leaf(box[0]) && solid_[1].tree().is_leaf(box[1]);
    open_pair(solid_, box, add, [&](Seen_piece& a, Seen_piece& b) {
      if (!a.box.may_cover(b.box)) return;
      ++counts_.triangle_tests;
      compare(a, b);
    });
  }

  kernel::Shift_range<Rational> exact_range(Seen_piece& a, Seen_piece& b)
  {
    ++counts_.exact_fallbacks;
    return {solid_[0].exactly(a), solid_[1].exactly(b)};
  }

  static void add_exact(std::vector<Candidate>& candidates, Seen_piece& a, Seen_piece& b, const Rational& high)
  {
    const auto [least, most] = CGAL::to_interval(high);
    candidates.push_back({&a, &b, least, most, high});
  }

  const Rational& exact_high(Candidate& c)
  {
    if (!c.exact) {
      const CGAL::Protect_FPU_rounding<true> upward;
      c.exact = kernel::exact_high(c.a->about, c.b->about, c.most, solid_[0].exactly(*c.a), solid_[1].exactly(*c.b));
    }
    return *c.exact;
  }

  std::array<Seen_solid, 2> solid_;
  std::vector<Pair> queue_;
  std::array<Seen_piece*, 2> last_pair_{};  // the pair whose `high` was found last
  Rational last_high_;
  Query_statistics counts_;
};

}  // namespace tetracone::tetratree

#endif
