#ifndef TETRACONE_VERIFY_INTEGER_TRUTH_INTEGER_BOXES_H
#define TETRACONE_VERIFY_INTEGER_TRUTH_INTEGER_BOXES_H

#include "verify/integer_truth/integer_body.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace tetracone::verify {

/// A closed box. A bound is its rank among all bounds on its axis: ranks compare like the integers, at the cost of an
/// int.
struct Rank_box {
  std::array<int, 3> low, high;

  bool meets(const Rank_box& other) const
  {
    for (int i = 0; i < 3; ++i)
      if (low[i] > other.high[i] || other.low[i] > high[i]) return false;
    return true;
  }
};

/// The boxes of a body's elements, by their numbers.
struct Element_boxes {
  std::vector<Rank_box> vertices, edges, faces;
};

/// Returns the rank of each of `count` values among the different ones.
template <class Value>
std::vector<int> ranks(std::size_t count, const Value& value)
{
  std::vector<int> order(count), rank(count);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int i, int j) { return value(i) < value(j); });
  for (std::size_t k = 1; k < count; ++k)
    rank[order[k]] = rank[order[k - 1]] + (value(order[k - 1]) < value(order[k]) ? 1 : 0);
  return rank;
}

/// Calls what(corners) for the elements of a body: its vertices, its edges, its faces.
template <class What>
void for_elements(const Integer_body& body, const What& what)
{
  for (Index v = 0; v < body.vertex_count(); ++v) what(std::array{v});
  for (const auto& [from, to] : body.edges()) what(std::array{from, to});
  for (Index f = 0; f < body.face_count(); ++f) what(body.corners(f));
}

/// Returns the boxes of a body's elements, taken from one list of all.
inline Element_boxes element_boxes_from(const Integer_body& body, std::vector<Rank_box>::const_iterator next)
{
  const auto take = [&](std::size_t count) {
    const auto first = std::exchange(next, next + std::ptrdiff_t(count));
    return std::vector<Rank_box>(first, next);
  };
  std::vector<Rank_box> vertices = take(body.vertex_count()), edges = take(body.edges().size());
  return {std::move(vertices), std::move(edges), take(body.face_count())};
}

/// Returns the boxes of two bodies over one denominator.
inline std::array<Element_boxes, 2> element_boxes(const Integer_body& a, const Integer_body& b)
{
  std::array<std::vector<int>, 3> rank;  // of all vertices
  for (int i = 0; i < 3; ++i)
    rank[i] = ranks(a.vertex_count() + b.vertex_count(), [&](std::size_t v) -> const Integer& {
      return v < a.vertex_count() ? a.point(Index(v))[i] : b.point(Index(v) - a.vertex_count())[i];
    });
  const auto of = [&](const Integer_body& body, Index first) {
    std::vector<Rank_box> boxes;
    for_elements(body, [&](const auto& corners) {
      Rank_box box;
      for (int i = 0; i < 3; ++i) {
        box.low[i] = box.high[i] = rank[i][first + corners[0]];
        for (const Index v : corners) {
          box.low[i] = std::min(box.low[i], rank[i][first + v]);
          box.high[i] = std::max(box.high[i], rank[i][first + v]);
        }
      }
      boxes.push_back(box);
    });
    return element_boxes_from(body, boxes.begin());
  };
  return {of(a, 0), of(b, a.vertex_count())};
}

/// A box of integers.
struct Integer_box {
  Integer_vector low, high;

  template <class Corners>
  Integer_box(const Integer_body& body, const Corners& corners) : low(body.point(corners[0])), high(low)
  {
    for (const Index v : corners)
      for (int i = 0; i < 3; ++i) {
        const Integer& x = body.point(v)[i];
        if (x < low[i]) low[i] = x;
        if (x > high[i]) high[i] = x;
      }
  }

  Integer longest_side() const
  {
    Integer side = 0;
    for (int i = 0; i < 3; ++i) side = std::max(side, Integer(high[i] - low[i]));
    return side;
  }

  /// Grows the box in units of 2^-growth, so that growing by `side` stays in integers.
  void grow(int growth, const Integer& side)
  {
    for (int i = 0; i < 3; ++i) {
      low[i] = (low[i] << growth) - side;
      high[i] = (high[i] << growth) + side;
    }
  }
};

/// Returns the boxes of two bodies over one denominator, each grown by 2^-growth of its longest side. The boxes of
/// elements that are not near the other body's box meet nothing, whatever lies there.
inline std::array<Element_boxes, 2> grown_boxes(const Integer_body& a, const Integer_body& b, int growth)
{
  const auto whole = [](const Integer_body& body) {
    std::vector<Index> all(body.vertex_count());
    std::iota(all.begin(), all.end(), Index(0));
    return Integer_box(body, all);
  };
  Integer_box whole_a = whole(a), whole_b = whole(b);
  const Integer both_sides = whole_a.longest_side() + whole_b.longest_side();
  whole_a.grow(growth, both_sides);
  whole_b.grow(growth, both_sides);

  std::array<std::vector<Integer>, 3> bounds;
  std::vector<int> bounds_of;  // of each element the number of its bounds, or -1 where it is away
  const auto add = [&](const Integer_body& body, const Integer_box& other) {
    // For each vertex and axis: below (-1), in (0) or above (1) the other body.
    std::vector<std::array<int, 3>> place(body.vertex_count());
    for (Index v = 0; v < body.vertex_count(); ++v)
      for (int i = 0; i < 3; ++i) {
        const Integer x = body.point(v)[i] << growth;
        place[v][i] = x < other.low[i] ? -1 : x > other.high[i] ? 1 : 0;
      }
    for_elements(body, [&](const auto& corners) {
      bool away = false;
      for (int i = 0; i < 3; ++i)
        for (const int side : {-1, 1})
          away = away || std::all_of(corners.begin(), corners.end(), [&](Index v) { return place[v][i] == side; });
      bounds_of.push_back(away ? -1 : int(bounds[0].size()));
      if (away) return;
      Integer_box box(body, corners);
      box.grow(growth, box.longest_side());
      for (int i = 0; i < 3; ++i) {
        bounds[i].push_back(box.low[i]);
        bounds[i].push_back(box.high[i]);
      }
    });
  };
  add(a, whole_b);
  const std::size_t of_a = bounds_of.size();
  add(b, whole_a);

  std::array<std::vector<int>, 3> rank;
  for (int i = 0; i < 3; ++i)
    rank[i] = ranks(bounds[i].size(), [&](std::size_t k) -> const Integer& { return bounds[i][k]; });
  constexpr int beyond = std::numeric_limits<int>::max();
  std::vector<Rank_box> boxes;
  for (const int k : bounds_of)
    boxes.push_back(
        k < 0 ? Rank_box{{beyond, beyond, beyond}, {-1, -1, -1}}
              : Rank_box{{rank[0][k], rank[1][k], rank[2][k]}, {rank[0][k + 1], rank[1][k + 1], rank[2][k + 1]}});
  return {element_boxes_from(a, boxes.begin()), element_boxes_from(b, boxes.begin() + std::ptrdiff_t(of_a))};
}

/// Returns the numbers of the boxes that meet, (of the first list, of the second), in order. It sweeps along the first
/// axis, so that lists of 10^5 boxes are fast.
inline std::vector<std::pair<Index, Index>> meeting_boxes(const std::vector<Rank_box>& a,
                                                          const std::vector<Rank_box>& b)
{
  struct Part {
    const std::vector<Rank_box>& boxes;
    std::vector<Index> by_low, open;  // open: may still meet what comes

    Part(const std::vector<Rank_box>& all, const Rank_box& other) : boxes(all)
    {
      for (Index k = 0; k < all.size(); ++k)
        if (all[k].meets(other)) by_low.push_back(k);
      std::sort(by_low.begin(), by_low.end(), [&](Index i, Index j) { return all[i].low[0] < all[j].low[0]; });
    }
  };
  const auto around = [](const std::vector<Rank_box>& boxes) {
    Rank_box all = boxes[0];
    for (const Rank_box& box : boxes)
      for (int i = 0; i < 3; ++i) {
        all.low[i] = std::min(all.low[i], box.low[i]);
        all.high[i] = std::max(all.high[i], box.high[i]);
      }
    return all;
  };
  if (a.empty() || b.empty()) return {};
  Part of_a(a, around(b)), of_b(b, around(a));
  std::vector<std::pair<Index, Index>> pairs;
  const auto begin = [&](Index k, Part& mine, Part& other, auto&& report) {
    const Rank_box& box = mine.boxes[k];
    for (std::size_t i = 0; i < other.open.size();) {
      const Rank_box& that = other.boxes[other.open[i]];
      if (that.high[0] < box.low[0]) {
        other.open[i] = other.open.back();
        other.open.pop_back();
        continue;
      }
      if (box.meets(that)) report(other.open[i]);
      ++i;
    }
    mine.open.push_back(k);
  };
  std::size_t i = 0, j = 0;
  while (i < of_a.by_low.size() || j < of_b.by_low.size()) {
    const bool first =
        j == of_b.by_low.size() || (i < of_a.by_low.size() && a[of_a.by_low[i]].low[0] <= b[of_b.by_low[j]].low[0]);
    const Index k = first ? of_a.by_low[i++] : of_b.by_low[j++];
    if (first)
      begin(k, of_a, of_b, [&](Index other) { pairs.emplace_back(k, other); });
    else
      begin(k, of_b, of_a, [&](Index other) { pairs.emplace_back(other, k); });
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace tetracone::verify

#endif
