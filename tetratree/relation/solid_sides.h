#ifndef TETRACONE_TETRATREE_RELATION_SOLID_SIDES_H
#define TETRACONE_TETRATREE_RELATION_SOLID_SIDES_H

#include "tetracone/covering/edge_uses.h"
#include "tetracone/covering/polyhedron.h"
#include "tetracone/covering/side_windings.h"
#include "tetracone/covering/union_find.h"
#include "tetracone/kernel/contact/face_cells.h"
#include "tetracone/kernel/contact/rational_contact.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/tetratree/query/bvh8_contacts.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// Adds the edges of a loop, the segment between two points, or one point: no cell has it inside.
inline void add_cuts(const std::vector<kernel::Rational_point>& loop, std::vector<kernel::Rational_face::Edge>& cuts)
{
  for (std::size_t k = loop.size() == 2; k < loop.size(); ++k)
    cuts.push_back({loop[k == 0 ? loop.size() - 1 : k - 1], loop[k]});
}

/// Adds the points, the segments and the borders of the polygons that two faces share.
inline void add_cuts(const kernel::Rational_face& p, const kernel::Rational_face& q,
                     std::vector<kernel::Rational_face::Edge>& cuts)
{
  for (const kernel::Rational_piece& piece : kernel::face_contact(p, q))
    for (const auto& loop : piece.loops) add_cuts(loop, cuts);
}

/// Which sides of the faces of one body are in its solid. A side is in the solid where its winding number is not 0.
///
/// A triangle is *plain* if it has area, and other faces meet it only in vertices or edges of both (by coordinates).
/// Then no face divides its sides. Two plain triangles have equal sides, and belong to one *patch*, where they share an
/// edge in opposite directions. No other face may have that edge. One point decides the sides of a patch. Every other
/// face is cut into cells by those that meet it. One point of each cell decides its sides.
class Solid_sides {
 public:
  /// A face's sides. `front` is the side from which its corners are anticlockwise.
  struct Face_sides {
    bool is_plain = false;
    bool front = false, back = false;      ///< of a plain triangle: whether this side is in the solid
    bool any_in = false, any_out = false;  ///< of a triangle: whether some side of some part is in the solid, or is not
  };

  /// Requires a closed polyhedron, and its tree, of which each element is a face.
  Solid_sides(const Bvh8& tree, const covering::Polyhedron& polyhedron)
      : polyhedron_(&polyhedron), place_(covering::least_equal_vertices(polyhedron.vertices))
  {
    const Index faces = Index(polyhedron.face_count());
    faces_.resize(faces);
    for (Index f = 0; f < faces; ++f) {
      faces_[f].is_plain = polyhedron.is_triangle(f) && tree.model().covering().plane_basis(f).has_value();
      if (!faces_[f].is_plain) irregular_.push_back(f);
    }
    fraction_bits_ = kernel::fraction_bits(polyhedron.vertices);
    find_cutters(tree);
    const std::vector<covering::Edge_use> uses = edge_uses();
    see_patches(uses);
    if (is_simple_) see_beyond_edges(uses, tree.model());
    for (Index f = 0; f < faces; ++f)
      if (!faces_[f].is_plain && !std::ranges::binary_search(irregular_, f)) see_cells(f);
  }

  /// Returns the sides of face `f`.
  const Face_sides& of(Index f) const { return faces_[f]; }

  /// True when every face is plain, parts the solid from its outside, and has a neighbour of its patch at each edge.
  bool is_simple() const { return is_simple_; }

  /// The other triangle at an edge of a triangle.
  struct Beyond_edge {
    Index face = covering::none;
    Index apex = covering::none;  ///< its third corner
    /// The side of the apex: POSITIVE where the solid is, at a convex edge; ZERO in the triangle's plane.
    kernel::Sign side = kernel::ZERO;
  };

  /// Returns what is beyond edge k of face f, from corner k to the next. Requires `is_simple`.
  const Beyond_edge& beyond(Index f, int k) const { return beyond_[3 * std::size_t(f) + std::size_t(k)]; }

  /// Returns the place of a vertex, a number below `place_count`. Vertices of equal coordinates have one place.
  Index place(Index v) const { return place_[v]; }
  /// Returns the number of vertices.
  std::size_t place_count() const { return place_.size(); }

  /// Returns the least n >= 0 such that all coordinates times 2^n are integers.
  int fraction_bits() const { return fraction_bits_; }

  /// Returns the faces that are no triangles with area, ascending.
  std::span<const Index> irregular() const { return irregular_; }

  /// Returns the other faces that meet face `f` elsewhere than in a common vertex or edge. A plain face has none.
  std::span<const Index> cutters(Index f) const
  {
    const auto found = cutters_.find(f);
    return found == cutters_.end() ? std::span<const Index>() : std::span<const Index>(found->second);
  }

 private:
  /// Finds the pairs of faces that meet elsewhere than in a vertex or an edge of both.
  void find_cutters(const Bvh8& tree)
  {
    Bvh8_contacts<kernel::Adaptive> finder(tree, tree.model(), *polyhedron_, tree, tree.model(), *polyhedron_);
    const kernel::Pose unmoved;
    const Found_contacts found = finder.contacts(unmoved, unmoved);
    for (const Found_piece& piece : found.pieces) {
      if (piece.face_a == piece.face_b || is_proper(piece.by_signs)) continue;
      for (const auto& [f, other] : {std::pair(piece.face_a, piece.face_b), std::pair(piece.face_b, piece.face_a)}) {
        faces_[f].is_plain = false;
        std::vector<Index>& cutters = cutters_[f];
        if (std::ranges::find(cutters, other) == cutters.end()) cutters.push_back(other);
      }
    }
  }

  /// True for a common vertex or edge of two triangles: each corner is a vertex of both.
  static bool is_proper(const kernel::Triangle_contact& contact)
  {
    const auto is_vertex = [](const kernel::Triangle_contact::Corner& corner) {
      return std::popcount(corner.on_p) == 2 && std::popcount(corner.on_q) == 2;
    };
    return (contact.count == 1 || contact.count == 2) &&
           std::all_of(contact.corners.begin(), contact.corners.begin() + contact.count, is_vertex);
  }

  /// Joins plain triangles to patches, and looks at one point of each patch.
  void see_patches(std::span<const covering::Edge_use> uses)
  {
    covering::Union_find patches(faces_.size());
    is_simple_ = std::ranges::all_of(faces_, &Face_sides::is_plain);
    covering::for_each_edge(uses, [&](std::span<const covering::Edge_use> edge) {
      const covering::Edge_use &one = edge.front(), &other = edge.back();
      if (edge.size() == 2 && surplus(edge) == 0 && faces_[one.face].is_plain && faces_[other.face].is_plain)
        patches.join(one.face, other.face);
      else
        is_simple_ = false;
    });
    std::vector<bool> is_seen(faces_.size(), false);
    for (Index f = 0; f < faces_.size(); ++f) {
      if (!faces_[f].is_plain) continue;
      const Index root = patches.root(f);
      if (!is_seen[root]) see_plain(f, faces_[root]);
      is_seen[root] = true;
      const Face_sides& known = faces_[root];
      faces_[f] = {true, known.front, known.back, known.any_in, known.any_out};
      if (known.front == known.back) is_simple_ = false;
    }
  }

  /// Returns the uses of all edges between places, sorted.
  std::vector<covering::Edge_use> edge_uses() const
  {
    std::vector<covering::Edge_use> uses;
    for (Index f = 0; f < faces_.size(); ++f)
      covering::for_each_directed_edge(*polyhedron_, f, [&](Index v, Index w) {
        const Index from = place_[v], to = place_[w];
        if (from != to) uses.push_back({kernel::minimum(from, to), kernel::maximum(from, to), f, from < to});
      });
    covering::sort_uses(uses, place_.size());
    return uses;
  }

  /// Finds what is beyond all edges. Requires `is_simple`.
  void see_beyond_edges(std::span<const covering::Edge_use> uses, const covering::Model<kernel::Adaptive>& model)
  {
    beyond_.resize(3 * faces_.size());
    covering::for_each_edge(uses, [&](std::span<const covering::Edge_use> edge) {
      // Returns the corner of a face that is not on the edge. It is opposite to the edge after it.
      const auto apex = [&](const covering::Edge_use& use) {
        const covering::Loop v = polyhedron_->loop(use.face, 0);
        int k = 0;
        while (place_[v[k]] == use.low || place_[v[k]] == use.high) ++k;
        return k;
      };
      for (const auto& [own, other] : {std::pair(edge[0], edge[1]), std::pair(edge[1], edge[0])}) {
        const covering::Loop v = polyhedron_->loop(own.face, 0);
        Beyond_edge& beyond = beyond_[3 * std::size_t(own.face) + std::size_t(apex(own) + 1) % 3];
        beyond.face = other.face;
        beyond.apex = polyhedron_->loop(other.face, 0)[apex(other)];
        const kernel::Sign side = kernel::volume_sign<kernel::Adaptive>(model.point(v[0]), model.point(v[1]),
                                                                        model.point(v[2]), model.point(beyond.apex));
        beyond.side = faces_[own.face].front ? side : -side;
      }
    });
  }

  /// Writes the sides of the patch of a plain triangle.
  void see_plain(Index f, Face_sides& known) const
  {
    const kernel::Rational_face face = covering::rational_face(*polyhedron_, f, kernel::Pose());
    kernel::Rational_point middle;
    for (int i = 0; i < 3; ++i)
      middle[i] = (face.edges()[0].first[i] + face.edges()[1].first[i] + face.edges()[2].first[i]) / 3;
    const int axis = face.axis();
    covering::Sides sides = covering::sides(*polyhedron_, middle, axis);
    if (sgn(face.normal()[axis]) < 0) std::swap(sides.above, sides.below);
    known.front = sides.above;
    known.back = sides.below;
    known.any_in = known.front || known.back;
    known.any_out = !known.front || !known.back;
  }

  /// Looks at the sides of the cells of a triangle that is not plain.
  void see_cells(Index f)
  {
    const kernel::Rational_face face = covering::rational_face(*polyhedron_, f, kernel::Pose());
    std::vector<kernel::Rational_face::Edge> cuts;
    for (const Index other : cutters(f))
      add_cuts(face, covering::rational_face(*polyhedron_, other, kernel::Pose()), cuts);
    const kernel::Face_cells cells(face, cuts);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const covering::Sides sides = covering::sides(*polyhedron_, cells.inner_point(c), cells.axis());
      faces_[f].any_in |= sides.above || sides.below;
      faces_[f].any_out |= !sides.above || !sides.below;
    }
  }

  const covering::Polyhedron* polyhedron_;
  std::vector<Index> place_;
  std::vector<Face_sides> faces_;
  std::map<Index, std::vector<Index>> cutters_;
  std::vector<Index> irregular_;
  std::vector<Beyond_edge> beyond_;  // of simple solids: by 3 * face + edge
  bool is_simple_ = false;
  int fraction_bits_ = 0;
};

}  // namespace tetracone::tetratree

#endif
