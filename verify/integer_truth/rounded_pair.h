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

/// A body as a subject's rounding has left it.
struct Rounded_body {
  covering::Polyhedron surface;  ///< of the images: what has more than three corners need not be planar any more
  std::vector<std::optional<std::array<Index, 3>>> planes;  ///< of each face the corners that span its plane; nothing
                                                            ///< where it is its loops only

  /// No coordinate has overflowed.
  bool is_finite() const;
};

/// Two bodies as rounding has left them, and how they meet: in the integers and by the formulations of the second
/// truth, which share nothing with the subjects but the images themselves and which corners span a face's plane. A face
/// that is bent meets an edge whose ends are on different sides of the plane that the face has, where its loops wind
/// about the edge, seen along it.
class Rounded_pair {
 public:
  /// Requires finite bodies; closed ones for `Question::solid`.
  Rounded_pair(const Rounded_body& a, const Rounded_body& b, kernel::Question question);

  /// The edge from `from` to `to` of A (body 0) or B (1) meets the face of the other.
  bool edge_meets_face(int body, Index from, Index to, Index face) const
  {
    return pairs_.contains({body, std::min(from, to), std::max(from, to), face});
  }

  /// Two faces share a point: an edge of one meets the other.
  bool faces_meet(Index of_a, Index of_b) const;

  /// A part of one is in the solid of the other; asked where the surfaces share no point.
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
