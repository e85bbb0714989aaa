#ifndef TETRACONE_TETRATREE_QUERY_SEPARATING_FACE_H
#define TETRACONE_TETRATREE_QUERY_SEPARATING_FACE_H

#include "tetracone/covering/model.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/predicate/kept_sides.h"
#include "tetracone/tetratree/query/placed_bvh8.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetracone::tetratree {

/// The search for a plane between two bodies among the planes of their triangles, by exact signs. It finds planes
/// between bodies that nearly touch, for which `Separating_direction` has too few digits.
///
/// A triangle's plane separates where its own body lies on one closed side, and the other body strictly on the other.
/// Then neither the surfaces nor the solids share a point.
class Separating_face {
 public:
  /// Starts a query.
  void restart() { pairs_ = next_attempt_ = 0; }

  /// Whose triangle has all corners of the other one strictly on one side of its plane: `b` where A's has not.
  enum class Parted_by { neither, a, b };

  /// True when the plane of one of two elements is found to separate the placed bodies. Requires elements that only
  /// exact signs have found apart. Planes are tried when that costs no more than deciding the pairs of all calls so
  /// far. A failure makes the next attempt less likely to succeed, so that attempt waits for twice as many pairs.
  bool operator()(Placed_bvh8<>& a, const Element& of_a, Placed_bvh8<>& b, const Element& of_b, Parted_by parted_by,
                  kernel::Kept_sides& sides_of)
  {
    ++pairs_;
    if (parted_by == Parted_by::neither) return false;
    if (pairs_ < next_attempt_ || pairs_ * vertices_of_pair < vertex_count(a) + vertex_count(b)) return false;
    next_attempt_ = 2 * pairs_ + 1;
    return (parted_by == Parted_by::a && separates(a, of_a, side_of_a_, b, sides_of)) ||
           separates(b, of_b, side_of_b_, a, sides_of);
  }

  /// Returns the bytes of what is kept from query to query.
  std::size_t bytes() const { return (side_of_a_.capacity() + side_of_b_.capacity()) * sizeof(Side); }

 private:
  using Adaptive = kernel::Adaptive;
  using Corners = kernel::Corners<Adaptive>;
  using Sign = kernel::Sign;

  /// The signs of this many vertices cost about as much as deciding a pair of triangles by exact signs.
  static constexpr std::size_t vertices_of_pair = 16;

  /// The closed side of a triangle's plane that holds its body, before it is placed.
  enum class Side : std::uint8_t { unknown, negative, in_plane, positive, neither };

  static std::size_t vertex_count(const Placed_bvh8<>& body) { return body.placed.model().vertices().size(); }

  /// True when the plane of an element of `body` separates it from the other body. `sides` are the sides of the body's
  /// elements, by their numbers, as far as they are known.
  bool separates(Placed_bvh8<>& body, const Element& element, std::vector<Side>& sides, Placed_bvh8<>& other,
                 kernel::Kept_sides& sides_of)
  {
    if (element.is_whole_face()) return false;
    if (sides.empty()) sides.resize(body.tree->element_count());
    Side& side = sides[body.tree->number_of(element)];
    if (side == Side::unknown) side = side_of_body(body.placed.model(), element);
    if (side == Side::neither) return false;
    const Sign own = Sign(int(side) - int(Side::in_plane)) * body.placed.determinant_sign();

    const Corners triangle = body.corners(element);
    Sign beyond = kernel::ZERO;
    const auto is_beyond = [&](Sign sign) {
      if (beyond == kernel::ZERO) beyond = sign;
      return sign == beyond && sign != own && sign != kernel::ZERO;
    };
    // The filter first: it costs little, and mostly tells where the plane does not separate.
    near_.clear();
    const auto last = Index(vertex_count(other) - 1);
    for (Index v = 0; v <= last; v += 3) {
      const auto vertex = [&](Index k) { return &other.placed.point(kernel::minimum(v + k, last)); };
      const Corners points = {vertex(0), vertex(1), vertex(2)};
      const kernel::Some_sides filtered = kernel::filtered_sides(triangle, points);
      for (std::size_t k = 0; k < 3; ++k)
        if (!filtered.is_decided[k])
          near_.push_back(points[k]);
        else if (!is_beyond(filtered.side[k]))
          return false;
    }
    for (std::size_t n = 0; n < near_.size(); n += 3) {
      const std::size_t count = kernel::minimum(near_.size() - n, std::size_t(3));
      const auto vertex = [&](std::size_t k) { return near_[n + (k < count ? k : 0)]; };
      const auto side_of = sides_of.unfiltered(triangle, {vertex(0), vertex(1), vertex(2)}, count);
      for (std::size_t k = 0; k < count; ++k)
        if (!is_beyond(side_of[k])) return false;
    }
    return true;
  }

  static Side side_of_body(const covering::Model<Adaptive>& model, const Element& element)
  {
    const auto corner = [&](int k) { return model.point(element.corner[k]); };
    const Adaptive::Point_3 a = corner(0), b = corner(1), c = corner(2);
    Sign side = kernel::ZERO;
    for (Index v = 0; v < model.vertices().size(); ++v) {
      const Sign sign = kernel::volume_sign<Adaptive>(a, b, c, model.point(v));
      if (sign * side == kernel::NEGATIVE) return Side::neither;
      if (sign != kernel::ZERO) side = sign;
    }
    return Side(int(Side::in_plane) + side);
  }

  std::vector<Side> side_of_a_, side_of_b_;     // of each element; empty before the first attempt
  std::vector<const Adaptive::Point_3*> near_;  // of an attempt: the vertices whose sides the filter leaves undecided
  std::size_t pairs_ = 0, next_attempt_ = 0;    // of this query: so far, and before the next attempt
};

}  // namespace tetracone::tetratree

#endif
