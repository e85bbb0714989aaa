#ifndef TETRACONE_TETRATREE_RELATION_CROSSING_OVERLAP_H
#define TETRACONE_TETRATREE_RELATION_CROSSING_OVERLAP_H

#include "tetracone/covering/union_find.h"
#include "tetracone/kernel/contact/crossing_cones.h"
#include "tetracone/kernel/predicate/face_contact.h"
#include "tetracone/tetratree/contact/face_pairs.h"
#include "tetracone/tetratree/relation/placed_solid.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// The overlap of two simple solids in general position: all that their surfaces share are segments, at whose ends an
/// edge of one goes through the inside of a face of the other. No face needs to be cut into cells then.
class Crossing_overlap {
 public:
  /// True where this is so.
  static bool is_general(const Placed_solid& a, const Placed_solid& b, const Found_contacts& found)
  {
    const auto is_proper = [](const kernel::Triangle_contact::Corner& corner) {
      return std::popcount(unsigned(corner.on_p)) + std::popcount(unsigned(corner.on_q)) == 1;
    };
    return a.sides().is_simple() && b.sides().is_simple() &&
           std::ranges::all_of(found.pieces, [&](const Found_piece& piece) {
             return piece.by_signs.count == 2 && is_proper(piece.by_signs.corners[0]) &&
                    is_proper(piece.by_signs.corners[1]);
           });
  }

  /// Requires `is_general`.
  Crossing_overlap(const Placed_solid& a, const Placed_solid& b, const Found_contacts& found) : solid_{&a, &b}
  {
    place(found);
    for (const Found_piece& piece : found.pieces) add(piece);
    for (int body = 0; body < 2; ++body) add_edges_and_whole_faces(body);
  }

  kernel::Volume_moment value() const
  {
    kernel::Volume_moment sums = cones_.value(scale_);
    for (int body = 0; body < 2; ++body) sums += whole_[body].placed(solid_[body]->map());
    return sums;
  }

 private:
  /// A face that meets the other body, and the crossings of its edges.
  struct Cut_face {
    kernel::Integer_triangle triangle;
    std::array<bool, 3> is_crossed{};         // by its edges; edge k goes from corner k to the next
    std::vector<Rational> entering, leaving;  // shares of edge 1
  };

  /// Finds the scale, and places all faces that meet the other body.
  void place(const Found_contacts& found)
  {
    std::array<std::map<Index, std::array<Rational_point, 3>>, 2> corners;
    for (const Found_piece& piece : found.pieces)
      for (int body = 0; body < 2; ++body) {
        const Index f = body == 0 ? piece.face_a : piece.face_b;
        const auto [at, is_new] = corners[body].try_emplace(f);
        if (!is_new) continue;
        const covering::Polyhedron& polyhedron = solid_[body]->polyhedron();
        for (int k = 0; k < 3; ++k) {
          at->second[k] = solid_[body]->map()(polyhedron.vertices[polyhedron.loop(f, 0)[k]]);
          for (const Rational& x : at->second[k])
            if (!mpz_divisible_p(scale_.get_mpz_t(), x.get_den_mpz_t())) scale_ = lcm(scale_, x.get_den());
        }
      }
    for (int body = 0; body < 2; ++body)
      for (const auto& [f, points] : corners[body]) {
        Cut_face& cut = cut_[body][f];
        cut.triangle.outward = solid_[body]->plain_sides(f).against ? 1 : -1;
        for (int k = 0; k < 3; ++k)
          for (int i = 0; i < 3; ++i)
            cut.triangle.corner[k][i] = points[k][i].get_num() * (scale_ / points[k][i].get_den());
      }
  }

  /// Adds the segment that two faces share.
  void add(const Found_piece& piece)
  {
    const std::array<Cut_face*, 2> cut = {&cut_[0].at(piece.face_a), &cut_[1].at(piece.face_b)};
    const auto crossing = [&](const kernel::Triangle_contact::Corner& corner) {
      const int body = corner.on_p != 0 ? 0 : 1;
      const int edge = std::countr_zero(unsigned(body == 0 ? corner.on_p : corner.on_q));
      Cut_face& own = *cut[body];
      const auto& corners = own.triangle.corner;
      kernel::Integer_crossing found(corners[edge], corners[(edge + 1) % 3], cut[1 - body]->triangle);
      own.is_crossed[edge] = true;
      if (edge == 1) (found.enters ? own.entering : own.leaving).push_back(found.share);
      return found;
    };
    const kernel::Integer_crossing x = crossing(piece.by_signs.corners[0]), y = crossing(piece.by_signs.corners[1]);
    cones_.add_contact(cut[0]->triangle, cut[1]->triangle, x, y);
  }

  /// Adds the edges of faces that meet the other body, and the faces that lie wholly inside it. An edge that is not
  /// crossed is inside or outside with both ends.
  void add_edges_and_whole_faces(int body)
  {
    const Placed_solid& own = *solid_[body];
    const covering::Polyhedron& polyhedron = own.polyhedron();
    const Solid_sides& sides = own.sides();
    covering::Union_find joined(sides.place_count());
    auto cut = cut_[body].begin();
    for (Index f = 0; f < polyhedron.face_count(); ++f) {
      const covering::Loop v = polyhedron.loop(f, 0);
      const bool is_cut = cut != cut_[body].end() && cut->first == f;
      for (int k = 0; k < 3; ++k)
        if (!is_cut || !cut->second.is_crossed[k]) joined.join(sides.place(v[k]), sides.place(v[(k + 1) % 3]));
      if (is_cut) ++cut;
    }
    std::map<Index, bool> known;
    const auto is_inside = [&](Index v) {
      const auto [at, is_new] = known.try_emplace(joined.root(sides.place(v)));
      if (is_new)
        at->second = solid_[1 - body]->locate(own.map()(polyhedron.vertices[v])) == covering::Location::inside;
      return at->second;
    };
    cut = cut_[body].begin();
    for (Index f = 0; f < polyhedron.face_count(); ++f) {
      const covering::Loop v = polyhedron.loop(f, 0);
      if (cut != cut_[body].end() && cut->first == f) {
        const Cut_face& face = cut++->second;
        cones_.add_edge(face.triangle, face.entering, face.leaving, is_inside(v[2]));
      } else if (is_inside(v[0])) {
        whole_[body].add(sides.of(f).back ? 1 : -1, polyhedron.vertices[v[0]], polyhedron.vertices[v[1]],
                         polyhedron.vertices[v[2]]);
      }
    }
  }

  std::array<const Placed_solid*, 2> solid_;
  mpz_class scale_ = 1;  // the coordinates of `cut_` are integers times 1 / scale_
  std::array<std::map<Index, Cut_face>, 2> cut_;
  kernel::Crossing_cones cones_;
  std::array<kernel::Model_cones, 2> whole_;
};

}  // namespace tetracone::tetratree

#endif
