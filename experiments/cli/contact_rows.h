#ifndef TETRACONE_EXPERIMENTS_CLI_CONTACT_ROWS_H
#define TETRACONE_EXPERIMENTS_CLI_CONTACT_ROWS_H

#include "experiments/support/model_file.h"
#include "tetracone/tetratree/door/contacts.h"

#include <cstddef>
#include <filesystem>

namespace tetracone::experiments {

/// The format of contacts.
struct Contact_format {
  bool json = false, csv = false;  ///< neither: blanks between words, no header
  bool exact = false;              ///< fractions "n/d" instead of the nearest doubles
  bool normals = false;            ///< the unit normals of both faces behind each piece
};

/// Returns the contacts of all poses, one line per piece: `pose,face_a,face_b,kind,x0,y0,z0,x1,y1,z1`. A point is given
/// twice; a polygon, which is "coplanar", has no coordinates. Normals add `ax,ay,az,bx,by,bz`: the largest doubles not
/// above the exact ones. JSON adds the loops of all pieces, the features of either face that contain them, and the
/// doubles on both sides of each normal. Faces have their numbers in the files; equal pieces of triangles that replace
/// one face are listed once.
std::string contact_rows(const std::vector<Contacts>& contacts, const Model_file& a, const Model_file& b,
                         const Contact_format& format);

/// Pairs of faces as text, and their number.
struct Pair_rows {
  std::string text;
  std::size_t count;
};

/// Returns the pairs of faces of one model that intersect improperly: `face face kind` a line, the kind that of the
/// largest piece. JSON has an object a pair, with the pieces that they share in fractions. Faces have their numbers in
/// the file. Triangles that replace one face of the file are no pair. Requires the model's self-intersections.
Pair_rows self_intersection_rows(const Contacts& contacts, const Model_file& model, bool json);

/// Returns the curves of one pose as lines of OBJ or of PLY, by the file's suffix. Requires `is_curve_file`. Throws
/// Error for a coordinate beyond the largest double, which no model file can hold.
std::string curves_text(const std::vector<Contacts::Curve>& curves, const std::filesystem::path& file);

/// True when `curves_text` can write such a file.
bool is_curve_file(const std::filesystem::path& file);

}  // namespace tetracone::experiments

#endif
