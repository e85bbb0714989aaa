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
///  - Each coordinate is the double nearest to the file's decimal, by the standard's own conversion, or the binary
///    file's number exactly.
///  - OFF, OBJ, PLY and STL are read by `scan_off` and so on, .poly by `read_poly`.
///
/// Throws Input_error at the first thing that is wrong: no file, an unknown suffix, a word that is no number, nan,
/// infinity or overflow, an index out of range, a face of less than three corners, missing or surplus data, a count
/// that the file cannot hold, no face at all.
Polyhedron read(const std::filesystem::path& path);

/// The same, with what there is to say of it, and read a second time by CGAL's reader, which takes several times as
/// long: it must find the same vertices and faces, or else Input_error is thrown. The scan's coordinates are the ones
/// kept, also where CGAL rounds to float (a PLY text's `float`). A legal dialect that CGAL's reader does not take is
/// read by the scan alone, and so are .poly and a file of more than 100,000,000 bytes; a note says so of the others.
Read_model read_model(const std::filesystem::path& path);

}  // namespace tetracone::covering

#endif
