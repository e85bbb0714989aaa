#ifndef TETRACONE_VERIFY_TRUTH_INTEGER_BOXES_H
#define TETRACONE_VERIFY_TRUTH_INTEGER_BOXES_H

#include "verify/truth/integer_body.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace tetracone::verify {

/// A closed box. A bound is its rank among all bounds on its axis: ranks compare as the integers do, and cost an int.
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

/// For each value its place among the different values.
inline std::vector<int> ranks(const std::vector<Integer>& values)
{
  std::vector<int> order(values.size()), rank(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int i, int j) { return values[i] < values[j]; });
  for (std::size_t k = 1; k < order.size(); ++k)
    rank[order[k]] = rank[order[k - 1]] + (values[order[k - 1]] < values[order[k]] ? 1 : 0);
  return rank;
}

/// The boxes of two bodies over one denominator. With `growth`, each is grown by 2^-growth of its longest side.
inline std::array<Element_boxes, 2> element_boxes(const Integer_body& a, const Integer_body& b, int growth = 0)
{
  std::array<std::vector<Integer>, 3> bounds;
  const auto add = [&](const Integer_body& body, const auto& corners) {
    Integer_vector low = body.point(corners[0]), high = low;
    for (const Index v : corners)
      for (int i = 0; i < 3; ++i) {
        const Integer& x = body.point(v)[i];
        if (x < low[i]) low[i] = x;
        if (x > high[i]) high[i] = x;
      }
    if (growth > 0) {
      Integer side = 0;
      for (int i = 0; i < 3; ++i) side = std::max(side, Integer(high[i] - low[i]));
      for (int i = 0; i < 3; ++i) {
        // In units of 2^-growth, so that growing stays in integers.
        low[i] = (low[i] << growth) - side;
        high[i] = (high[i] << growth) + side;
      }
    }
    for (int i = 0; i < 3; ++i) {
      bounds[i].push_back(low[i]);
      bounds[i].push_back(high[i]);
    }
  };
  for (const Integer_body* body : {&a, &b}) {
    for (Index v = 0; v < body->vertex_count(); ++v) add(*body, std::array{v});
    for (const auto& [from, to] : body->edges()) add(*body, std::array{from, to});
    for (Index f = 0; f < body->face_count(); ++f) add(*body, body->corners(f));
  }

  const std::array rank = {ranks(bounds[0]), ranks(bounds[1]), ranks(bounds[2])};
  std::size_t next = 0;
  const auto take = [&](std::size_t count) {
    std::vector<Rank_box> boxes;
    for (std::size_t k = 0; k < count; ++k, ++next)
      boxes.push_back({{rank[0][2 * next], rank[1][2 * next], rank[2][2 * next]},
                       {rank[0][2 * next + 1], rank[1][2 * next + 1], rank[2][2 * next + 1]}});
    return boxes;
  };
  std::array<Element_boxes, 2> both;
  for (int k = 0; k < 2; ++k) {
    const Integer_body& body = k == 0 ? a : b;
    both[k].vertices = take(body.vertex_count());
    both[k].edges = take(body.edges().size());
    both[k].faces = take(body.face_count());
  }
  return both;
}

}  // namespace tetracone::verify

#endif
