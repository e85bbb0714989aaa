#ifndef TETRACONE_TETRATREE_DOOR_CONTACTS_H
#define TETRACONE_TETRATREE_DOOR_CONTACTS_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/predicate/face_contact.h"

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace tetracone {

namespace detail {
struct Contacts_data;
}

using covering::Index;
using kernel::Feature;
using kernel::Piece;

/// A maximal piece of what a face of A and a face of B share.
struct Contact_piece {
  Index face_a;  ///< the face's number in A
  Index face_b;  ///< the face's number in B
  Piece kind;    ///< a point, a segment, or of faces in one plane a polygon
  Feature in_a;  ///< what of face_a holds all of it: a vertex, its edges, or no less than the face
  Feature in_b;  ///< what of face_b does
};

/// Doubles that enclose a point's coordinates: lower[k] <= x_k <= upper[k]. They are apart by at most 2^-40 of the
/// point's largest coordinate, or they are neighbours.
struct Enclosure {
  std::array<double, 3> lower, upper;
};

/// All pairs of faces of two placed bodies that share a point, with the maximal pieces of what they share, each once:
/// segments and points where the faces' planes cross, and of faces in one plane the polygons of their overlap, then
/// what no polygon holds. There is none exactly where the surfaces share no point. Cheap to copy; where a piece is gets
/// computed when it is asked for. Safe from any number of threads at once.
class Contacts {
 public:
  /// The number of pieces.
  std::size_t size() const;
  /// True when the surfaces share no point.
  bool empty() const { return size() == 0; }

  /// Piece k, by faces of A, then of B.
  Contact_piece operator[](std::size_t k) const;

  /// Where piece k is: one loop of a point, or of the two ends of a segment; or the loops of a polygon's border, which
  /// are its outer one and its holes, without order. No three corners in a row are on one line.
  std::vector<std::vector<Enclosure>> loops(std::size_t k) const;

  /// The same, exactly: fractions "n/d", or "n".
  std::vector<std::vector<std::array<std::string, 3>>> exact_loops(std::size_t k) const;

  /// The same as the doubles nearest to it.
  std::vector<std::vector<std::array<double, 3>>> nearest_loops(std::size_t k) const;

  /// Pieces that are joined: a chain of points, each joined with the next, and the last with the first where it is
  /// closed.
  struct Curve {
    bool closed;
    std::vector<std::array<double, 3>> points;  ///< the doubles nearest to them
  };

  /// The segments, those of one line that overlap or follow each other as one, unless a segment of another line ends
  /// between; joined where exactly two end in one point. All is compared exactly.
  std::vector<Curve> curves() const;

  /// Of the library's own.
  explicit Contacts(std::shared_ptr<const detail::Contacts_data> data) : data_(std::move(data)) {}
  /// Of the library's own.
  const detail::Contacts_data& data() const { return *data_; }

 private:
  std::shared_ptr<const detail::Contacts_data> data_;
};

}  // namespace tetracone

#endif
