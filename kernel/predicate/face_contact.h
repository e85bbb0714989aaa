#ifndef TETRACONE_KERNEL_PREDICATE_FACE_CONTACT_H
#define TETRACONE_KERNEL_PREDICATE_FACE_CONTACT_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tetracone::kernel {

/// A maximal piece of what two closed faces share.
enum class Piece : std::uint8_t {
  point,
  segment,
  polygon  ///< of coplanar faces
};

/// Returns the name in tables: "point", "segment", or "coplanar" for a polygon.
constexpr std::string_view to_string(Piece piece)
{
  constexpr std::array<std::string_view, 3> names = {"point", "segment", "coplanar"};
  return names[std::size_t(piece)];
}

/// The smallest part of a face that holds all of a piece: a vertex, one edge or several, or only the whole face.
/// `none`: no part does.
enum class Feature : std::uint8_t { none, vertex, edge, interior };

/// Returns the enumerator's own name.
constexpr std::string_view to_string(Feature feature)
{
  constexpr std::array<std::string_view, 4> names = {"none", "vertex", "edge", "interior"};
  return names[std::size_t(feature)];
}

}  // namespace tetracone::kernel

#endif
