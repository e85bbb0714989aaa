#ifndef TETRACONE_KERNEL_CONTACT_H
#define TETRACONE_KERNEL_CONTACT_H

#include <string_view>

namespace tetracone::kernel {

/// How a closed edge and a closed face meet. Where they share exactly one point, the kind names the dimensions of the two
/// elements (vertex, edge, face) whose relative interior holds that point, the lower one first; a degenerate edge is a
/// vertex. Where they share more than one point they lie in one plane.
enum class Contact {
  none,
  vertex_vertex,
  vertex_edge,  ///< an end of the edge inside an edge of the face, or a vertex of the face inside the edge
  vertex_face,
  edge_edge,
  edge_face,
  coplanar_overlap
};

constexpr std::string_view to_string(Contact contact)
{
  switch (contact) {
    case Contact::none: return "none";
    case Contact::vertex_vertex: return "vertex-vertex";
    case Contact::vertex_edge: return "vertex-edge";
    case Contact::vertex_face: return "vertex-face";
    case Contact::edge_edge: return "edge-edge";
    case Contact::edge_face: return "edge-face";
    case Contact::coplanar_overlap: return "coplanar overlap";
  }
  return "none";
}

}  // namespace tetracone::kernel

#endif
