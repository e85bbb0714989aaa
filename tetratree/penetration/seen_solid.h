#ifndef TETRACONE_TETRATREE_PENETRATION_SEEN_SOLID_H
#define TETRACONE_TETRATREE_PENETRATION_SEEN_SOLID_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/covering/side_windings.h"
#include "tetracone/kernel/bound/view_box.h"
#include "tetracone/kernel/contact/corner_point.h"
#include "tetracone/kernel/contact/face_cells.h"
#include "tetracone/kernel/contact/integer_placing.h"
#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/contact/shift_range.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/tetratree/fast/bvh8.h"
#include "tetracone/tetratree/relation/solid_sides.h"

#include <CGAL/gmpxx.h>

#include <array>
#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// A convex part of a face, in the coordinates of a view.
struct Seen_piece {
  kernel::Convex_piece<kernel::Interval> about;  ///< enclosed
  kernel::Rounded_piece rounded;                 ///< of a piece that is bounded
  kernel::View_box box;                          ///< unlimited where the piece is not bounded
  std::optional<kernel::Integer_piece> exact;    ///< of a plain triangle, nothing until it is needed
  bool is_bounded;                               ///< the numbers of `about` are far from overflow
  Index face;
};

/// Things by their number, made on demand. They stay in their place until all are forgotten. Then their memory is used
/// again.
template <class Thing>
class Numbered_things {
 public:
  /// Forgets all things.
  void forget()
  {
    ++round_;
    used_ = 0;
  }

  /// Returns the thing of a number. fill(thing) fills a new one, or one that was forgotten.
  template <class Fill>
  Thing& operator()(Index number, const Fill& fill)
  {
    if (number >= places_.size()) places_.resize(number + 1);
    Place& place = places_[number];
    if (place.round == round_) return *place.thing;
    if (used_ == things_.size()) things_.emplace_back();
    Thing& thing = things_[used_++];
    place = {round_, &thing};
    fill(thing);
    return thing;
  }

 private:
  struct Place {
    std::size_t round = 0;
    Thing* thing = nullptr;
  };

  std::size_t round_ = 1;  // since all were forgotten last; places of other rounds are empty
  std::size_t used_ = 0;   // things of this round
  std::vector<Place> places_;
  std::deque<Thing> things_;
};

/// A solid and its tree in the coordinates of a view (see `see`): convex pieces of faces, and boxes.
///
/// The pieces of a face are its parts that have the solid on some side. A plain triangle is one piece. Every other face
/// is cut by those that meet it. So no face of the solid goes through a piece, and each side of a piece is wholly in
/// the solid, or not at all.
class Seen_solid {
 public:
  /// `tree` has the faces of `polyhedron` as elements, and `sides` are of it. All must outlive this object.
  Seen_solid(const Bvh8& tree, const covering::Polyhedron& polyhedron, const Solid_sides& sides)
      : tree_(&tree), polyhedron_(&polyhedron), sides_(&sides), box_view_(std::array<kernel::Rational, 12>(), {})
  {}

  const Bvh8& tree() const { return *tree_; }

  /// Sets the view: a row-major 3x4 matrix from the body's coordinates. Boxes and pieces of the last one are forgotten.
  void see(const std::array<kernel::Rational, 12>& map)
  {
    map_ = map;
    for (std::size_t k = 0; k < 12; ++k) about_map_[k] = CGAL::to_interval(map[k]);
    scale_ = kernel::Integer_map::least_scale(map, sides_->fraction_bits());
    integer_map_ = kernel::Integer_map(map, sides_->fraction_bits(), scale_);
    box_view_ = kernel::Box_view(map, tree_->scale());
    boxes_.forget();
    pieces_.forget();
    vertices_.forget();
  }

  /// Returns the boxes of a node in the view, by lane.
  const std::array<kernel::View_box, kernel::lanes>& boxes(Index node)
  {
    return boxes_(node, [&](auto& boxes) { boxes = box_view_(tree_->node(node).boxes); });
  }
  /// Returns a box of the tree in the view.
  const kernel::View_box& box(Box_id id) { return boxes(id.node())[std::size_t(id.lane())]; }

  /// True for a plain triangle.
  bool is_plain(Index f) const { return sides_->of(f).is_plain; }

  /// True when all faces of a leaf are plain triangles.
  bool is_plain(Box_id leaf) const
  {
    for (Index k = 0; k < tree_->leaf_count(leaf); ++k)
      if (!is_plain(tree_->element(leaf, k).face)) return false;
    return true;
  }

  /// Returns the pieces of a face. They stay in their place until the next view.
  std::vector<Seen_piece>& pieces(Index f)
  {
    return pieces_(f, [&](auto& pieces) {
      pieces.clear();
      make_pieces(f, pieces);
    });
  }

  /// Returns a piece of the present view in integers.
  const kernel::Integer_piece& exactly(Seen_piece& piece)
  {
    if (!piece.exact) piece.exact = triangle(piece.face);
    return *piece.exact;
  }

 private:
  using Rational_piece = kernel::Convex_piece<kernel::Rational>;

  void make_pieces(Index f, std::vector<Seen_piece>& pieces)
  {
    const CGAL::Protect_FPU_rounding<true> upward;
    if (is_plain(f)) {
      if (sides_->of(f).any_in) add(pieces, {enclosed_triangle(f), {}, {}, std::nullopt, false, f});
      return;
    }
    for (Rational_piece cell : cells(f)) {
      for (int k = 0; k < cell.count; ++k) cell.corner[k] = kernel::image(cell.corner[k], map_);
      Seen_piece piece{{}, {}, {}, kernel::Integer_piece(cell), false, f};
      piece.about.count = cell.count;
      for (int k = 0; k < cell.count; ++k)
        for (std::size_t i = 0; i < 3; ++i) piece.about.corner[k][i] = CGAL::to_interval(cell.corner[k][i]);
      add(pieces, std::move(piece));
    }
  }

  static void add(std::vector<Seen_piece>& pieces, Seen_piece piece)
  {
    piece.is_bounded = kernel::is_bounded(piece.about);
    if (piece.is_bounded) piece.rounded = kernel::Rounded_piece(piece.about);
    piece.box = piece.is_bounded ? kernel::View_box::around({piece.about.corner.data(), std::size_t(piece.about.count)})
                                 : kernel::View_box::unlimited();
    pieces.push_back(std::move(piece));
  }

  kernel::Convex_piece<kernel::Interval> enclosed_triangle(Index f) const
  {
    kernel::Convex_piece<kernel::Interval> piece;
    for (const Index v : polyhedron_->loop(f, 0))
      piece.corner[std::size_t(piece.count++)] = kernel::image(polyhedron_->vertices[v], about_map_);
    return piece;
  }

  kernel::Integer_piece triangle(Index f)
  {
    kernel::Integer_piece piece;
    piece.denominator = scale_;
    for (const Index v : polyhedron_->loop(f, 0))
      piece.corner[std::size_t(piece.count++)] =
          vertices_(v, [&](auto& seen) { seen = integer_map_(polyhedron_->vertices[v]); });
    return piece;
  }

  /// Returns the cells of a face that have the solid on some side, in the body's coordinates.
  const std::vector<Rational_piece>& cells(Index f)
  {
    const auto [at, is_new] = cells_.try_emplace(f);
    if (!is_new) return at->second;
    const kernel::Rational_face face = covering::rational_face(*polyhedron_, f, kernel::Pose());
    if (!face.has_plane()) return at->second;
    std::vector<kernel::Rational_face::Edge> cuts;
    for (const Index other : sides_->cutters(f))
      add_cuts(face, covering::rational_face(*polyhedron_, other, kernel::Pose()), cuts);
    const kernel::Face_cells cells(face, cuts);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const covering::Sides sides = covering::sides(*polyhedron_, cells.inner_point(c), cells.axis());
      if (!sides.above && !sides.below) continue;
      Rational_piece piece;
      for (const kernel::Rational_point& x : cells.corners(c))
        if (piece.count == 0 || (x != piece.corner[std::size_t(piece.count - 1)] && x != piece.corner[0]))
          piece.corner[std::size_t(piece.count++)] = x;
      at->second.push_back(piece);
    }
    return at->second;
  }

  const Bvh8* tree_;
  const covering::Polyhedron* polyhedron_;
  const Solid_sides* sides_;
  std::array<kernel::Rational, 12> map_;
  std::array<kernel::Interval, 12> about_map_;
  mpz_class scale_;
  kernel::Integer_map integer_map_;  // times scale_
  kernel::Box_view box_view_;
  Numbered_things<std::array<kernel::View_box, kernel::lanes>> boxes_;  // by node
  Numbered_things<std::vector<Seen_piece>> pieces_;                     // by face
  Numbered_things<kernel::Number_point<mpz_class>> vertices_;           // images of vertices, times scale_
  std::map<Index, std::vector<Rational_piece>> cells_;                  // of faces that are not plain
};

/// Calls compare(piece of A, piece of B) for all pieces of two leaves. For other boxes, it calls add(boxes, box of A,
/// box of B) with each part of the larger one; a leaf is not opened.
template <class Add, class Compare>
void open_pair(std::array<Seen_solid, 2>& solid, const Box_ids& box, const Add& add, const Compare& compare)
{
  const Bvh8 &in_a = solid[0].tree(), &in_b = solid[1].tree();
  const std::array<bool, 2> is_leaf = {in_a.is_leaf(box[0]), in_b.is_leaf(box[1])};
  if (is_leaf[0] && is_leaf[1]) {
    for (Index i = 0; i < in_a.leaf_count(box[0]); ++i)
      for (Index j = 0; j < in_b.leaf_count(box[1]); ++j)
        for (Seen_piece& a : solid[0].pieces(in_a.element(box[0], i).face))
          for (Seen_piece& b : solid[1].pieces(in_b.element(box[1], j).face)) compare(a, b);
    return;
  }
  const kernel::View_box &a = solid[0].box(box[0]), &b = solid[1].box(box[1]);
  const bool opens_b = is_leaf[0] || (!is_leaf[1] && b.size() > a.size());
  const Bvh8& tree = solid[opens_b].tree();
  const Index node = tree.child(box[opens_b]);
  const auto& parts = solid[opens_b].boxes(node);
  for (int lane = 0; lane < tree.node(node).boxes.lane_count; ++lane) {
    Box_ids closer = box;
    closer[opens_b] = {node, lane};
    const kernel::View_box& part = parts[std::size_t(lane)];
    if (opens_b)
      add(closer, a, part);
    else
      add(closer, part, b);
  }
}

}  // namespace tetracone::tetratree

#endif
