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

/// A maximal piece of the points that a face of A and a face of B share.
struct Contact_piece {
  Index face_a;  ///< the face's number in A
  Index face_b;  ///< the face's number in B
  Piece kind;    ///< a point, a segment, or of faces in one plane a polygon
  Feature in_a;  ///< the smallest part of face_a that holds all of it: a vertex, one or several edges, the face
  Feature in_b;  ///< as in_a, for face_b
};

/// Doubles that enclose a point's coordinates. Their distance is at most 2^-40 of the point's largest coordinate, or
/// they are neighbours.
struct Enclosure {
  std::array<double, 3> lower;  ///< lower[k] <= x_k
  std::array<double, 3> upper;  ///< x_k <= upper[k]
};

/// All pairs of faces of two placed bodies that share a point, each with the maximal pieces of what they share.
///
/// Faces in different planes share points and segments. Faces in one plane share polygons, and points and segments that
/// no polygon holds. Each piece is listed once. The list is empty exactly where the surfaces share no point. Copies are
/// cheap. The place of a piece is computed when it is asked for. Any number of threads may ask at once.
class Contacts {
 public:
  /// Returns the number of pieces.
  std::size_t size() const;
  /// True when the surfaces share no point.
  bool empty() const { return size() == 0; }

  /// Returns piece k. Pieces are sorted by the face of A, then of B. Requires k < size().
  Contact_piece operator[](std::size_t k) const;

  /// Returns where piece k is: a loop of one point, of the two ends of a segment, or the loops of a polygon's border.
  /// The outer loop and the holes have no order. No three corners in a row are on one line. Requires k < size().
  std::vector<std::vector<Enclosure>> loops(std::size_t k) const;

  /// Returns `loops` exactly: fractions "n/d", or "n".
  std::vector<std::vector<std::array<std::string, 3>>> exact_loops(std::size_t k) const;

  /// Returns `loops` as the doubles nearest to the exact coordinates.
  std::vector<std::vector<std::array<double, 3>>> nearest_loops(std::size_t k) const;

  /// Pieces that are joined to a chain of points.
  struct Curve {
    bool closed;                                ///< true when the last point is joined with the first
    std::vector<std::array<double, 3>> points;  ///< the nearest doubles; each is joined with the next
  };

  /// Returns the pieces that are segments, joined where exactly two end in one point. Segments of one line that overlap
  /// or follow each other are one, unless a segment of another line ends between them. All is compared exactly.
  std::vector<Curve> curves() const;

  /// For the library's own use.
  explicit Contacts(std::shared_ptr<const detail::Contacts_data> data) : data_(std::move(data)) {}
  /// For the library's own use.
  const detail::Contacts_data& data() const { return *data_; }

 private:
  std::shared_ptr<const detail::Contacts_data> data_;
};

/// Returns the unit normals of both placed faces of piece k, A's first. They are outward where faces are oriented
/// outward, also under a pose that mirrors. Bounds of a coordinate are equal or neighbours. All are 0 for a face
/// without area. Requires k < contacts.size().
std::array<Enclosure, 2> contact_normals(const Contacts& contacts, std::size_t k);

}  // namespace tetracone

#endif
