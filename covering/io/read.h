#ifndef TETRACONE_COVERING_IO_READ_H
#define TETRACONE_COVERING_IO_READ_H

#include "tetracone/covering/io/read_model.h"
#include "tetracone/covering/polyhedron.h"

#include <filesystem>
#include <string>

namespace tetracone::covering {

/// Vertices with exactly equal coordinates (-0.0 equals 0.0) become one, the first of them; faces and loops stay as
/// they are.
Polyhedron merge_equal_vertices(Polyhedron polyhedron);

/// The suffix of a file's name, in small letters.
std::string suffix_of(const std::filesystem::path& path);

/// Reads a model: OFF, OBJ, PLY (text and binary), STL (text and binary) or TetGen .poly, by the suffix in any case of
/// letters.
///
///  - Polygons stay polygons. Nothing is merged but an STL file's exactly equal vertices (-0.0 equals 0.0).
///  - Each coordinate is the double nearest to the file's decimal, or the binary file's number exactly.
///  - OFF, OBJ, PLY and STL are scanned first (`scan_off` and so on), which finds what is wrong and where; then CGAL's
///    reader reads the file, and must find the same vertices and faces. The scan's coordinates are the ones kept: they
///    are nearest doubles by the standard's own conversion, also where CGAL rounds to float (a PLY text's `float`). A
///    legal dialect that CGAL's reader does not take is read by the scan alone, and so is a file of more than
///    100,000,000 bytes, for which CGAL would take far longer; a note says so.
///  - .poly is read by `read_poly`.
///
/// Throws Input_error at the first thing that is wrong: no file, an unknown suffix, a word that is no number, nan,
/// infinity or overflow, an index out of range, a face of less than three corners, missing or surplus data, a count
/// that the file cannot hold, no face at all.
Read_model read_model(const std::filesystem::path& path);

/// The polyhedron of `read_model`.
Polyhedron read(const std::filesystem::path& path);

}  // namespace tetracone::covering

#endif
