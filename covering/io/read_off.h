#ifndef TETRACONE_COVERING_IO_READ_OFF_H
#define TETRACONE_COVERING_IO_READ_OFF_H

#include "tetracone/covering/io/read_scan.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tetracone::covering {

/// True when the line could be one more face: a count, and behind it an index below `vertices` for each corner.
inline bool is_face_line(const Text_lines& lines, std::size_t vertices)
{
  const auto corners = parse_count(lines.words()[0]);
  if (!corners || *corners == 0 || *corners > lines.words().size() - 1) return false;
  return std::all_of(lines.words().begin() + 1, lines.words().begin() + 1 + std::ptrdiff_t(*corners), [&](auto word) {
    const auto index = parse_count(word);
    return index && *index < vertices;
  });
}

/// The header of an OFF file.
struct Off_header {
  bool textures = false, colours = false, normals = false;  ///< of the vertices
  std::size_t vertices = 0, faces = 0;
  bool cgal_knows = false;  ///< as `Scan::cgal_knows`
};

/// Reads the keyword of the current line into the header. Returns the digits that stick to it. Throws Input_error.
inline std::string_view scan_off_keyword(const Text_lines& lines, Off_header& header)
{
  const std::string_view keyword = lines.words()[0];
  const auto prefix_end = keyword.find("OFF");
  if (prefix_end == std::string_view::npos)
    lines.fail(in_quotes(keyword) + " where the keyword should be",
               "expected OFF, COFF, NOFF, CNOFF or ST before one of them");
  std::string_view prefix = keyword.substr(0, prefix_end);
  const auto take = [&prefix](std::string_view word, bool& taken) {
    if (taken || !prefix.starts_with(word)) return false;
    prefix.remove_prefix(word.size());
    return taken = true;
  };
  while (take("ST", header.textures) || take("C", header.colours) || take("N", header.normals)) continue;
  if (!prefix.empty())
    lines.fail(in_quotes(keyword) + " as keyword", "expected three plain coordinates: OFF, COFF, NOFF, STOFF");
  return keyword.substr(prefix_end + 3);
}

/// Returns the header, which ends with the line of the counts. Throws Input_error.
inline Off_header scan_off_header(Text_lines& lines)
{
  Off_header header;
  lines.need_next("expected the keyword OFF");
  std::vector<std::string_view> counts = lines.words();
  if (!parse_count(counts[0])) {
    counts[0] = scan_off_keyword(lines, header);
    header.cgal_knows = !header.textures && !header.colours && counts[0].empty();
    if (counts[0].empty()) counts.erase(counts.begin());
    if (!counts.empty() && counts[0] == "BINARY") lines.fail("a binary OFF file", "expected OFF as text");
  }
  if (counts.empty()) {
    lines.need_next("expected the counts of vertices, faces and edges");
    counts = lines.words();
  }
  if (counts.size() != 2 && counts.size() != 3)
    lines.fail(std::to_string(counts.size()) + " words as counts", "expected the counts of vertices, faces and edges");
  header.vertices = lines.count_ahead(counts[0], "count of vertices", 6);  // "0 0 0" and a line's end
  header.faces = lines.count_ahead(counts[1], "count of faces", 4);        // "1 0" and a line's end
  // Nobody uses the count of edges, but CGAL reads it as an int.
  const bool is_int = counts.size() == 3 && lines.count(counts[2], "count of edges") < (1u << 30);
  header.cgal_knows = header.cgal_knows && is_int;
  return header;
}

/// Refuses a word that is no number, from word `first` on. They stand behind a `what`.
inline void need_numbers(const Text_lines& lines, std::size_t first, const char* what)
{
  for (std::size_t k = first; k < lines.words().size(); ++k)
    if (!is_number_word(lines.words()[k]))
      lines.fail(in_quotes(lines.words()[k]) + " behind a " + what, "expected a number");
}

/// Adds the vertex of the current line. Throws Input_error.
inline void add_off_vertex(const Text_lines& lines, const Off_header& header, Scan& scan)
{
  const std::size_t least = 3 + (header.normals ? 3 : 0) + (header.textures ? 2 : 0);
  if (lines.words().size() < least)
    lines.fail("a vertex of " + std::to_string(lines.words().size()) + " numbers", "expected " + std::to_string(least));
  add_vertex(lines, 0, scan.soup.vertices, scan.unplaced);
  need_numbers(lines, 3, "vertex");
  if (!std::ranges::all_of(lines.words(), [](std::string_view word) { return parse_double(word).has_value(); }))
    scan.cgal_knows = false;
}

/// Adds the face of the current line. `loop` holds its corners. Throws Input_error.
inline void add_off_face(const Text_lines& lines, std::size_t vertices, std::vector<Index>& loop, Scan& scan)
{
  const std::uint64_t corners = lines.count(0, "count of corners");
  need_corners(lines, corners, 1);
  if (corners > lines.words().size() - 1)
    lines.fail("a face of " + std::to_string(corners) + " corners with " + std::to_string(lines.words().size() - 1) +
                   " numbers",
               "expected an index for each corner");
  loop.clear();
  for (std::size_t k = 1; k <= corners; ++k) loop.push_back(vertex_index(lines, k, vertices));
  need_numbers(lines, corners + 1, "face");
  add_face(scan, loop, [&] { return at_line(lines); });
}

/// Returns what an OFF text holds, or throws Input_error. '#' starts a comment anywhere. Its parts are, in order:
///
/// - the keyword OFF, which may be absent, with ST, C and N before it in any order;
/// - the counts of vertices, faces and (optionally) edges on one line;
/// - one line for each vertex;
/// - one line for each face.
///
/// Colours, normals and texture coordinates are skipped. Lines behind the last face are left out, with a note, unless
/// one could be a face.
///
/// CGAL's reader refuses or misreads these dialects, so it confirms none (see `Scan`):
///
/// - colours and texture coordinates, since it takes as many as the header promises;
/// - a count line without edges, or with 2^30 edges or more;
/// - counts that stick to the keyword, or a file without it;
/// - numbers of vertices that are not finite;
/// - faces of one or two corners.
inline Scan scan_off(const std::string& file, std::string_view text)
{
  Text_lines lines(file, text, '#');
  const Off_header header = scan_off_header(lines);
  Scan scan;
  scan.cgal_knows = header.cgal_knows;
  scan.soup.vertices.reserve(header.vertices);
  for (std::size_t v = 0; v < header.vertices; ++v) {
    lines.need_next("vertex", v, header.vertices);
    add_off_vertex(lines, header, scan);
  }
  scan.soup.reserve_faces(header.faces, 3 * header.faces);
  std::vector<Index> loop;
  for (std::size_t f = 0; f < header.faces; ++f) {
    lines.need_next("face", f, header.faces);
    add_off_face(lines, header.vertices, loop, scan);
  }
  Left_out behind;
  for (; lines.next(); behind.add(at_line(lines)))
    if (is_face_line(lines, header.vertices))
      lines.fail("more faces than the header counts", "expected the end of the file after " +
                                                          std::to_string(header.vertices) + " vertices and " +
                                                          std::to_string(header.faces) + " faces");
  behind.note("lines behind the last face are left out", scan.notes);
  finish(scan);
  return scan;
}

}  // namespace tetracone::covering

#endif
