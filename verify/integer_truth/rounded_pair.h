#ifndef TETRACONE_VERIFY_INTEGER_TRUTH_ROUNDED_PAIR_H
#define TETRACONE_VERIFY_INTEGER_TRUTH_ROUNDED_PAIR_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/predicate/question.h"

#include <algorithm>
#include <array>
#include <compare>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace tetracone::verify {

using covering::Index;

/// A body as a subject has rounded it.
struct Rounded_body {
  covering::Polyhedron surface;  ///< of the images: what has more than three corners need not be planar any more
  std::vector<std::optional<std::array<Index, 3>>> planes;  ///< of each face the corners that span its plane; nothing
                                                            ///< where it is its loops only

  /// True when no coordinate has overflowed.
  bool is_finite() const;
};

/// Two rounded bodies, and their intersections in the integers and by the formulations of the second truth. These share
/// nothing with the subjects except the images themselves and the corners that span a face's plane. A bent face meets
/// an edge whose ends are on different sides of its plane if its loops wind about the edge, seen along it.
class Rounded_pair {
 public:
  /// Requires finite bodies; closed ones for `Question::solid`.
  Rounded_pair(const Rounded_body& a, const Rounded_body& b, kernel::Question question);

  /// True when the edge from `from` to `to` of A (body 0) or B (1) meets the face of the other.
  bool edge_meets_face(int body, Index from, Index to, Index face) const
  {
    return pairs_.contains({body, std::min(from, to), std::max(from, to), face});
  }

  /// True when two faces share a point: an edge of one meets the other.
  bool faces_meet(Index of_a, Index of_b) const;

  /// True when the question is `solid`, surfaces share no point, and a part of one body is in the other's solid.
  bool is_contained() const { return contained_; }

  bool collide() const { return contained_ || !pairs_.empty(); }

 private:
  struct Edge_and_face {
    int body;
    Index from, to, face;
    auto operator<=>(const Edge_and_face&) const = default;
  };
  std::set<Edge_and_face> pairs_;
  std::set<std::pair<Index, Index>> meeting_faces_;
  bool contained_ = false;
};

}  // namespace tetracone::verify

#endif
