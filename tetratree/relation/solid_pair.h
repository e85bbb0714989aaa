#ifndef TETRACONE_TETRATREE_RELATION_SOLID_PAIR_H
#define TETRACONE_TETRATREE_RELATION_SOLID_PAIR_H

#include "tetracone/covering/union_find.h"
#include "tetracone/kernel/contact/cone_sums.h"
#include "tetracone/kernel/contact/face_cells.h"
#include "tetracone/kernel/predicate/face_contact.h"
#include "tetracone/kernel/predicate/question.h"
#include "tetracone/kernel/predicate/triangle_contact.h"
#include "tetracone/tetratree/relation/placed_solid.h"
#include "tetracone/tetratree/relation/simple_relation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// A piece that a face of A and a face of B share, in rationals.
struct Solid_piece {
  std::array<Index, 2> face;
  kernel::Piece kind;
  std::vector<std::vector<Rational_point>> loops;
  kernel::Triangle_contact by_signs;  ///< of two triangles: the corners of the only loop; else none

  /// Returns the edges of the triangle of a body that hold the segment from corner k to the next.
  kernel::Edge_set edges_along(int body, int k) const
  {
    const auto &from = by_signs.corners[k], &to = by_signs.corners[(k + 1) % by_signs.count];
    return body == 0 ? from.on_p & to.on_p : from.on_q & to.on_q;
  }
};

/// On which sides of a cell of a face the face's own solid is (`own`), and the other one (`other`).
struct Cell_sides {
  bool is_on_other = false;  ///< the cell lies on a face of the other body
  Normal_sides own, other;   ///< along the axis of the face's cells, and against it
};

/// How much two solids overlap and touch.
struct Solid_overlap {
  kernel::Exact_solid all;                    ///< the overlap's volume and centroid
  Rational_point contact_vector = {0, 0, 0};  ///< the sum of areas of contact times A's outward unit normal
  std::vector<Rational> squared_areas;  ///< for each face of A that touches B, of its area on B; each point counts once
};

/// Two placed solids and all that their surfaces share.
///
/// The faces of both cut space into regions. Each solid holds all of a region, or nothing of its inside. Every region
/// of a solid is beside a cell: a part of a face that no other face cuts. So the sides of all cells decide
/// - whether the interiors share a point: some side is in both solids;
/// - whether A lies in B: no side is in A alone, and no point of A's surface is outside B.
///
/// A face that meets no face of the other body is not cut by it. Such faces that are connected by their corners are
/// inside or outside the other solid together, so one corner decides for all.
class Solid_pair {
 public:
  using Loops = std::vector<std::vector<Rational_point>>;

  /// A and B.
  Solid_pair(Placed_solid a, Placed_solid b) : solid_{std::move(a), std::move(b)} {}

  /// Places the solids. Requires that `pieces` are all that the placed surfaces share.
  void place(const kernel::Pose& pose_a, const kernel::Pose& pose_b, std::vector<Solid_piece> pieces)
  {
    solid_[0].place(pose_a);
    solid_[1].place(pose_b);
    pieces_ = std::move(pieces);
    for (int body = 0; body < 2; ++body) {
      pieces_of_[body].clear();
      for (std::size_t k = 0; k < pieces_.size(); ++k) pieces_of_[body][pieces_[k].face[body]].push_back(k);
      for (const Index f : solid_[body].sides().irregular()) pieces_of_[body][f];
    }
  }

  /// Returns A for body 0, B for body 1.
  Placed_solid& solid(int body) { return solid_[body]; }

  /// Returns which relation the placed solids have. Requires `place`.
  kernel::Solid_relation relation()
  {
    found_ = {};
    for (int body = 0; body < 2; ++body) {
      for_cut_faces(body, [&](Index f, const kernel::Face_cells& cells, std::span<const Cell_sides> sides) {
        for (std::size_t c = 0; c < cells.size(); ++c) note(body, sides[c]);
        note_borders(body, f, cells, sides);
        return !found_.is_overlap();
      });
      if (found_.is_overlap()) return kernel::Solid_relation::overlap;
    }
    for (int body = 0; body < 2; ++body) {
      for_uncut_parts(body, [&](const Part& part) { note(body, part); });
      note_lone_edges(body);
      if (found_.is_overlap()) return kernel::Solid_relation::overlap;
    }
    return found_.relation(!pieces_.empty());
  }

  /// Returns how much the solids overlap and touch. Requires `place`.
  ///
  /// A region's volume is the sum of the cones over the cells that bound it (JS08 Theorem 1). A cell bounds the overlap
  /// where one of its sides is in both solids, and the other is not.
  Solid_overlap overlap()
  {
    Solid_overlap overlap;
    kernel::Rational_cones cut;
    std::array<kernel::Model_cones, 2> uncut;
    for_border(
        [&](int body, Index f, const kernel::Face_cells& cells, std::span<const Cell_sides> sides) {
          const Rational_point& corner = solid_[body].face(f).origin();
          cells.for_borders(weights(body, f, cells, sides), [&](const Rational_point& p, const Rational_point& q,
                                                                int weight) { cut.add(weight, corner, p, q); });
          if (body == 0) add_contact(f, cells, sides, overlap);
        },
        [&](int body, Index f, int weight) {
          const covering::Polyhedron& polyhedron = solid_[body].polyhedron();
          const covering::Loop v = polyhedron.loop(f, 0);
          uncut[body].add(weight, polyhedron.vertices[v[0]], polyhedron.vertices[v[1]], polyhedron.vertices[v[2]]);
        });
    kernel::Volume_moment all = cut.value();
    for (int body = 0; body < 2; ++body) all += uncut[body].placed(solid_[body].map());
    overlap.all = kernel::Exact_solid(all);
    return overlap;
  }

  /// Calls what(corners) for convex parts of faces that together bound the overlap, each once. Corners are
  /// anticlockwise as seen from outside the overlap; of four, two may be equal. Requires `place`.
  template <class What>
  void for_border_parts(const What& what)
  {
    for_border(
        [&](int body, Index f, const kernel::Face_cells& cells, std::span<const Cell_sides> sides) {
          const std::vector<int> weight = weights(body, f, cells, sides);
          for (std::size_t c = 0; c < cells.size(); ++c) {
            if (weight[c] == 0) continue;
            auto corners = cells.corners(c);
            if (weight[c] < 0) std::ranges::reverse(corners);
            what(std::span<const Rational_point>(corners));
          }
        },
        [&](int body, Index f, int weight) {
          const covering::Loop v = solid_[body].polyhedron().loop(f, 0);
          const kernel::Rational_map& map = solid_[body].map();
          std::array<Rational_point, 3> corners;
          for (std::size_t k = 0; k < 3; ++k) corners[k] = map(solid_[body].polyhedron().vertices[v[k]]);
          if (weight * sgn(map.determinant()) < 0) std::ranges::reverse(corners);
          what(std::span<const Rational_point>(corners));
        });
  }

  /// Calls what(face, cells, their sides) for each face with area that meets the other body or is no triangle. Ends
  /// where what() returns false.
  template <class What>
  void for_cut_faces(int body, const What& what)
  {
    for (const auto& [f, pieces] : pieces_of_[body]) {
      if (!solid_[body].face(f).has_plane()) continue;
      const auto of_this_face = [&what, face = f](const kernel::Face_cells& cells, std::span<const Cell_sides> sides) {
        return what(face, cells, sides);
      };
      if (!for_cells(body, f, pieces, of_this_face)) return;
    }
  }

  /// Connected triangles that do not meet the other body.
  struct Part {
    std::vector<Index> faces;
    bool is_inside;  ///< in the other solid
  };

  /// Calls what(part) for each connected part of the triangles with area that do not meet the other body.
  template <class What>
  void for_uncut_parts(int body, const What& what)
  {
    Placed_solid& own = solid_[body];
    const Solid_sides& sides = own.sides();
    const covering::Polyhedron& polyhedron = own.polyhedron();
    covering::Union_find places(sides.place_count());
    const auto is_cut = [&](Index f) { return pieces_of_[body].contains(f); };
    for (Index f = 0; f < polyhedron.face_count(); ++f)
      if (!is_cut(f))
        for (const Index v : polyhedron.loop(f, 0)) places.join(sides.place(v), sides.place(polyhedron.loop(f, 0)[0]));
    std::map<Index, Part> parts;
    for (Index f = 0; f < polyhedron.face_count(); ++f) {
      if (is_cut(f)) continue;
      const Index corner = polyhedron.loop(f, 0)[0];
      const auto [part, is_new] = parts.try_emplace(places.root(sides.place(corner)));
      if (is_new)
        part->second.is_inside =
            solid_[1 - body].locate(own.map()(polyhedron.vertices[corner])) == covering::Location::inside;
      part->second.faces.push_back(f);
    }
    for (const auto& [root, part] : parts) what(part);
  }

 private:
  /// Returns what(cells, their sides) for a face that meets the other body in these pieces.
  template <class What>
  bool for_cells(int body, Index f, std::span<const std::size_t> pieces, const What& what)
  {
    Placed_solid& own = solid_[body];
    std::vector<Rational_face::Edge> cuts;
    // Plain triangles meet in corners and edges alone, and so do their contacts with a triangle.
    bool may_cross = !own.sides().of(f).is_plain;
    for (const std::size_t k : pieces) {
      const Solid_piece& piece = pieces_[k];
      may_cross = may_cross || !solid_[1 - body].sides().of(piece.face[1 - body]).is_plain;
      if (piece.by_signs.count == 0)
        for (const auto& loop : piece.loops) add_cuts(loop, cuts);
      // A segment or a point on the border of a triangle does not cut it. One point inside is an edge to itself.
      for (int j = piece.by_signs.count == 2; j < piece.by_signs.count; ++j)
        if (piece.edges_along(body, j) == 0)
          cuts.push_back({piece.loops[0][j], piece.loops[0][(j + 1) % piece.by_signs.count]});
    }
    for (const Index other : own.sides().cutters(f)) add_cuts(own.face(f), own.face(other), cuts);
    const kernel::Face_cells cells(own.face(f), cuts, may_cross);
    std::vector<Cell_sides> sides;
    for (std::size_t c = 0; c < cells.size(); ++c) sides.push_back(classify(body, f, pieces, cells, c));
    return what(cells, sides);
  }

  /// Returns the sides of a cell of a face. The cell lies on the other body where a face of a common polygon holds its
  /// inner point.
  Cell_sides classify(int body, Index f, std::span<const std::size_t> pieces, const kernel::Face_cells& cells,
                      std::size_t c)
  {
    Placed_solid &own = solid_[body], &other = solid_[1 - body];
    const Rational_face& face = own.face(f);
    const bool is_up = face.normal()[cells.axis()] > 0;
    const auto along_axis = [](Normal_sides sides, bool points_up) {
      if (!points_up) std::swap(sides.along, sides.against);
      return sides;
    };
    const Rational_point x = cells.inner_point(c);
    Cell_sides cell;
    cell.own = along_axis(own.sides().of(f).is_plain ? own.plain_sides(f) : own.sides_at(x, face.normal()), is_up);
    for (const std::size_t k : pieces) {
      if (pieces_[k].kind != kernel::Piece::polygon) continue;
      const Index g = pieces_[k].face[1 - body];
      const Rational_face& beside = other.face(g);
      if (beside.locate(x) == kernel::Feature::none) continue;
      cell.is_on_other = true;
      if (!other.sides().of(g).is_plain) continue;
      cell.other = along_axis(other.plain_sides(g), beside.normal()[cells.axis()] > 0);
      return cell;
    }
    const covering::Location at = cell.is_on_other ? covering::Location::on_surface : other.locate(x);
    if (at == covering::Location::on_surface)  // of faces that are not plain, or without area
      cell.other = along_axis(other.sides_at(x, face.normal()), is_up);
    else
      cell.other = {at == covering::Location::inside, at == covering::Location::inside};
    return cell;
  }

  /// True when a face of the same body with a lower number holds the cell, too.
  bool is_counted(int body, Index f, const kernel::Face_cells& cells, std::size_t c)
  {
    Placed_solid& own = solid_[body];
    return std::ranges::any_of(own.sides().cutters(f), [&](Index g) {
      return g < f && own.face(g).has_plane() && own.face(g).locate(cells.inner_point(c)) != kernel::Feature::none;
    });
  }

  /// Visits all faces that may bound the overlap. Calls of_cells(body, face, cells, their sides) for faces whose cells
  /// have to be looked at. Calls of_whole(body, face, weight) for whole triangles that bound it.
  template <class Of_cells, class Of_whole>
  void for_border(const Of_cells& of_cells, const Of_whole& of_whole)
  {
    for (int body = 0; body < 2; ++body) {
      for_cut_faces(body, [&](Index f, const kernel::Face_cells& cells, std::span<const Cell_sides> sides) {
        of_cells(body, f, cells, sides);
        return true;
      });
      for_uncut_parts(body, [&](const Part& part) {
        if (!part.is_inside) return;
        for (const Index f : part.faces) {
          const Solid_sides::Face_sides& face = solid_[body].sides().of(f);
          if (!face.is_plain)
            for_cells(body, f, {}, [&](const kernel::Face_cells& cells, std::span<const Cell_sides> sides) {
              of_cells(body, f, cells, sides);
              return true;
            });
          else if (face.front != face.back)
            of_whole(body, f, face.back - face.front);
        }
      });
    }
  }

  /// Returns a number for each cell of a face: 1 where it bounds the overlap from above, as seen along the axis, -1
  /// where it does from below, else 0. A cell that lies on several faces counts once.
  std::vector<int> weights(int body, Index f, const kernel::Face_cells& cells, std::span<const Cell_sides> sides)
  {
    std::vector<int> weights(cells.size(), 0);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const auto [is_on_other, own, other] = sides[c];
      weights[c] = int(own.against && other.against) - int(own.along && other.along);
      if (weights[c] != 0 && ((body == 1 && is_on_other) || is_counted(body, f, cells, c))) weights[c] = 0;
    }
    return weights;
  }

  /// Adds the cells of a face of A that lie on B.
  void add_contact(Index f, const kernel::Face_cells& cells, std::span<const Cell_sides> sides, Solid_overlap& overlap)
  {
    std::vector<int> areas(cells.size(), 0), outward(cells.size(), 0);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (!sides[c].is_on_other || is_counted(0, f, cells, c)) continue;
      areas[c] = 1;
      outward[c] = int(sides[c].own.against) - int(sides[c].own.along);
    }
    const auto sum = [&](const std::vector<int>& weights) {
      Rational_point twice = {0, 0, 0};
      cells.for_borders(weights, [&](const Rational_point& p, const Rational_point& q, int weight) {
        const Rational_point area = kernel::cross(p, q);
        for (int k = 0; k < 3; ++k) twice[k] += weight * area[k];
      });
      return twice;
    };
    const Rational_point area = sum(areas), vector = sum(outward);
    if (!is_zero(area)) overlap.squared_areas.push_back(dot(area, area) / 4);
    for (int k = 0; k < 3; ++k) overlap.contact_vector[k] += vector[k] / 2;
  }

  void note(int body, const Cell_sides& cell)
  {
    for (bool Normal_sides::*side : {&Normal_sides::along, &Normal_sides::against}) {
      const bool in_own = cell.own.*side, in_other = cell.other.*side;
      if (in_own && in_other) found_.interiors_meet = true;
      if (in_own && !in_other) found_.sticks_out[body] = true;
      if (!in_own && in_other) found_.sticks_out[1 - body] = true;
    }
    if (cell.is_on_other) {
      if (cell.other.any_out()) found_.meets_border[body] = true;
      if (cell.own.any_out()) found_.meets_border[1 - body] = true;
    } else if (cell.other.any_out()) {
      found_.sticks_out[body] = true;
    }
  }

  void note(int body, const Part& part)
  {
    if (!part.is_inside) {
      found_.sticks_out[body] = true;
      return;
    }
    found_.shares_point = true;
    for (const Index f : part.faces) {
      const Solid_sides::Face_sides& sides = solid_[body].sides().of(f);
      if (sides.any_in) found_.interiors_meet = true;
      if (sides.any_out) found_.sticks_out[1 - body] = true;
    }
  }

  /// Notes whether a piece on a face meets the border of the face's own solid. That border is the closed cells with a
  /// side that is not in the solid. All cells of a plain triangle have equal sides.
  void note_borders(int body, Index f, const kernel::Face_cells& cells, std::span<const Cell_sides> sides)
  {
    bool& meets = found_.meets_border[1 - body];
    const auto& pieces = pieces_of_[body][f];
    if (meets || pieces.empty()) return;
    if (solid_[body].sides().of(f).is_plain) {
      meets = solid_[body].plain_sides(f).any_out();
      return;
    }
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (!sides[c].own.any_out()) continue;
      for (const std::size_t k : pieces)
        for (const auto& loop : pieces_[k].loops)
          for (std::size_t j = 0; j < loop.size(); ++j)
            meets = meets || cells.meets(c, loop[j], loop[j + 1 == loop.size() ? 0 : j + 1]);
    }
  }

  /// Looks at edges that may have no area beside them: edges of faces without area, and of faces that are no triangles.
  ///
  /// Each is cut where a face of either body meets it. A part that is on no face with area is beside one region alone.
  void note_lone_edges(int body)
  {
    Placed_solid &own = solid_[body], &other = solid_[1 - body];
    for (const Index f : own.sides().irregular()) {
      const Rational_face& face = own.face(f);
      const auto& pieces = pieces_of_[body][f];
      Loops common, cut_by;
      for (const std::size_t k : pieces) common.insert(common.end(), pieces_[k].loops.begin(), pieces_[k].loops.end());
      for (const Index g : own.sides().cutters(f))
        for (const kernel::Rational_piece& piece : kernel::face_contact(face, own.face(g)))
          cut_by.insert(cut_by.end(), piece.loops.begin(), piece.loops.end());
      for (const auto& [p, q] : face.edges()) {
        std::vector<Rational_point> stops = {p, q};
        for (const Loops* loops : {&common, &cut_by})
          for (const auto& loop : *loops)
            for (const Rational_point& x : loop)
              if (kernel::is_inside_segment(x, p, q)) stops.push_back(x);
        const Rational_point along = difference(q, p);
        std::ranges::sort(stops, {}, [&](const Rational_point& x) { return dot(along, x); });
        for (std::size_t k = 0; k < stops.size(); ++k) {
          note_lone_point(body, stops[k]);
          if (k + 1 == stops.size() || stops[k] == stops[k + 1]) continue;
          const Rational_point middle = kernel::between(stops[k], stops[k + 1], Rational(1, 2));
          note_lone_point(body, middle);
          if (common.empty() || is_on_area(own, f, middle)) continue;
          if (!own.sides_at(middle, {0, 0, 1}).any_out()) continue;
          for (const Rational_point& x : {stops[k], middle, stops[k + 1]})
            if (other.locate(x) == covering::Location::on_surface) found_.meets_border[1 - body] = true;
        }
      }
      // A face that is one point has no other part.
      if (is_zero(face.along()) && !pieces.empty() && !is_on_area(own, f, face.origin()) &&
          own.sides_at(face.origin(), {0, 0, 1}).any_out())
        found_.meets_border[1 - body] = true;
    }
  }

  void note_lone_point(int body, const Rational_point& x)
  {
    (solid_[1 - body].locate(x) == covering::Location::outside ? found_.sticks_out[body] : found_.shares_point) = true;
  }

  /// True when x is in a closed cell of the face, or of one that meets it.
  static bool is_on_area(Placed_solid& own, Index f, const Rational_point& x)
  {
    const auto holds = [&](Index g) {
      const Rational_face& face = own.face(g);
      if (!face.has_plane() || face.locate(x) == kernel::Feature::none) return false;
      const kernel::Face_cells cells(face, {});
      for (std::size_t c = 0; c < cells.size(); ++c)
        if (cells.meets(c, x, x)) return true;
      return false;
    };
    return holds(f) || std::ranges::any_of(own.sides().cutters(f), holds);
  }

  std::array<Placed_solid, 2> solid_;
  std::vector<Solid_piece> pieces_;
  std::array<std::map<Index, std::vector<std::size_t>>, 2> pieces_of_;  // by the face, also for irregular faces
  Found_regions found_;
};

}  // namespace tetracone::tetratree

#endif
