#ifndef TETRACONE_TETRATREE_DOOR_NEAREST_H
#define TETRACONE_TETRATREE_DOOR_NEAREST_H

#include <array>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace tetracone {

/// What part of a placed body holds a point: of a face as it was given, its corner or edge where the point is on one.
struct Holder {
  /// `interior`: of the solid, off its surface.
  enum class Kind { vertex, edge, face, interior };

  Kind kind = Kind::interior;         ///< the part
  std::vector<std::uint32_t> number;  ///< of the vertex; of the edge's vertices; of the face; nothing

  /// "vertex 3", "edge 3 4", "face 7" or "interior".
  std::string text() const
  {
    constexpr std::array<std::string_view, 4> names = {"vertex", "edge", "face", "interior"};
    std::string text(names[std::size_t(kind)]);
    for (const std::uint32_t n : number) text += " " + std::to_string(n);
    return text;
  }
  friend bool operator==(const Holder&, const Holder&) = default;
};
/// Writes the text.
inline std::ostream& operator<<(std::ostream& out, const Holder& holder) { return out << holder.text(); }

/// Two points, one of each placed body, that are as near as any, exactly. Fractions are "n/d" in lowest terms, or "n".
struct Nearest {
  double distance = 0;                              ///< the double nearest to the exact distance
  std::string squared;                              ///< the squared distance
  std::array<std::array<std::string, 3>, 2> point;  ///< of A, of B
  std::array<Holder, 2> holder;                     ///< what holds them
};

}  // namespace tetracone

#endif
