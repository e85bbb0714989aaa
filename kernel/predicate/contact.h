#ifndef TETRACONE_KERNEL_PREDICATE_CONTACT_H
#define TETRACONE_KERNEL_PREDICATE_CONTACT_H

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tetracone::kernel {

/// How a closed edge and a closed face meet. Where they share exactly one point, the kind names the two elements
/// (vertex, edge, face) whose relative interiors hold that point. The element of lower dimension comes first. A
/// degenerate edge is a vertex. Where they share more than one point they lie in one plane.
enum class Contact {
  none,             ///< no common point
  vertex_vertex,    ///< an end of the edge at a vertex of the face
  vertex_edge,      ///< an end of the edge inside an edge of the face, or a vertex of the face inside the edge
  vertex_face,      ///< an end of the edge inside the face
  edge_edge,        ///< the edge crosses an edge of the face
  edge_face,        ///< the edge goes through the inside of the face
  coplanar_overlap  ///< more than one common point, in the plane of the face
};

/// Returns the name, in words joined by '-' or a blank.
constexpr std::string_view to_string(Contact contact)
{
  constexpr std::array<std::string_view, 7> names = {"none",      "vertex-vertex", "vertex-edge",     "vertex-face",
                                                     "edge-edge", "edge-face",     "coplanar overlap"};
  return names[std::size_t(contact)];
}

/// An edge of one of two bodies A and B and a face of the other that share a point.
struct Feature_pair {
  int body;                 ///< 0: an edge of A and a face of B; 1: an edge of B and a face of A
  std::uint32_t edge_from;  ///< the edge's vertices, edge_from <= edge_to: an edge has no direction here,
  std::uint32_t edge_to;    ///< and the two are equal only where a loop goes from a vertex to itself
  std::uint32_t face;       ///< the face's number
  Contact kind;             ///< how they meet

  /// Compares the members, in their order.
  friend auto operator<=>(const Feature_pair&, const Feature_pair&) = default;
};

}  // namespace tetracone::kernel

#endif
