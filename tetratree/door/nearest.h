#ifndef TETRACONE_TETRATREE_DOOR_NEAREST_H
#define TETRACONE_TETRATREE_DOOR_NEAREST_H

#include <array>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace tetracone {

/// The part of a placed body that holds a point: the corner or edge of a face if the point is on one. Else it is the
/// face, or the solid's interior for a point of no face.
struct Holder {
  /// The kind of the part; `interior` is the solid without its surface.
  enum class Kind { vertex, edge, face, interior };

  Kind kind = Kind::interior;         ///< the part
  std::vector<std::uint32_t> number;  ///< the vertex; the two vertices of the edge; the face; nothing for `interior`

  /// Returns "vertex 3", "edge 3 4", "face 7" or "interior".
  std::string text() const
  {
    constexpr std::array<std::string_view, 4> names = {"vertex", "edge", "face", "interior"};
    std::string text(names[std::size_t(kind)]);
    for (const std::uint32_t n : number) text += " " + std::to_string(n);
    return text;
  }
  /// True when kind and numbers are equal.
  friend bool operator==(const Holder&, const Holder&) = default;
};
/// Writes the text.
inline std::ostream& operator<<(std::ostream& out, const Holder& holder) { return out << holder.text(); }

/// Two nearest points, one of each placed body, exactly, in the units of the placed coordinates. Fractions are "n/d" in
/// lowest terms, or "n".
struct Nearest {
  double distance = 0;                              ///< the double nearest to the exact distance
  std::string squared;                              ///< the squared distance
  std::array<std::array<std::string, 3>, 2> point;  ///< the point of A, then the point of B
  std::array<Holder, 2> holder;                     ///< what holds them
};

/// The point of a body's surface nearest to a given point, in the units of the body's own coordinates.
struct Nearest_point {
  double distance;              ///< the double nearest to the exact distance, negative for a point inside the solid
  std::array<double, 3> point;  ///< the doubles nearest to the nearest point, or to one of several
  Holder holder;                ///< what holds it; the smaller vertex of an edge is first
  bool is_only;                 ///< false when another point of the surface is as near
};

/// Same, with fractions "n/d" in lowest terms, or "n".
struct Exact_nearest_point : Nearest_point {
  std::string squared;                     ///< the squared distance
  std::array<std::string, 3> exact_point;  ///< the nearest point
};

}  // namespace tetracone

#endif
