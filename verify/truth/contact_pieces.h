#ifndef TETRACONE_VERIFY_TRUTH_CONTACT_PIECES_H
#define TETRACONE_VERIFY_TRUTH_CONTACT_PIECES_H

#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/predicate/face_contact.h"

#include <array>
#include <compare>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// The form in which lists of contacts are compared: equal sets of points have equal forms, whichever method listed
/// them.
namespace tetracone::verify {

using Exact_point = std::array<kernel::Rational, 3>;
using Exact_segment = std::pair<Exact_point, Exact_point>;  ///< its ends in order

/// A piece of the intersection of two faces. Its border is a point (twice), a segment, or a polygon's border as a set
/// of points: its maximal segments, sorted.
struct Contact_piece_form {
  std::uint32_t face_a, face_b;
  kernel::Piece kind;
  kernel::Feature in_a, in_b;
  std::vector<Exact_segment> border;

  friend auto operator<=>(const Contact_piece_form&, const Contact_piece_form&) = default;
};
using Contact_forms = std::vector<Contact_piece_form>;

/// Returns the maximal segments, sorted, of the union of these segments.
std::vector<Exact_segment> maximal_segments(std::vector<Exact_segment> segments);

/// Returns the form of a piece with these loops: of one or two points, or of a polygon's border.
Contact_piece_form piece_form(std::uint32_t face_a, std::uint32_t face_b, kernel::Piece kind, kernel::Feature in_a,
                              kernel::Feature in_b, const std::vector<std::vector<Exact_point>>& loops);

/// Returns the list, sorted, with the polygons of each pair of faces joined into one.
Contact_forms with_joined_polygons(const Contact_forms& forms);

/// Returns the dimension of all pieces together; -1 where there are none.
int dimension(const Contact_forms& forms);

/// Returns one line, for messages.
std::string to_string(const Contact_piece_form& form);

}  // namespace tetracone::verify

#endif
