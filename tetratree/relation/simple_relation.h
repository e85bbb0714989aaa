#ifndef TETRACONE_TETRATREE_RELATION_SIMPLE_RELATION_H
#define TETRACONE_TETRATREE_RELATION_SIMPLE_RELATION_H

#include "tetracone/covering/model.h"
#include "tetracone/covering/polyhedron.h"
#include "tetracone/covering/union_find.h"
#include "tetracone/kernel/predicate/adaptive.h"
#include "tetracone/kernel/predicate/question.h"
#include "tetracone/kernel/predicate/signs.h"
#include "tetracone/kernel/predicate/triangle_contact.h"
#include "tetracone/tetratree/contact/face_pairs.h"
#include "tetracone/tetratree/relation/solid_sides.h"

#include <array>
#include <bit>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace tetracone::tetratree {

/// True when vertex v of a body is in the other solid. It is asked only for vertices off the other surface, while the
/// rounding mode is to nearest.
using Is_vertex_inside = std::function<bool(int body, Index v)>;

/// Marks the vertices of a body at which a piece has a corner: they are on the other surface. Each place has a mark.
inline void mark_vertices(const Found_piece& piece, int body, const covering::Polyhedron& polyhedron,
                          const Solid_sides& sides, std::vector<bool>& is_on_other)
{
  const covering::Loop v = polyhedron.loop(body == 0 ? piece.face_a : piece.face_b, 0);
  for (int k = 0; k < piece.by_signs.count; ++k) {
    const auto& [on_p, on_q] = piece.by_signs.corners[std::size_t(k)];
    const kernel::Edge_set edges = body == 0 ? on_p : on_q;
    if (std::popcount(edges) == 2) is_on_other[sides.place(v[std::size_t(kernel::corner_of(edges))])] = true;
  }
}

/// What the regions of two surfaces tell of their solids, as far as they have been looked at.
struct Found_regions {
  bool interiors_meet = false;
  bool shares_point = false;           ///< a part of one surface lies in the other solid, and may have no area
  std::array<bool, 2> sticks_out{};    ///< a point of this body is outside the other
  std::array<bool, 2> meets_border{};  ///< a point of this body's surface is no inner point of the other

  bool is_overlap() const { return interiors_meet && sticks_out[0] && sticks_out[1]; }

  /// Returns the relation. Requires that all regions were looked at, or `is_overlap`. `surfaces_meet` says whether the
  /// surfaces share a point.
  kernel::Solid_relation relation(bool surfaces_meet) const
  {
    using enum kernel::Solid_relation;
    if (is_overlap()) return overlap;
    if (!sticks_out[0] && !sticks_out[1]) return equal;
    if (!sticks_out[0]) return meets_border[0] ? covered_by : inside;
    if (!sticks_out[1]) return meets_border[1] ? covers : contains;
    return surfaces_meet || shares_point ? meet : disjoint;
  }
};

/// The relation of two simple solids by signs alone, which cost a small part of rational cells.
///
/// The contacts cut either surface into regions. A region lies on the other surface, inside the other solid, or outside
/// it. In a simple solid each face has the solid on exactly one side. So the regions decide, as the cells of
/// `Solid_pair` do. This is known of a region:
/// - On a common polygon, both solids are on one side of the plane, or on opposite sides. A vertex that is off the
///   plane tells which.
/// - Within a face, a segment and a polygon's border follow an edge of the other body. The two faces at the edge bound
///   a wedge of its solid, which is less than half of space where the edge is convex. The edge parts the face's plane
///   into two halves. Let both faces at the edge be on one side of that plane, or in it. Then a half that is on neither
///   face is outside at a convex edge, and inside at a reflex one. Otherwise one half is inside and one is outside.
/// - A face without a segment or a polygon in its inside is one region. Its corners off the other surface are on the
///   region's border. Regions that have such a corner in common are alike, and one corner decides for all.
/// - All corners of such a face may be on the other surface. If a segment of one of its edges is, too, the planes
///   of the other body's faces at that segment decide. Otherwise nothing is known.
/// Each region of any other face has on its border a part of a segment within the face, or of a polygon's border.
///
/// Two contacts show that the solids overlap. The first is an edge that goes through the inside of a face:
/// `is_crossing`. The second is a segment that is on no edge of either face. Near its inner points the two planes part
/// space into four wedges, and one is in both solids.
class Simple_relation {
 public:
  using K = kernel::Adaptive;

  /// A body of triangles that is simple. All must outlive this.
  struct Body {
    const covering::Polyhedron* polyhedron;
    const Solid_sides* sides;
    covering::Placed_model<K>* placed;  ///< has the polyhedron's vertices
  };

  Simple_relation(const Body& a, const Body& b) : body_{a, b} {}

  /// Returns the relation of the placed solids; nothing where these signs do not decide. Requires that `found` is all
  /// that the placed surfaces share.
  std::optional<kernel::Solid_relation> operator()(const Found_contacts& found,
                                                   const Is_vertex_inside& is_vertex_inside)
  {
    regions_ = {};
    is_known_ = true;
    for (int body = 0; body < 2; ++body) {
      is_on_other_[body].assign(body_[body].sides->place_count(), false);
      faces_[body].clear();
      along_edge_[body].clear();
    }
    for (const Found_piece& piece : found.pieces) {
      if (is_overlap(piece.by_signs)) return kernel::Solid_relation::overlap;
      if (piece.by_signs.count > 2) note_polygon_sides(piece);
      for (int body = 0; body < 2; ++body) note(body, piece);
      if (regions_.is_overlap()) return kernel::Solid_relation::overlap;
    }
    regions_.meets_border = {!found.pieces.empty(), !found.pieces.empty()};
    for (int body = 0; body < 2 && !regions_.is_overlap(); ++body) note_whole_regions(body, is_vertex_inside);
    if (!is_known_ && !regions_.is_overlap()) return std::nullopt;
    return regions_.relation(!found.pieces.empty());
  }

 private:
  using Contact = kernel::Triangle_contact;

  static kernel::Edge_set on(int body, const Contact::Corner& corner) { return body == 0 ? corner.on_p : corner.on_q; }

  /// Returns the edges of a body's triangle that hold the contact from corner k to the next.
  static kernel::Edge_set along(int body, const Contact& contact, int k)
  {
    return on(body, contact.corners[k]) & on(body, contact.corners[(k + 1) % contact.count]);
  }

  static bool is_overlap(const Contact& contact)
  {
    for (int k = 0; k < contact.count; ++k)
      if (is_crossing(contact.corners[k])) return true;
    return contact.count == 2 && along(0, contact, 0) == 0 && along(1, contact, 0) == 0;
  }

  kernel::Corners<K> corners(int body, Index f)
  {
    const covering::Loop v = body_[body].polyhedron->loop(f, 0);
    return {&point(body, v[0]), &point(body, v[1]), &point(body, v[2])};
  }
  const kernel::Point<K>& point(int body, Index v) { return body_[body].placed->point(v); }

  kernel::Sign side(const kernel::Corners<K>& face, const kernel::Point<K>& x)
  {
    return kernel::volume_sign<K>(*face[0], *face[1], *face[2], x);
  }

  /// Notes a region of a body's surface near an edge of the other body: it is outside where that edge is convex.
  void note_region(int body, kernel::Sign bend)
  {
    regions_.sticks_out[bend == kernel::POSITIVE ? body : 1 - body] = true;
    if (bend == kernel::NEGATIVE) regions_.interiors_meet = true;
  }

  /// Notes on which sides of a common polygon the solids are.
  void note_polygon_sides(const Found_piece& piece)
  {
    const std::array<Index, 2> face = {piece.face_a, piece.face_b};
    for (int body = 0; body < 2; ++body)
      for (int k = 0; k < 3; ++k) {
        const Solid_sides::Beyond_edge& beyond = body_[body].sides->beyond(face[body], k);
        if (beyond.side == kernel::ZERO) continue;
        note_sides(beyond.side, inward(1 - body, face[1 - body], beyond.apex, body));
        return;
      }
    const Index apex = vertex_beside(face[0]);  // all neighbours are in the plane
    note_sides(inward(0, face[0], apex, 0), inward(1, face[1], apex, 0));
  }

  /// Notes whether both solids are on one side of a polygon. The arguments say on which side of either face one point
  /// off the plane is, as `inward` does.
  void note_sides(kernel::Sign of_one, kernel::Sign of_other)
  {
    if (of_one == of_other)
      regions_.interiors_meet = true;
    else
      regions_.sticks_out = {true, true};
  }

  /// Returns the side of a face's plane on which vertex v of body `whose` is: POSITIVE where the face has its solid.
  /// Requires a face of a simple solid.
  kernel::Sign inward(int body, Index f, Index v, int whose)
  {
    const kernel::Sign in_front = side(corners(body, f), point(whose, v)) * body_[body].placed->determinant_sign();
    return body_[body].sides->of(f).front ? in_front : -in_front;
  }

  /// Returns a corner of A that is off the plane of one of its faces, near the last one that was returned. A solid has
  /// one.
  Index vertex_beside(Index f)
  {
    for (;; beside_ = (beside_ + 1) % Index(body_[0].polyhedron->face_count()))
      for (const Index v : body_[0].polyhedron->loop(beside_, 0))
        if (side(corners(0, f), point(0, v)) != kernel::ZERO) return v;
  }

  /// Notes what a piece on a face tells of the regions of the face.
  void note(int body, const Found_piece& piece)
  {
    const Index own = body == 0 ? piece.face_a : piece.face_b, other = body == 0 ? piece.face_b : piece.face_a;
    const Contact& contact = piece.by_signs;
    bool& is_cut = faces_[body][own];
    if (contact.count > 2) is_cut = true;  // also where the polygon is the whole face
    mark_vertices(piece, body, *body_[body].polyhedron, *body_[body].sides, is_on_other_[body]);
    if (contact.count == 1) return;
    for (int k = contact.count == 2; k < contact.count; ++k) {
      if (along(body, contact, k) != 0) {
        if (contact.count == 2) along_edge_[body].try_emplace(own, &piece);
        continue;
      }
      is_cut = true;
      const int edge = std::countr_zero(unsigned(along(1 - body, contact, k)));
      const Solid_sides::Beyond_edge& beyond = body_[1 - body].sides->beyond(other, edge);
      if (contact.count > 2) {
        if (beyond.side != kernel::ZERO) note_region(body, beyond.side);
        continue;
      }
      const Index apex = body_[1 - body].polyhedron->loop(other, 0)[std::size_t(edge + 2) % 3];
      const kernel::Corners<K> plane = corners(body, own);
      const kernel::Sign one = side(plane, point(1 - body, apex)), next = side(plane, point(1 - body, beyond.apex));
      if (next == kernel::ZERO) continue;  // that face and this one share a polygon
      if (one != next)                     // the wedge is on both sides of the plane, and so is the rest
        regions_ = {.interiors_meet = true, .shares_point = true, .sticks_out = {true, true}, .meets_border = {}};
      else
        note_region(body, beyond.side);
    }
  }

  /// True when a body's face is in the other solid beside the edge that holds the segment of a piece. Requires that the
  /// face shares no area with the other surface there.
  bool is_inside_beside(int body, const Found_piece& piece)
  {
    const int other_body = 1 - body;
    const Index own = body == 0 ? piece.face_a : piece.face_b, other = body == 0 ? piece.face_b : piece.face_a;
    const int own_edge = std::countr_zero(unsigned(along(body, piece.by_signs, 1)));
    const Index apex = body_[body].polyhedron->loop(own, 0)[std::size_t(own_edge + 2) % 3];
    const kernel::Sign one = inward(other_body, other, apex, body);
    const kernel::Edge_set edges = along(other_body, piece.by_signs, 1);
    if (edges == 0) return one == kernel::POSITIVE;
    const Solid_sides::Beyond_edge& beyond = body_[other_body].sides->beyond(other, std::countr_zero(unsigned(edges)));
    if (beyond.side == kernel::ZERO) return one == kernel::POSITIVE;
    const kernel::Sign next = inward(other_body, beyond.face, apex, body);
    // At a convex edge the solid is where both faces have it, at a reflex one where either has it.
    return beyond.side == kernel::POSITIVE ? one == kernel::POSITIVE && next == kernel::POSITIVE
                                           : one != kernel::NEGATIVE || next != kernel::NEGATIVE;
  }

  /// Looks at the regions that are whole faces, except for single points.
  void note_whole_regions(int body, const Is_vertex_inside& is_vertex_inside)
  {
    const covering::Polyhedron& polyhedron = *body_[body].polyhedron;
    const Solid_sides& sides = *body_[body].sides;
    covering::Union_find alike(sides.place_count());
    std::vector<Index> witness;  // a vertex of each whole region
    auto touched = faces_[body].begin();
    for (Index f = 0; f < polyhedron.face_count(); ++f) {
      const bool is_touched = touched != faces_[body].end() && touched->first == f;
      const bool is_cut = is_touched && touched->second;
      if (is_touched) ++touched;
      if (is_cut) continue;
      Index first = covering::none;
      for (const Index v : polyhedron.loop(f, 0)) {
        if (is_on_other_[body][sides.place(v)]) continue;
        if (first == covering::none) first = v;
        alike.join(sides.place(first), sides.place(v));
      }
      if (first != covering::none) {
        witness.push_back(first);
      } else if (const auto at = along_edge_[body].find(f); at != along_edge_[body].end()) {
        note_region(body, is_inside_beside(body, *at->second) ? kernel::NEGATIVE : kernel::POSITIVE);
        if (regions_.is_overlap()) return;
      } else {
        is_known_ = false;
      }
    }
    std::vector<bool> is_seen(sides.place_count(), false);
    for (const Index v : witness) {
      const Index root = alike.root(sides.place(v));
      if (is_seen[root]) continue;
      is_seen[root] = true;
      note_region(body, is_vertex_inside(body, v) ? kernel::NEGATIVE : kernel::POSITIVE);
      if (regions_.is_overlap()) return;
    }
  }

  std::array<Body, 2> body_;
  Found_regions regions_;
  bool is_known_ = true;                          // false: some region could not be looked at
  Index beside_ = 0;                              // a face of A, with a corner off the plane that was asked about last
  std::array<std::vector<bool>, 2> is_on_other_;  // by place: the vertex is on the other surface
  std::array<std::map<Index, bool>, 2> faces_;    // that have a piece: whether one has an inner point of the face
  std::array<std::map<Index, const Found_piece*>, 2> along_edge_;  // of the call: a segment on an edge of a face
};

}  // namespace tetracone::tetratree

#endif
