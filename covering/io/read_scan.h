#ifndef TETRACONE_COVERING_IO_READ_SCAN_H
#define TETRACONE_COVERING_IO_READ_SCAN_H

#include "tetracone/covering/io/text_lines.h"
#include "tetracone/covering/polyhedron.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace tetracone::covering {

using covering::in_quotes;
using covering::Input_error;
using covering::parse_count;
using covering::Text_lines;
using kernel::parse_double;

/// What a scan found in a file before CGAL reads it. The scans exist because CGAL's readers give no line numbers,
/// believe the counts of a header and skip what they do not know; they refuse with an Input_error the first thing that
/// is wrong.
struct Scan {
  Polyhedron soup;         ///< all vertices and faces in the file's order, each coordinate the nearest double
  bool cgal_knows = true;  ///< false: a legal dialect that CGAL's reader does not take, or takes for something else
  bool single_coordinates = false;  ///< CGAL rounds the coordinates to float before they become double
};

/// True for a number that a coordinate may not be, but something unused (a normal, a colour, a quality) may: nan and
/// infinity too.
inline bool is_number_word(std::string_view word)
{
  if (word.starts_with('+') || word.starts_with('-')) word.remove_prefix(1);
  double value = 0;
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, value);
  return rest == end && error != std::errc::invalid_argument && !word.starts_with('-');
}

/// Refuses a face of fewer than three corners.
inline void need_corners(const Text_lines& lines, std::uint64_t corners)
{
  if (corners < 3)
    lines.fail("a face of " + std::to_string(corners) + (corners == 1 ? " corner" : " corners"), "expected at least 3");
}

/// Word `k` of the line as a vertex number below `vertices`.
inline Index vertex_index(const Text_lines& lines, std::size_t k, std::size_t vertices)
{
  const std::uint64_t index = lines.count(k, "vertex index");
  if (index >= vertices)
    lines.fail("vertex index " + std::to_string(index) + " with " + std::to_string(vertices) + " vertices",
               vertices == 0 ? "expected vertices" : "expected 0 to " + std::to_string(vertices - 1));
  return static_cast<Index>(index);
}

}  // namespace tetracone::covering

#endif
