#ifndef TETRACONE_COVERING_IO_READ_H
#define TETRACONE_COVERING_IO_READ_H

#include "tetracone/covering/io/read_model.h"
#include "tetracone/covering/polyhedron.h"

#include <filesystem>
#include <string>

namespace tetracone::covering {

/// Returns the polyhedron with vertices of exactly equal coordinates (-0.0 equals 0.0) merged into the first of them.
/// Faces and loops stay as they are.
Polyhedron merge_equal_vertices(Polyhedron polyhedron);

/// Returns the suffix of a file's name, in small letters.
std::string suffix_of(const std::filesystem::path& path);

/// Returns a model from a file: OFF, OBJ, PLY (text and binary), STL (text and binary) or TetGen .poly, by the suffix
/// in any case of letters.
///
/// - Polygons stay polygons. Nothing is merged except an STL file's exactly equal vertices (-0.0 equals 0.0).
/// - Hole loops and facets of a .poly file may be turned (`read_poly`).
/// - Each coordinate is the double nearest to the file's decimal, by the standard's own conversion, or the binary
///   file's number exactly.
/// - The formats are described at `scan_off`, `scan_obj`, `scan_ply`, `scan_stl` and `read_poly`.
/// - Numbers that no face uses (normals, colours, points of no face) may be nan or infinite. Such a point is moved to a
///   vertex of a face; `read_with_notes` says so.
/// - Faces of one or two corners are left out; `read_with_notes` says so. (A .poly file with such a face is refused.)
/// - Bytes behind the last face of an OFF file, or the last triangle of a binary STL, are left out, too.
///
/// Throws Input_error at the first flaw:
///
/// - no file, an empty one, text in UTF-16, or an unknown suffix;
/// - an unknown keyword, or a word that is no number;
/// - nan, infinity or overflow in a face's point;
/// - an index out of range;
/// - a face of no corners, or no face at all;
/// - missing data, or more faces than the file counts;
/// - a count that the file cannot hold.
Polyhedron read(const std::filesystem::path& path);

/// Returns a model as by `read`, with notes of what was left out or is not as it is written. `Read_model` counts the
/// loops and facets that were turned.
Read_model read_with_notes(const std::filesystem::path& path);

/// Returns a model as by `read_with_notes`, and reads it a second time by CGAL's reader, which takes several times as
/// long. A note says where CGAL's reader refuses the file or finds other vertices or faces; the scan's are returned.
/// CGAL is not asked about dialects that it does not take, about .poly, and about files of more than 100,000,000 bytes.
Read_model read_model(const std::filesystem::path& path);

}  // namespace tetracone::covering

#endif
