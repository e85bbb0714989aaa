#ifndef TETRACONE_TETRATREE_CERTIFICATE_MOTION_COVER_H
#define TETRACONE_TETRATREE_CERTIFICATE_MOTION_COVER_H

#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/certificate/moving_pair.h"

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// Covers the pairs of pieces of two bodies that move, over the times from 0 to an end. Each object covers once.
class Motion_cover {
 public:
  /// `may_touch_at_end`: the bodies may share points at `end`, not before. No interval of at most `shortest` is cut.
  /// `moving` must outlive this object.
  Motion_cover(Moving_pair& moving, double end, bool may_touch_at_end, double shortest = 0)
      : moving_(&moving), end_(end), shortest_(shortest), may_touch_at_end_(may_touch_at_end)
  {}

  /// True when all pairs are covered. False where no cover was found: pieces touch, or come near and may only graze.
  bool operator()() { return covers({}, {}, 0, end_); }

  Cover& cover() { return search_.cover(); }

 private:
  bool covers(Box_id a, Box_id b, double from, double to)
  {
    const std::vector<Placed_pair*> placed = moving_->over(from, to);
    std::vector<Hull_pair> pairs;
    pairs.reserve(placed.size());
    for (Placed_pair* pair : placed) pairs.push_back({pair->body[0].hull(a), pair->body[1].hull(b)});
    const bool may_touch = may_touch_at_end_ && to == end_;
    const auto holds = [&](const kernel::Exact_vector& m) {
      for (const Hull_pair& pair : pairs) {
        const CGAL::Sign gap = kernel::Exact_number(extent_of(pair.b, m, -1) - extent_of(pair.a, m, 1)).sign();
        const bool is_last = &pair == &pairs.back();
        if (gap != CGAL::POSITIVE && !(may_touch && is_last && gap == CGAL::ZERO)) return false;
      }
      return true;
    };
    if (search_.separates(pairs, 0, {}, holds)) return true;
    const auto [of_a, of_b] = moving_->groups();
    const bool is_piece[2] = {of_a->is_piece(a), of_b->is_piece(b)};
    if (is_piece[0] && is_piece[1]) {
      for (Placed_pair* end : {placed.front(), placed.back()})
        for (kernel::Exact_vector& m : candidates(*end, {a, b}))
          if (holds(m)) {
            search_.append(search_.add(std::move(m)));
            return true;
          }
      return cut(a, b, from, to);
    }
    // Groups that are apart at both ends, though not by one direction, need shorter intervals; others smaller groups.
    if (direction_by_few(std::span(pairs).first(1), 0) && direction_by_few(std::span(pairs).last(1), 0))
      return cut(a, b, from, to);
    const int opened = is_piece[0] || (!is_piece[1] && of_a->piece_count(a) < of_b->piece_count(b)) ? 1 : 0;
    search_.append(opened == 0 ? "[\"a\"" : "[\"b\"");
    for (const Box_id member : search_.open(opened == 0 ? *of_a : *of_b, opened == 0 ? a : b)) {
      search_.append(",");
      if (!(opened == 0 ? covers(member, b, from, to) : covers(a, member, from, to))) return false;
    }
    search_.append("]");
    return true;
  }

  bool cut(Box_id a, Box_id b, double from, double to)
  {
    const double time = from + (to - from) / 2;
    if (!(from < time && time < to && to - from > shortest_)) return false;
    search_.append(("[\"t\",\"" + kernel::to_string(kernel::Rational(time)) + "\",").c_str());
    if (!covers(a, b, from, time)) return false;
    search_.append(",");
    if (!covers(a, b, time, to)) return false;
    search_.append("]");
    return true;
  }

  /// Returns directions that may separate two pieces at a time: between their nearest points, and normals that part
  /// triangles which touch.
  static std::vector<kernel::Exact_vector> candidates(Placed_pair& pair, const std::array<Box_id, 2>& piece)
  {
    const std::array<kernel::Exact_face, 2> face = pair.faces(piece);
    std::vector<kernel::Exact_vector> candidates = parting_directions(face);
    const kernel::Exact_distance found = kernel::distance_of_faces(face[0], face[1]);
    if (!found.is_zero()) candidates.insert(candidates.begin(), found.direction);
    return candidates;
  }

  Moving_pair* moving_;
  double end_, shortest_;
  bool may_touch_at_end_;
  Cover_search search_;
};

}  // namespace tetracone::tetratree

#endif
